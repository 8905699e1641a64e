// SPDX-License-Identifier: Apache-2.0
#include "checker/machine/component.hpp"

#include <algorithm>
#include <cassert>

#include "base/diagnostics/containers.hpp"

namespace robochart::machine {
namespace {

constexpr std::size_t largest_index = std::size_t{1} << 24U;

std::uint32_t place_of(const EventSet& alphabet, Event event) {
    assert(std::ranges::binary_search(alphabet, event));
    return static_cast<std::uint32_t>(std::ranges::lower_bound(alphabet, event) - alphabet.begin());
}

}  // namespace

Component::Component(const std::vector<std::vector<RawEdge>>& rows, std::vector<TermId> meaning)
    : meaning_(std::move(meaning)) {
    assert(rows.size() == meaning_.size());
    for (const auto& row : rows)
        for (const RawEdge& edge : row) alphabet_.push_back(edge.event);
    diagnostics::sort_unique(alphabet_);
    first_.push_back(0);
    for (const auto& row : rows) {
        for (const RawEdge& edge : row) edges_.push_back({place_of(alphabet_, edge.event), edge.revealed, edge.target});
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
