// SPDX-License-Identifier: Apache-2.0
#include "checker/refine/verdict/recurrence.hpp"

#include <algorithm>
#include <cassert>
#include <stdexcept>

#include "checker/lts/graph.hpp"
#include "checker/refine/search/steps.hpp"
#include "checker/refine/verdict/counterexample.hpp"
#include "checker/refine/verdict/question.hpp"
#include "checker/refine/verdict/reduction.hpp"

namespace robochart::refine {
namespace {

using lts::StateIndex;

bool is_in_goal(const process::EventSet& goal, process::Event event) {
    return std::ranges::binary_search(goal, event);
}

/// Finds, for each state, the sources of the transitions into it.
class Backwards {
public:
    explicit Backwards(const lts::Graph& graph) : first_(graph.size() + 1), sources_(graph.edge_count()) {
        const auto states = static_cast<StateIndex>(graph.size());
        for (StateIndex state = 0; state < states; ++state)
            for (const lts::Edge& edge : graph.edges(state)) ++first_[edge.target + 1U];
        for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
        assert(first_.back() == sources_.size());
        std::vector<std::uint64_t> next(first_.begin(), first_.end() - 1);
        for (StateIndex state = 0; state < states; ++state)
            for (const lts::Edge& edge : graph.edges(state)) sources_[next[edge.target]++] = state;
    }
    [[nodiscard]] std::span<const StateIndex> sources_of(StateIndex state) const {
        return std::span(sources_).subspan(first_[state], first_[state + 1U] - first_[state]);
    }

private:
    std::vector<std::uint64_t> first_;
    std::vector<StateIndex> sources_;
};

/// Returns, for each state, whether some run from it contains an event of the goal.
std::vector<bool> leading_to(const lts::Graph& graph, const process::EventSet& goal, Budget& budget) {
    std::vector<bool> marked(graph.size());
    std::vector<StateIndex> waiting;
    for (StateIndex state = 0; state < graph.size(); ++state)
        for (const lts::Edge& edge : graph.edges(state))
            if (!marked[state] && is_in_goal(goal, edge.event)) {
                marked[state] = true;
                waiting.push_back(state);
            }
    const Backwards backwards(graph);
    while (!waiting.empty()) {
        budget.charge();
        const StateIndex state = waiting.back();
        waiting.pop_back();
        for (const StateIndex source : backwards.sources_of(state)) {
            if (marked[source]) continue;
            marked[source] = true;
            waiting.push_back(source);
        }
    }
    return marked;
}

/// Returns the states of a shortest run to this state, without the initial state. States are numbered in breadth-first
/// order, so the first predecessor found is on a shortest run.
std::vector<StateIndex> way_to(const lts::Graph& graph, StateIndex last) {
    std::vector<StateIndex> parent(graph.size());
    std::vector<bool> known(graph.size());
    known[0] = true;
    for (StateIndex state = 0; state < graph.size(); ++state)
        for (const lts::Edge& edge : graph.edges(state)) {
            if (known[edge.target]) continue;
            known[edge.target] = true;
            parent[edge.target] = state;
        }
    std::vector<StateIndex> way;
    for (; last != 0; last = parent[last]) {
        assert(parent[last] < last);
        way.push_back(last);
    }
    std::ranges::reverse(way);
    return way;
}

Run run_along(lts::TransitionSystem& system, const lts::Exploration& all, const std::vector<StateIndex>& way) {
    const auto words = [&](StateIndex state) {
        const lts::StateView view = all.states[state];
        return std::vector<lts::Word>(view.begin(), view.end());
    };
    Run run{words(0), {}};
    for (const StateIndex state : way) {
        const std::vector<lts::Word> target = words(state);
        std::vector<RunStep> steps = steps_from(system, run.last_state());
        const auto step =
            std::ranges::find_if(steps, [&](const RunStep& candidate) { return candidate.state == target; });
        if (step == steps.end()) throw std::logic_error("a transition that was explored cannot be taken again");
        run.steps.push_back(std::move(*step));
    }
    return run;
}

std::optional<Violation> explore_backwards(lts::TransitionSystem& system, const process::EventSet& goal, Budget& budget,
                                           Statistics& statistics) {
    std::uint64_t known = 0;
    budget.report_by([&known](Progress& progress) { progress.states = known; });
    const lts::Exploration all = lts::explore(system, [&](std::size_t states) {
        known = states;
        budget.states(states);
        budget.charge();
    });
    budget.report_by({});
    statistics.states += all.graph.size();
    statistics.transitions += all.graph.edge_count();
    statistics.chased += system.chased_state_count();
    const std::vector<bool> marked = leading_to(all.graph, goal, budget);
    const auto lost = std::ranges::find(marked, false);
    if (lost == marked.end()) return std::nullopt;
    const std::vector<StateIndex> way = way_to(all.graph, static_cast<StateIndex>(lost - marked.begin()));
    return Violation{ViolationKind::no_return, run_along(system, all, way), {}, {}};
}

/// Confirms in the whole system that no run from the end of the violation contains an event of the goal. It checks only
/// a limited number of states after the violation.
void confirm_no_return(lts::TransitionSystem& system, const process::EventSet& goal, const Violation& violation,
                       Budget& budget) {
    constexpr StateIndex most = 100'000;
    lts::StateStore found(system.width());
    (void)found.insert(violation.run.last_state());
    for (StateIndex state = 0; state < found.size() && state < most; ++state) {
        const lts::StateView view = found[state];
        const std::vector<lts::Word> words(view.begin(), view.end());
        for (const RunStep& step : steps_from(system, words, budget)) {
            if (is_in_goal(goal, step.event)) throw std::logic_error("what can never happen again can happen");
            (void)found.insert(step.state);
        }
    }
}

}  // namespace

Verdict recurrent(lts::TransitionSystem& system, const process::EventSet& goal, const Limits& limits) {
    return decide({&system}, limits, [&](Budget& budget, Verdict& verdict) {
        const SearchQuestion question{[&](lts::TransitionSystem& searched, Budget& own, Statistics& size,
                                          const Violation*) { return explore_backwards(searched, goal, own, size); },
                                      [&](const lts::EventPermutation& exchange) {
                                          return std::ranges::all_of(exchange, [&](const auto& pair) {
                                              return is_in_goal(goal, pair.first) == is_in_goal(goal, pair.second);
                                          });
                                      },
                                      false};
        const std::optional<Violation> violation = search_reduced(system, budget, verdict.statistics, question);
        verdict.outcome = violation ? Outcome::fails : Outcome::holds;
        if (!violation) return;
        confirm_no_return(system, goal, *violation, budget);
        verdict.counterexample = make_counterexample({*violation, &system, false});
    });
}

}  // namespace robochart::refine
