// SPDX-License-Identifier: Apache-2.0
// See exploration.hpp.
#include "prism/assertions/process/exploration.hpp"

#include <fmt/format.h>

#include "base/diagnostics/budget.hpp"
#include "checker/lts/bisimulation.hpp"

namespace robochart::probability {

class Exploration::Sink final : public lts::SuccessorSink {
public:
    explicit Sink(Exploration& of) : of_(of) {}
    void add(lts::Event event, lts::StateView target, lts::Event revealed) override {
        of_.steps_.push_back({event, revealed, of_.states_.insert(target).index});
    }

private:
    Exploration& of_;
};

Exploration::Exploration(lts::TransitionSystem& system, std::uint64_t most_states, diagnostics::Pollable& budget)
    : states_(system.width()) {
    std::vector<lts::Word> initial(system.width());
    system.initial(initial);
    states_.insert(initial);
    Sink sink(*this);
    for (lts::StateIndex state = 0; state < states_.size(); ++state) {
        budget.poll();
        if (states_.size() > most_states)
            throw diagnostics::LimitReached(fmt::format("the process has more than {} states", most_states));
        system.successors(states_[state], sink);
        first_.push_back(steps_.size());
    }
}

bool are_bisimilar(const Exploration& explored, lts::EventTable& events, lts::TransitionSystem& other,
                   diagnostics::Pollable& budget) {
    const lts::Exploration second = lts::explore(other, [&](std::size_t) { budget.poll(); });
    // Both systems are put into one graph. Its initial state has one step to each of them, with different events.
    const auto first_of_second = static_cast<lts::StateIndex>(1 + explored.size());
    lts::Graph graph;
    graph.add_edge({lts::tick, 1});
    graph.add_edge({events.intern("the other process"), first_of_second});
    graph.finish_state();
    for (lts::StateIndex state = 0; state < explored.size(); ++state) {
        for (const Step& step : explored.steps_from(state))
            graph.add_edge({step.event, static_cast<lts::StateIndex>(1 + step.target)});
        graph.finish_state();
    }
    for (lts::StateIndex state = 0; state < second.graph.size(); ++state) {
        for (const lts::Edge& edge : second.graph.edges(state)) {
            const bool named = edge.event >= lts::first_visible;
            graph.add_edge({named ? events.intern(other.events().name(edge.event)) : edge.event,
                            static_cast<lts::StateIndex>(first_of_second + edge.target)});
        }
        graph.finish_state();
    }
    const lts::Quotient quotient = lts::minimise(graph, lts::Equivalence::branching_with_divergence, budget);
    return quotient.state_of[1] == quotient.state_of[first_of_second];
}

}  // namespace robochart::probability
