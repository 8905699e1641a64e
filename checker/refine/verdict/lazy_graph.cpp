// SPDX-License-Identifier: Apache-2.0
#include "checker/refine/verdict/lazy_graph.hpp"

#include <algorithm>
#include <cassert>

namespace robochart::refine {

using lts::StateIndex;
using process::Event;

class LazyGraph::Collector final : public lts::SuccessorSink {
public:
    explicit Collector(LazyGraph& graph) : graph_(graph) {}
    void add(Event event, lts::StateView target, Event /*revealed*/) override {
        graph_.edges_.push_back({event, graph_.states_.insert(target).index});
    }

private:
    LazyGraph& graph_;
};

LazyGraph::LazyGraph(lts::TransitionSystem& system, Budget& budget)
    : system_(system), budget_(budget), states_(system.width()) {}

StateIndex LazyGraph::initial() {
    std::vector<lts::Word> state(system_.width());
    system_.initial(state);
    return number_state(state);
}

StateIndex LazyGraph::number_state(lts::StateView state) {
    const StateIndex index = states_.insert(state).index;
    extents_.resize(states_.size());
    return index;
}

std::vector<StateIndex> LazyGraph::choice_operands(StateIndex state) {
    std::vector<StateIndex> operands;
    for (const std::vector<lts::Word>& operand : system_.choice_operands(states_[state]))
        operands.push_back(number_state(operand));
    return operands;
}

void LazyGraph::expand(StateIndex state) {
    assert(state < extents_.size() && !extents_[state].expanded);
    budget_.charge();
    const std::size_t first = edges_.size();
    Collector collector(*this);
    try {
        system_.successors(states_[state], collector);
    } catch (...) {
        edges_.resize(first);
        throw;
    }
    budget_.states(states_.size());
    std::stable_sort(edges_.begin() + static_cast<std::ptrdiff_t>(first), edges_.end(),
                     [](const Edge& a, const Edge& b) { return a.event < b.event; });
    extents_.resize(states_.size());
    extents_[state] = {first, static_cast<std::uint32_t>(edges_.size() - first), true};
}

std::span<const LazyGraph::Edge> LazyGraph::edges(StateIndex state) {
    if (!extents_[state].expanded) expand(state);
    const Extent& extent = extents_[state];
    return std::span<const Edge>(edges_).subspan(extent.first, extent.count);
}

std::span<const LazyGraph::Edge> LazyGraph::edges(StateIndex state, Event event) {
    const std::span<const Edge> all = edges(state);
    const auto first = std::ranges::lower_bound(all, event, {}, &Edge::event);
    const auto last = std::find_if(first, all.end(), [event](const Edge& e) { return e.event != event; });
    return {first, last};
}

Offer LazyGraph::state_offer(StateIndex state) {
    Offer offer;
    for (const Edge& edge : edges(state)) {
        if (edge.event == process::tau)
            offer.tau = true;
        else if (offer.events.empty() || offer.events.back() != edge.event)
            offer.events.push_back(edge.event);
    }
    return offer;
}

}  // namespace robochart::refine
