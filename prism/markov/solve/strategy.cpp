// SPDX-License-Identifier: Apache-2.0
#include "prism/markov/solve/strategy.hpp"

#include <algorithm>

namespace robochart::markov {
namespace {

template <class Visit>
void for_each_choice_of(const Model& model, const StateSet& set, Visit visit) {
    for (State state = 0; state < model.states(); ++state)
        if (set[state])
            for (std::uint32_t choice = model.first_choice[state]; choice < model.first_choice[state + 1]; ++choice)
                visit(state, choice);
}

}  // namespace

std::vector<bool> choices_within(const Model& model, const StateSet& set) {
    std::vector<bool> choices(model.choices(), false);
    for_each_choice_of(model, set, [&](State, std::uint32_t choice) {
        choices[choice] = std::ranges::all_of(targets(model, choice), [&](State target) { return set[target]; });
    });
    return choices;
}

/// Searches breadth-first, backwards from the state to which the choice belongs.
void lead_to(const Graph& graph, const EndComponent& component, std::uint32_t choice,
             std::vector<std::uint32_t>& strategy) {
    std::vector<bool> reached(component.states.size(), false);
    std::vector<State> queue;
    const auto reach = [&](State state, std::uint32_t by) {
        const auto at = std::ranges::lower_bound(component.states, state) - component.states.begin();
        if (reached[static_cast<std::size_t>(at)]) return;
        reached[static_cast<std::size_t>(at)] = true;
        strategy[state] = by;
        queue.push_back(state);
    };
    reach(graph.source(choice), choice);
    for (std::size_t next = 0; next < queue.size(); ++next)
        for (const std::uint32_t before : graph.choices_to(queue[next]))
            if (std::ranges::binary_search(component.choices, before)) reach(graph.source(before), before);
}

GraphStrategy::GraphStrategy(const Graph& graph, const Precision& precision, std::vector<std::uint32_t>& strategy)
    : graph_(graph), requested_(precision.strategy), strategy_(strategy) {
    if (requested_) strategy_.assign(graph.model().first_choice.begin(), graph.model().first_choice.end() - 1);
}

void GraphStrategy::stay_in_set(const StateSet& set) {
    if (!requested_) return;
    const std::vector<bool> staying = choices_within(graph_.model(), set);
    for_each_choice_of(graph_.model(), set, [&](State state, std::uint32_t choice) {
        if (staying[choice]) strategy_[state] = choice;
    });
}

void GraphStrategy::may_reach(const StateSet& goal, const StateSet& set) {
    if (requested_) go_back(goal, set, std::vector<bool>(graph_.model().choices(), true));
}

void GraphStrategy::reach_goal(const StateSet& goal, const StateSet& set, const std::vector<bool>& admitted) {
    if (!requested_) return;
    std::vector<bool> staying = choices_within(graph_.model(), set);
    for (std::size_t choice = 0; choice < staying.size(); ++choice)
        staying[choice] = staying[choice] && admitted[choice];
    go_back(goal, set, staying);
}

/// Searches breadth-first, backwards from the goal.
void GraphStrategy::go_back(const StateSet& goal, const StateSet& set, const std::vector<bool>& admitted) {
    StateSet reached = goal;
    std::vector<State> queue;
    for (State state = 0; state < goal.size(); ++state)
        if (goal[state]) queue.push_back(state);
    for (std::size_t next = 0; next < queue.size(); ++next)
        for (const std::uint32_t choice : graph_.choices_to(queue[next])) {
            const State state = graph_.source(choice);
            if (reached[state] || !set[state] || !admitted[choice]) continue;
            reached[state] = true;
            strategy_[state] = choice;
            queue.push_back(state);
        }
}

void GraphStrategy::repeat_choice(const EndComponent& component, std::uint32_t choice) {
    if (requested_) lead_to(graph_, component, choice, strategy_);
}

}  // namespace robochart::markov
