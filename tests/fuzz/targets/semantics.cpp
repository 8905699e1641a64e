// SPDX-License-Identifier: Apache-2.0
// Tests the components after the front end with any input. A model without errors is lowered, instantiated, written as
// CSP in both times and type checked. Its obligations and core properties are decided with small limits, and its
// components are generated as C++.
#include <algorithm>
#include <chrono>
#include <exception>
#include <new>

#include "base/diagnostics/budget.hpp"
#include "checker/cspm/session.hpp"
#include "checker/cspm/types/type_check.hpp"
#include "cpp_emit/emit.hpp"
#include "csp_emit/emit.hpp"
#include "frontend/project/project.hpp"
#include "frontend/syntax/parse.hpp"
#include "frontend/toolkits/toolkits.hpp"
#include "semantics/instantiate/instantiate.hpp"
#include "semantics/lower/lower.hpp"
#include "tests/conformance/batches/batch.hpp"
#include "tests/fuzz/targets/findings.hpp"
#include "tests/fuzz/targets/targets.hpp"

namespace robochart::fuzz {

namespace {

using diagnostics::Diagnostics;
using diagnostics::SourceManager;

refine::Limits small_limits() {
    refine::Limits limits;
    limits.max_states = 300;
    limits.deadline = std::chrono::steady_clock::now() + std::chrono::milliseconds(300);
    return limits;
}

/// Runs the phases in order, until one rejects the model.
class Phases {
public:
    /// Returns the first violated property, or "" if there is none.
    std::string run(std::string_view bytes) {
        findings_.set_budget(&budget_);
        read(bytes);
        frontend::add_toolkits(sources_, model_, findings_);
        frontend::resolve(model_, findings_);
        if (!findings_.ok()) return refusal();
        const ir::System system = ir::lower(model_, sources_, findings_);
        if (!findings_.ok()) return refusal();
        const ir::Instantiation instantiation = ir::instantiate_system(system, {}, findings_);
        if (!findings_.ok()) return refusal();
        std::string complaint = script(system, instantiation, csp_emit::Time::untimed);
        if (complaint.empty()) complaint = script(system, instantiation, csp_emit::Time::timed);
        if (complaint.empty()) complaint = code(system, instantiation);
        return complaint.empty() ? check_findings(sources_, findings_) : complaint;
    }

private:
    /// Reads the files, which are separated by form feeds. Assertion files start with `!`.
    void read(std::string_view bytes) {
        for (std::size_t begin = 0, file = 0; begin <= bytes.size(); ++file) {
            const std::size_t end = std::min(bytes.find('\f', begin), bytes.size());
            std::string_view text = bytes.substr(begin, end - begin);
            const bool assertions = text.starts_with('!');
            if (assertions) text.remove_prefix(1);
            const auto id =
                sources_.add("f" + std::to_string(file) + (assertions ? ".assertions" : ".rct"), std::string(text));
            model_.files.push_back(frontend::parse(sources_, id, assertions, findings_));
            begin = end + 1;
        }
    }

    /// Checks that a rejection names its rule.
    std::string refusal() {
        if (findings_.error_count() == 0) return "a model is refused and no error says why";
        return check_findings(sources_, findings_);
    }

    std::string script(const ir::System& system, const ir::Instantiation& instantiation, csp_emit::Time time) {
        Diagnostics found;
        found.set_budget(&budget_);
        const csp_emit::Emission emission = csp_emit::emit(system, instantiation, time, {true}, sources_, found);
        if (!found.ok()) return check_findings(sources_, found);
        Diagnostics types;
        cspm::check_types(emission.script, types);
        if (!types.ok() && system.csp_blocks.empty())
            return "a script of ours is refused by the type checker:\n" + diagnostics_of(types);
        return types.ok() ? decide(emission) : "";
    }

    [[nodiscard]] static std::string diagnostics_of(const Diagnostics& types) {
        std::string text;
        for (const auto& finding : types.sorted_findings()) text += finding.message() + "\n";
        return text;
    }

    /// Decides the obligations. Every answer is acceptable, including an evaluation error of the script.
    static std::string decide(const csp_emit::Emission& emission) {
        constexpr std::size_t most = 12;
        std::size_t decided = 0;
        try {
            cspm::Session session(emission.script);
            for (const csp_emit::Obligation& obligation : emission.obligations)
                for (const cspm::DeclPtr& assertion : obligation.assertions) {
                    if (++decided > most) return {};
                    (void)session.check(*assertion, small_limits());
                }
        } catch (const cspm::EvaluationError& error) {
            return std::string(error.what()).empty() ? "an evaluation error says nothing" : "";
        }
        return {};
    }

    std::string code(const ir::System& system, const ir::Instantiation& instantiation) {
        std::vector<ir::ComponentRef> components;
        const auto add = [&](const auto& items, ir::ComponentKind kind) {
            for (std::uint32_t i = 0; i < items.size(); ++i)
                components.push_back({kind, items[i].name, items[i].package, i});
        };
        add(system.modules, ir::ComponentKind::module);
        add(system.controllers, ir::ComponentKind::controller);
        for (std::uint32_t i = 0; i < system.machines.size(); ++i)
            if (system.machines[i].kind == ir::MachineKind::state_machine)
                components.push_back(
                    {ir::ComponentKind::machine, system.machines[i].name, system.machines[i].package, i});
        const conformance::Options options;
        for (const ir::ComponentRef& component : components) {
            Diagnostics found;
            found.set_budget(&budget_);
            const auto candidate = conformance::candidate(system, instantiation, component, options, sources_, found);
            if (!candidate && found.error_count() == 0) return component.path + " has no code, and no error says why";
            if (const std::string complaint = check_findings(sources_, found); !complaint.empty()) return complaint;
        }
        return {};
    }

    diagnostics::Budget budget_{{2ULL << 30U, std::chrono::steady_clock::now() + std::chrono::seconds(10), {}},
                                "fuzzing"};
    SourceManager sources_;
    Diagnostics findings_;
    frontend::Model model_;
};

}  // namespace

std::string run_semantics(std::string_view bytes) {
    try {
        return Phases().run(bytes);
    } catch (const std::bad_alloc&) {
        return {};
    } catch (const diagnostics::LimitReached&) {
        return {};
    } catch (const std::exception& error) {
        return std::string("internal error: ") + error.what();
    }
}

}  // namespace robochart::fuzz
