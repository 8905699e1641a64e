// SPDX-License-Identifier: Apache-2.0
// Finds pairs that need not be searched, because a pair with the same state and a subset of the specification states
// has been searched. The smaller set of specification states allows and forbids everything that the larger set allows
// or forbids. So every violation of a run of the larger pair is a violation of a run of the smaller one that is not
// longer.
//
// Laveaux, Groote and Willemse, "Correct and efficient antichain algorithms for refinement checking" (LMCS 17(1),
// 2021): the test is made before a pair is entered. A pair that has been entered is expanded, unless a pair that covers
// it is on its own level or an earlier one. So a pair that covers another was reached by a run that is not longer, and
// shortest violations are those of the search of all pairs.
#pragma once

#include <vector>

#include "checker/lts/state_store.hpp"
#include "checker/refine/search/monitor.hpp"

namespace robochart::refine {

class Antichain {
public:
    explicit Antichain(std::size_t width) : states_(width) {}

    /// Returns the number of a state, in the order of first appearance.
    lts::StateIndex number_state(lts::StateView state);
    /// Whether a pair with this state has been entered whose node is included in `node`.
    [[nodiscard]] bool is_covered(lts::StateIndex state, Monitor::Node node, Monitor& monitor) const;
    void enter_node(lts::StateIndex state, Monitor::Node node, lts::StateIndex pair);
    /// Whether one of the state's pairs has a node that is included in `node` and differs from it.
    [[nodiscard]] bool is_subsumed(lts::StateIndex state, Monitor::Node node, Monitor& monitor) const;
    [[nodiscard]] lts::StateIndex first_pair(lts::StateIndex state) const { return first_pair_[state]; }
    [[nodiscard]] std::size_t size() const { return states_.size(); }

private:
    lts::StateStore states_;
    std::vector<std::vector<Monitor::Node>> nodes_;  // by state
    std::vector<lts::StateIndex> first_pair_;
};

}  // namespace robochart::refine
