// SPDX-License-Identifier: Apache-2.0
#include "checker/machine/component_shape.hpp"

#include <algorithm>
#include <cassert>
#include <numeric>

#include "base/diagnostics/splitmix64.hpp"

namespace robochart::machine {
namespace {

using diagnostics::splitmix64_mixed;
using Colour = std::uint64_t;

constexpr std::size_t most_visited_edges = 50'000'000;  // total number of edges visited in all rounds

Colour combine_colours(Colour a, Colour b) {
    return splitmix64_mixed(splitmix64_mixed(a) + b);
}

std::size_t count_distinct(std::vector<Colour> colours) {
    std::ranges::sort(colours);
    return static_cast<std::size_t>(std::unique(colours.begin(), colours.end()) - colours.begin());
}

/// Computes colours of states and events. A mapping between two components maps equal colours to each other.
class Refinement {
public:
    Refinement(const Component& component, const std::vector<std::uint64_t>& role, diagnostics::Pollable& budget)
        : component_(component), states_(component.size(), 1), events_(role), budget_(budget) {
        states_.front() = 2;
    }

    /// Refines the colours in rounds. Stops when a round finds no further difference between states or events.
    void run() {
        std::size_t edges = 1;
        for (Local state = 0; state < component_.size(); ++state) edges += component_.edges(state).size();
        for (std::size_t work = 0, known = 0; work < most_visited_edges; work += edges) {
            const std::size_t now = count_distinct(states_) + count_distinct(events_);
            if (now == known) return;
            known = now;
            refine_colours();
        }
    }

    [[nodiscard]] const std::vector<Colour>& states() const { return states_; }
    [[nodiscard]] const std::vector<Colour>& events() const { return events_; }

private:
    /// Computes new colours. The colour of a state results from its old colour and from the colours of all adjacent
    /// edges. The order of the edges has no effect.
    void refine_colours() {
        std::vector<Colour> states = states_;
        std::vector<Colour> events = events_;
        for (Local from = 0; from < component_.size(); ++from) {
            budget_.poll();
            for (const Component::Edge& edge : component_.edges(from)) {
                const Colour by = events_[edge.event];
                events[edge.event] += combine_colours(states_[from], combine_colours(3, states_[edge.target]));
                states[from] += combine_colours(by, combine_colours(4, states_[edge.target]));
                states[edge.target] += combine_colours(by, combine_colours(5, states_[from]));
            }
        }
        for (Colour& colour : states) colour = splitmix64_mixed(colour);
        for (Colour& colour : events) colour = splitmix64_mixed(colour);
        states_ = std::move(states);
        events_ = std::move(events);
    }

    const Component& component_;
    std::vector<Colour> states_, events_;
    diagnostics::Pollable& budget_;
};

/// Returns the states in breadth-first order. The search takes edges in the order of the ranks of their events, then of
/// the colours of their targets.
std::vector<Local> search_order(const Component& component, const std::vector<std::uint32_t>& rank,
                                const std::vector<Colour>& colour) {
    std::vector<Local> order{0};
    std::vector<bool> seen(component.size(), false);
    seen[0] = true;
    for (std::size_t i = 0; i < order.size(); ++i) {
        const Component::Edges row = component.edges(order[i]);
        std::vector<Component::Edge> edges(row.begin(), row.end());
        std::ranges::stable_sort(edges, [&](const Component::Edge& a, const Component::Edge& b) {
            return std::pair(rank[a.event], colour[a.target]) < std::pair(rank[b.event], colour[b.target]);
        });
        for (const Component::Edge& edge : edges) {
            if (seen[edge.target]) continue;
            seen[edge.target] = true;
            order.push_back(edge.target);
        }
    }
    return order;
}

std::uint64_t hash_of(std::vector<Colour> states, std::vector<Colour> events) {
    std::ranges::sort(states);
    std::ranges::sort(events);
    std::uint64_t hash = states.size();
    for (const std::vector<Colour>* all : {&states, &events})
        for (const Colour colour : *all) hash = combine_colours(hash, colour);
    return hash;
}

}  // namespace

ComponentShape shape_of(const Component& component, const std::vector<std::uint64_t>& role,
                        const lts::EventTable& names, diagnostics::Pollable& budget) {
    Refinement refinement(component, role, budget);
    refinement.run();
    const EventSet& alphabet = component.alphabet();
    assert(role.size() == alphabet.size());
    ComponentShape shape;
    shape.event.resize(alphabet.size());
    std::iota(shape.event.begin(), shape.event.end(), 0U);
    std::ranges::sort(shape.event, [&](std::uint32_t a, std::uint32_t b) {
        const Colour first = refinement.events()[a];
        const Colour second = refinement.events()[b];
        return first != second ? first < second : names.name(alphabet[a]) < names.name(alphabet[b]);
    });
    std::vector<std::uint32_t> rank(alphabet.size());
    for (std::uint32_t i = 0; i < rank.size(); ++i) rank[shape.event[i]] = i;
    shape.state = search_order(component, rank, refinement.states());
    if (shape.state.size() < component.size()) return {};
    shape.state.push_back(static_cast<Local>(component.size()));
    shape.number.resize(shape.state.size());
    for (std::uint32_t i = 0; i < shape.number.size(); ++i) shape.number[shape.state[i]] = i;
    shape.hash = hash_of(refinement.states(), refinement.events());
    return shape;
}

}  // namespace robochart::machine
