// SPDX-License-Identifier: Apache-2.0
// Finds cycles of transitions that need no event and no time (semantics 3.4, 3.10). Such transitions are urgent, so a
// machine that can stay in the cycle stays in it, and time stops. A cycle is reported only if three conditions are met.
// (1) No action on it waits, calls or communicates. (2) Its guards can be true together. (3) Neither its own actions
// nor a concurrent during action changes a variable or clock in its guards.
#include <algorithm>
#include <deque>
#include <set>

#include "frontend/lint/lint_logic.hpp"
#include "frontend/lint/lints.hpp"
#include "frontend/names/scopes.hpp"
#include "frontend/rules/rules.hpp"
#include "frontend/syntax/expression_visitor.hpp"

namespace robochart::frontend {

namespace {

bool is_instant(const Effects& effects) {
    return !effects.calls && !effects.communicates && !effects.waits;
}

class Loops {
public:
    Loops(const NodeContainer& container, const Never& never, const std::unordered_set<const Declaration*>& shared)
        : shared_(shared) {
        for (const auto& node : container.nodes) add_effects(*node, false, of_node_[node.get()]);
        for (const auto& transition : container.transitions)
            if (transition->source != nullptr && transition->target != nullptr && !never.contains(transition.get()) &&
                is_instant(*transition))
                out_[transition->source].push_back(transition.get());
        for (const auto& node : container.nodes) nodes_.push_back(node.get());
    }

    void check(Diagnostics& out) {
        for (const State* node : nodes_) {
            if (reported_.contains(node)) continue;
            const std::vector<const Transition*> cycle = shortest_cycle(*node);
            if (!cycle.empty() && goes_on(cycle)) report(cycle, out);
        }
    }

private:
    [[nodiscard]] bool is_instant(const Transition& transition) const {
        if (transition.trigger || transition.probability || transition.otherwise) return false;
        Effects effects;
        if (transition.action) add_effects(*transition.action, effects);
        return frontend::is_instant(effects) && frontend::is_instant(of_node_.at(transition.source)) &&
               frontend::is_instant(of_node_.at(transition.target));
    }

    /// Searches breadth-first from the node back to itself, over a bounded number of transitions.
    [[nodiscard]] std::vector<const Transition*> shortest_cycle(const State& start) const {
        constexpr std::size_t max_looked_at = 64;
        std::unordered_map<const State*, const Transition*> reached_by;
        std::deque<const State*> open{&start};
        std::size_t looked_at = 0;
        while (!open.empty()) {
            const State* node = open.front();
            open.pop_front();
            const auto ways = out_.find(node);
            if (ways == out_.end()) continue;
            for (const Transition* way : ways->second) {
                if (++looked_at > max_looked_at) return {};
                if (way->target == &start) return path_of_cycle(start, *way, reached_by);
                if (reached_by.emplace(way->target, way).second) open.push_back(way->target);
            }
        }
        return {};
    }

    static std::vector<const Transition*> path_of_cycle(
        const State& start, const Transition& last,
        const std::unordered_map<const State*, const Transition*>& reached_by) {
        std::vector<const Transition*> cycle{&last};
        while (cycle.back()->source != &start) cycle.push_back(reached_by.at(cycle.back()->source));
        std::ranges::reverse(cycle);
        return cycle;
    }

    /// Returns the variables, clocks and states that may change while the machine runs through the cycle. Entering a
    /// state resets its `sinceEntry`.
    [[nodiscard]] std::unordered_set<const Declaration*> changed_by(const std::vector<const Transition*>& cycle) const {
        Effects effects;
        for (const Transition* way : cycle) {
            add_effects(*way->target, true, effects);
            effects.writes.insert(way->target);
            if (way->action) add_effects(*way->action, effects);
            for (const auto& reset : way->resets) effects.writes.insert(reset.clock);
        }
        effects.writes.insert(shared_.begin(), shared_.end());
        return std::move(effects.writes);
    }

    [[nodiscard]] bool goes_on(const std::vector<const Transition*>& cycle) const {
        const auto changed = changed_by(cycle);
        logic::Reasoner reasoner(true);
        std::vector<logic::Formula> guards;
        for (const Transition* way : cycle) {
            if (!way->condition) continue;
            if (mentions_any(*way->condition, changed)) return false;
            guards.push_back(reasoner.read(*way->condition));
        }
        const logic::Finding together = reasoner.decide(logic::all_of(std::move(guards)));
        return together.answer == logic::Answer::possible && together.trusted;
    }

    void report(const std::vector<const Transition*>& cycle, Diagnostics& out) {
        std::vector<std::string> names;
        for (const Transition* way : cycle) {
            names.push_back(way->name);
            reported_.insert(way->source);
        }
        const std::string text = (names.size() == 1 ? "transition " : "transitions ") + list_names(names);
        auto& finding = out.report(rules::w_loop, cycle.front()->name_span, {text, names.size() == 1 ? "s" : ""});
        for (std::size_t i = 1; i < cycle.size(); ++i)
            finding.notes.push_back(
                {cycle[i]->name_span, i + 1 == cycle.size() ? "back by this transition" : "on by this"});
    }

    const std::unordered_set<const Declaration*>& shared_;
    std::unordered_map<const State*, Effects> of_node_;
    std::unordered_map<const State*, std::vector<const Transition*>> out_;
    std::vector<const State*> nodes_;
    std::unordered_set<const State*> reported_;
};

/// Checks a container and the states inside it. The during actions of a state may write at any time while the machine
/// is inside the state.
void check(const NodeContainer& container, const Never& never, std::unordered_set<const Declaration*>& shared,
           Diagnostics& out) {
    Loops(container, never, shared).check(out);
    for (const auto& node : container.nodes) {
        if (node->nodes.empty()) continue;
        Effects beside;
        for (const Action& action : node->actions)
            if (action.kind == ActionKind::during && action.statement) add_effects(*action.statement, beside);
        std::unordered_set<const Declaration*> inner = shared;
        inner.insert(beside.writes.begin(), beside.writes.end());
        check(*node, never, inner, out);
    }
}

}  // namespace

void lint_loops(const Machine& machine, const Never& never, Diagnostics& out) {
    std::unordered_set<const Declaration*> shared;
    for (const Variable* variable : required_variables(machine))
        if (variable->kind == DeclKind::variable) shared.insert(variable);
    check(machine, never, shared, out);
}

}  // namespace robochart::frontend
