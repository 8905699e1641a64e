// SPDX-License-Identifier: Apache-2.0
// Reports events that arrive while an action waits (semantics 3.3, 3.10). Events do not interrupt an entry, exit or
// transition action, so the transitions of enclosing states cannot take the event before the action ends.
#include <fmt/format.h>

#include <algorithm>

#include "frontend/lint/lints.hpp"
#include "frontend/rules/rules.hpp"
#include "frontend/syntax/expression_visitor.hpp"

namespace robochart::frontend {

namespace {

/// An event that is raised in a control cycle of one time unit stays available until the end of the cycle, so a wait of
/// one unit does not lose it.
constexpr double least_that_loses = 2;

using Events = std::vector<const Declaration*>;

class MissedEvents {
public:
    MissedEvents(const Machine& machine, Diagnostics& out) : machine_(machine), out_(out) {}

    void run() { check_container(machine_, {}); }

private:
    /// Checks the nodes of a container. `around` contains the events that the enclosing states await.
    void check_container(const NodeContainer& inside, const Events& around) {
        const Graph graph(inside);
        for (const auto& transition : inside.transitions) {
            if (!transition->action || transition->target == nullptr) continue;
            check_action(*transition->action, add_awaited(around, *transition->target, graph),
                         fmt::format("the action of transition `{}`", transition->name));
        }
        for (const auto& node : inside.nodes) {
            if (node->kind != DeclKind::state) continue;
            const Events own = add_awaited(around, *node, graph);
            for (const Action& action : node->actions) {
                if (!action.statement || action.kind == ActionKind::during) continue;
                const bool entry = action.kind == ActionKind::entry;
                check_action(*action.statement, entry ? own : around,
                             fmt::format("the {} action of `{}`", entry ? "entry" : "exit", node->name));
            }
            check_container(*node, own);
        }
    }

    static Events add_awaited(Events events, const State& node, const Graph& graph) {
        for (const Transition* transition : graph.transitions_from(node)) {
            const Declaration* event = transition->trigger ? transition->trigger->event_target : nullptr;
            if (event != nullptr && std::ranges::find(events, event) == events.end()) events.push_back(event);
        }
        return events;
    }

    void check_action(const Stmt& action, const Events& awaited, const std::string& name) {
        const double time = least_time(action);
        if (time < least_that_loses) return;
        std::vector<std::string> missed;
        for (const Declaration* event : awaited)
            if (!communicates_event(action, *event)) missed.push_back(event->name);
        if (missed.empty()) return;
        out_.report(rules::w_missed, action.span, {list_names(missed), name, fmt::format("{}", time)});
    }

    static bool communicates_event(const Stmt& action, const Declaration& event) {
        bool found = false;
        walk_tree(action, [&](const Stmt& statement) {
            found = found || (statement.communication && statement.communication->event_target == &event);
        });
        return found;
    }

    const Machine& machine_;
    Diagnostics& out_;
};

}  // namespace

void lint_missed(const Machine& machine, Diagnostics& out) {
    MissedEvents(machine, out).run();
}

}  // namespace robochart::frontend
