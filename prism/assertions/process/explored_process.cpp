// SPDX-License-Identifier: Apache-2.0
// See explored_process.hpp.
#include "prism/assertions/process/explored_process.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "counterexample/evaluation_failure.hpp"
#include "csp_emit/emit.hpp"
#include "prism/assertions/experiments/encoding.hpp"
#include "semantics/ir/query.hpp"

namespace robochart::probability {
namespace {

const cspm::ExprPtr& component_process(const csp_emit::Emission& emission, const std::string& path) {
    const auto found = std::ranges::find_if(
        emission.components, [&](const csp_emit::ComponentProcesses& component) { return component.path == path; });
    if (found == emission.components.end()) throw Wrong(fmt::format("{} has no separate process", path));
    return found->process;
}

/// Emits the timed semantics. Throws Wrong if there is none.
csp_emit::Emission emit_timed(const ir::System& system, const ir::Instantiation& instantiation, bool whole_states,
                              bool share_modules, diagnostics::SourceManager& sources, diagnostics::Budget* budget) {
    diagnostics::Diagnostics findings;
    if (budget != nullptr) findings.set_budget(budget);
    csp_emit::Options options;
    options.whole_states = whole_states;
    options.share_modules = share_modules;
    csp_emit::Emission result =
        csp_emit::emit(system, instantiation, csp_emit::Time::timed, options, sources, findings);
    for (const diagnostics::Diagnostic& finding : findings.sorted_findings())
        if (finding.rule->severity == diagnostics::Severity::error) throw Wrong(finding.message());
    return result;
}

refine::Limits limits_of(const diagnostics::Budget* budget) {
    refine::Limits limits;
    if (budget != nullptr) static_cast<diagnostics::Limits&>(limits) = budget->limits();
    return limits;
}

/// Checks that the explored process is branching bisimilar to the process that assertions are checked with.
void check_bisimilar(ExploredProcess& made, const ir::System& system, const std::string& subject,
                     diagnostics::SourceManager& sources, diagnostics::Budget* budget) {
    const csp_emit::Emission usual = emit_timed(system, made.instantiation, false, true, sources, budget);
    cspm::Session session(usual.script, budget);
    const auto other = session.system(component_process(usual, subject), limits_of(budget));
    if (!are_bisimilar(*made.exploration, made.session->event_table(), *other, diagnostics::or_unlimited(budget)))
        throw std::logic_error(
            fmt::format("the states of {} with all values are not bisimilar to its process", subject));
    made.compared = made.exploration->size();
}

}  // namespace

std::unique_ptr<ExploredProcess> explore_process(const ir::System& system, const ir::ComponentRef& subject,
                                                 ir::Instantiation instantiation,
                                                 const std::vector<ObservedEvent>& observed,
                                                 diagnostics::SourceManager& sources, const ExploreLimits& limits) {
    auto made = std::make_unique<ExploredProcess>();
    made->instantiation = std::move(instantiation);
    made->instantiation.budget = limits.budget;
    const std::string path = ir::qualified_name(subject);
    made->emission = emit_timed(system, made->instantiation, true, observed.empty(), sources, limits.budget);
    add_observers(made->emission, observed);
    try {
        made->session = std::make_unique<cspm::Session>(made->emission.script, limits.budget, true);
        if (limits.on_session) limits.on_session(made->emission, made->instantiation, *made->session);
        made->system = made->session->whole_system(component_process(made->emission, path), limits_of(limits.budget));
        made->exploration =
            std::make_unique<Exploration>(*made->system, limits.most_states, diagnostics::or_unlimited(limits.budget));
    } catch (const cspm::EvaluationError& error) {
        throw Wrong(runs::placed_failure(error, system, sources));
    }
    made->context.reset(
        new runs::Context{made->emission.provenance, system, made->instantiation, sources, *made->session});
    made->steps = std::make_unique<runs::StepReader>(*made->context);
    made->reader = std::make_unique<StateReader>(*made->system, *made->steps);
    if (made->exploration->size() <= limits.compared_states)
        check_bisimilar(*made, system, path, sources, limits.budget);
    return made;
}

}  // namespace robochart::probability
