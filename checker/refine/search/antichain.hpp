// SPDX-License-Identifier: Apache-2.0
// Finds pairs that need not be searched: a pair with the same state and a subset of the specification states has
// already been searched. The smaller set of specification states allows only what the larger set allows. So for every
// violation after the pair with the larger set, there is a violation after the pair with the smaller set whose run is
// not longer.
//
// The algorithm follows Laveaux, Groote and Willemse, "Correct and efficient antichain algorithms for refinement
// checking" (LMCS 17(1), 2021): the search tests a pair before entering it. The search expands an entered pair unless
// another pair on the same level or an earlier level covers it. So the run to a covering pair is not longer than the
// run to the covered pair. Therefore shortest violations have the same length as in the search of all pairs.
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
    /// Returns true if an entered pair has this state and a node that is included in `node`.
    [[nodiscard]] bool is_covered(lts::StateIndex state, Monitor::Node node, Monitor& monitor) const;
    void enter_node(lts::StateIndex state, Monitor::Node node, lts::StateIndex pair);
    /// Returns true if one of the state's pairs has a node that is included in `node` and differs from it.
    [[nodiscard]] bool is_subsumed(lts::StateIndex state, Monitor::Node node, Monitor& monitor) const;
    [[nodiscard]] lts::StateIndex first_pair(lts::StateIndex state) const { return first_pair_[state]; }
    [[nodiscard]] std::size_t size() const { return states_.size(); }

private:
    lts::StateStore states_;
    std::vector<std::vector<Monitor::Node>> nodes_;  // by state: the nodes of its pairs
    std::vector<lts::StateIndex> first_pair_;
};

}  // namespace robochart::refine
