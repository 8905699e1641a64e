// SPDX-License-Identifier: Apache-2.0
// See compose.hpp.
#include "prism/checks/compose.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "prism/checks/rules.hpp"

namespace robochart::prism {
namespace {

/// A part of the composition: the actions on which others can synchronise with it, and its synchronisations.
struct Part {
    std::set<std::string> alphabet;
    std::vector<Synchronisation> acts;
};

class Composer {
public:
    Composer(const std::vector<Module>& modules, diagnostics::Diagnostics& diagnostics)
        : modules_(modules), uses_(modules.size()), diagnostics_(diagnostics) {}

    Part leaf(std::size_t module) {
        Part part;
        ++uses_[module];
        bool silent = false;
        for (const Command& command : modules_[module].commands) {
            if (command.action.text.empty())
                silent = true;
            else
                part.alphabet.insert(command.action.text);
        }
        if (silent) part.acts.push_back({"", {{module, ""}}});
        for (const std::string& action : part.alphabet) part.acts.push_back({action, {{module, action}}});
        return part;
    }

    Part compose_system(const Composition& system) {
        diagnostics_.poll();
        using Kind = Composition::Kind;
        switch (system.kind) {
            case Kind::module:
                return module_part(system.module);
            case Kind::hide:
                return hide_actions(compose_system(*system.parts[0]), system.actions);
            case Kind::rename:
                return rename_actions(compose_system(*system.parts[0]), system.renamings);
            case Kind::common:
            case Kind::interleaved:
            case Kind::on_actions:
                break;
        }
        Part left = compose_system(*system.parts[0]);
        Part right = compose_system(*system.parts[1]);
        std::set<std::string> together;
        if (system.kind == Kind::common) together = common_actions(left, right);
        for (const Name& action : system.actions) together.insert(action.text);
        return compose_parallel(left, right, together);
    }

    static std::set<std::string> common_actions(const Part& left, const Part& right) {
        std::set<std::string> result;
        std::ranges::set_intersection(left.alphabet, right.alphabet, std::inserter(result, result.end()));
        return result;
    }

    Part compose_parallel(const Part& left, const Part& right, const std::set<std::string>& together) {
        Part result;
        result.alphabet = left.alphabet;
        result.alphabet.insert(right.alphabet.begin(), right.alphabet.end());
        for (const Part* side : {&left, &right})
            for (const Synchronisation& act : side->acts)
                if (!together.contains(act.action)) result.acts.push_back(act);
        for (const Synchronisation& one : left.acts) {
            if (!together.contains(one.action)) continue;
            for (const Synchronisation& other : right.acts) {
                if (other.action != one.action) continue;
                diagnostics_.poll();
                Synchronisation& both = result.acts.emplace_back(one);
                both.parts.insert(both.parts.end(), other.parts.begin(), other.parts.end());
            }
        }
        return result;
    }

    void report_missing(Span span) {
        for (std::size_t i = 0; i < modules_.size(); ++i)
            if (uses_[i] != 1)
                diagnostics_.report(rules::bad_composition, uses_[i] == 0 ? modules_[i].name.span : span,
                                    {modules_[i].name.text, uses_[i] == 0 ? "nowhere" : "twice"});
    }

private:
    Part module_part(const Name& name) {
        for (std::size_t i = 0; i < modules_.size(); ++i)
            if (modules_[i].name.text == name.text) return leaf(i);
        diagnostics_.report(rules::not_declared, name.span, {"module", name.text});
        return {};
    }

    static Part hide_actions(Part part, const std::vector<Name>& actions) {
        for (const Name& action : actions) {
            part.alphabet.erase(action.text);
            for (Synchronisation& act : part.acts)
                if (act.action == action.text) act.action.clear();
        }
        return part;
    }

    static Part rename_actions(Part part, const std::vector<Renaming>& renamings) {
        const auto renamed_action = [&](const std::string& action) {
            for (const Renaming& renaming : renamings)
                if (renaming.from.text == action) return renaming.to.text;
            return action;
        };
        for (Synchronisation& act : part.acts)
            if (!act.action.empty()) act.action = renamed_action(act.action);
        std::set<std::string> alphabet;
        for (const std::string& action : part.alphabet) alphabet.insert(renamed_action(action));
        part.alphabet = std::move(alphabet);
        return part;
    }

    const std::vector<Module>& modules_;
    std::vector<std::size_t> uses_;
    diagnostics::Diagnostics& diagnostics_;
};

Span span_of(const Composition& system) {
    return system.parts.empty() ? system.module.span : span_of(*system.parts[0]);
}

}  // namespace

std::vector<Synchronisation> compose(const std::vector<Module>& modules, const CompositionPtr& system,
                                     diagnostics::Diagnostics& diagnostics) {
    Composer composer(modules, diagnostics);
    if (system) {
        Part whole = composer.compose_system(*system);
        composer.report_missing(span_of(*system));
        return std::move(whole.acts);
    }
    Part whole;
    for (std::size_t i = 0; i < modules.size(); ++i) {
        const Part next = composer.leaf(i);
        whole = composer.compose_parallel(whole, next, Composer::common_actions(whole, next));
    }
    return std::move(whole.acts);
}

}  // namespace robochart::prism
