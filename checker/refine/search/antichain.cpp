// SPDX-License-Identifier: Apache-2.0
#include "checker/refine/search/antichain.hpp"

#include <algorithm>
#include <cassert>

namespace robochart::refine {
namespace {

/// Maximal number of comparisons for one pair. If they find no other pair, the pair is searched, which is always
/// correct.
constexpr std::size_t most_compared = 64;

}  // namespace

lts::StateIndex Antichain::number_state(lts::StateView state) {
    const lts::StateStore::Insertion insertion = states_.insert(state);
    if (insertion.fresh) {
        nodes_.emplace_back();
        first_pair_.push_back(lts::no_state);
    }
    assert(insertion.index < nodes_.size() && nodes_.size() == first_pair_.size());
    return insertion.index;
}

bool Antichain::is_covered(lts::StateIndex state, Monitor::Node node, Monitor& monitor) const {
    const std::vector<Monitor::Node>& nodes = nodes_[state];
    const auto end = nodes.begin() + static_cast<std::ptrdiff_t>(std::min(nodes.size(), most_compared));
    return std::any_of(nodes.begin(), end, [&](Monitor::Node smaller) { return monitor.includes(node, smaller); });
}

bool Antichain::is_subsumed(lts::StateIndex state, Monitor::Node node, Monitor& monitor) const {
    const std::vector<Monitor::Node>& nodes = nodes_[state];
    const auto end = nodes.begin() + static_cast<std::ptrdiff_t>(std::min(nodes.size(), most_compared));
    return std::any_of(nodes.begin(), end,
                       [&](Monitor::Node smaller) { return smaller != node && monitor.includes(node, smaller); });
}

void Antichain::enter_node(lts::StateIndex state, Monitor::Node node, lts::StateIndex pair) {
    assert(state < nodes_.size());
    if (nodes_[state].empty()) first_pair_[state] = pair;
    nodes_[state].push_back(node);
}

}  // namespace robochart::refine
