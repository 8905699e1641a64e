// SPDX-License-Identifier: Apache-2.0
#include "checker/machine/component.hpp"

#include <algorithm>
#include <cassert>

#include "base/diagnostics/containers.hpp"

namespace robochart::machine {
namespace {

constexpr std::size_t largest_index = std::size_t{1} << 24U;

/// Returns all events of the edges, ascending.
EventSet events_on_edges(const std::vector<std::vector<Component::RawEdge>>& rows) {
    std::size_t edges = 0;
    Event last = 0;
    for (const auto& row : rows) {
        edges += row.size();
        if (!row.empty()) last = std::max(last, row.back().event);
    }
    EventSet events;
    if (edges <= last) {
        for (const auto& row : rows)
            for (const Component::RawEdge& edge : row) events.push_back(edge.event);
        diagnostics::sort_unique(events);
        return events;
    }
    // Events are marked instead of sorted, because a component may have millions of edges.
    std::vector<bool> occurs(last + std::size_t{1}, false);
    for (const auto& row : rows)
        for (const Component::RawEdge& edge : row) occurs[edge.event] = true;
    for (Event event = 0; event < occurs.size(); ++event)
        if (occurs[event]) events.push_back(event);
    return events;
}

/// Returns the index of an event in the alphabet, which is `from` or larger. In most cases it is `from` or the next
/// one.
std::uint32_t place_of(const EventSet& alphabet, Event event, std::uint32_t from) {
    if (alphabet[from] == event) return from;
    if (alphabet[from + 1U] == event) return from + 1U;
    const auto place = std::lower_bound(alphabet.begin() + from, alphabet.end(), event);
    assert(place != alphabet.end() && *place == event);
    return static_cast<std::uint32_t>(place - alphabet.begin());
}

}  // namespace

Component::Component(const std::vector<std::vector<RawEdge>>& rows, std::vector<TermId> meaning)
    : meaning_(std::move(meaning)) {
    assert(rows.size() == meaning_.size());
    alphabet_ = events_on_edges(rows);
    std::size_t edges = 0;
    for (const auto& row : rows) edges += row.size();
    edges_.reserve(edges);
    first_.reserve(rows.size() + 1);
    first_.push_back(0);
    for (const auto& row : rows) {
        std::uint32_t place = 0;
        for (const RawEdge& edge : row) {
            place = place_of(alphabet_, edge.event, place);
            edges_.push_back({place, edge.revealed, edge.target});
        }
        first_.push_back(static_cast<std::uint32_t>(edges_.size()));
    }
    index();
}

void Component::index() {
    const std::size_t columns = alphabet_.size() + 1;
    if (size() * columns > largest_index) return;
    by_event_.reserve(size() * columns);
    for (Local state = 0; state < size(); ++state) {
        std::uint32_t at = first_[state];
        for (std::uint32_t event = 0; event < columns; ++event) {
            while (at < first_[state + 1U] && edges_[at].event < event) ++at;
            by_event_.push_back(at);
        }
    }
}

Component::Edges Component::edges(Local state, std::uint32_t event) const {
    assert(event < alphabet_.size());
    if (state >= size()) return {};
    if (!by_event_.empty()) {
        const std::size_t row = state * (alphabet_.size() + 1) + event;
        return Edges(edges_).subspan(by_event_[row], by_event_[row + 1] - by_event_[row]);
    }
    const Edges all = edges(state);
    const auto less = [](const Edge& a, const Edge& b) { return a.event < b.event; };
    const auto [from, to] = std::equal_range(all.begin(), all.end(), Edge{event, 0, 0}, less);
    return {from, to};
}

}  // namespace robochart::machine
