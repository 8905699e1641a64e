// Pairs that need not be searched, because one with the same state and fewer specification states has been: whatever
// the larger set allows the smaller one allows or forbids too, so that a violation of the larger one's runs is one of
// the smaller one's, and no longer. Laveaux, Groote and Willemse, "Correct and efficient antichain algorithms for
// refinement checking" (LMCS 17(1), 2021): the test is made before a pair is entered. A pair once entered is expanded,
// unless one that covers it is on its own level or before. So the pair that covers another was reached by a run
// that is no longer, and shortest violations are those of the search of all pairs.
#pragma once

#include <vector>

#include "checker/lts/state_store.hpp"
#include "checker/refine/search/monitor.hpp"

namespace robochart::refine {

class Antichain {
public:
    explicit Antichain(std::size_t width) : states_(width) {}

    /// The number of a state, in the order of their first appearance.
    lts::StateIndex number(lts::StateView state);
    /// Whether a pair of this state was entered whose node is included in `node`.
    [[nodiscard]] bool covers(lts::StateIndex state, Monitor::Node node, Monitor& monitor) const;
    void enter(lts::StateIndex state, Monitor::Node node, lts::StateIndex pair);
    /// Whether one of the state's pairs has a node that is included in `node`, but not `node` itself.
    [[nodiscard]] bool is_subsumed(lts::StateIndex state, Monitor::Node node, Monitor& monitor) const;
    [[nodiscard]] lts::StateIndex first_pair(lts::StateIndex state) const { return first_pair_[state]; }
    [[nodiscard]] std::size_t size() const { return states_.size(); }

private:
    lts::StateStore states_;
    std::vector<std::vector<Monitor::Node>> nodes_;  // of each state
    std::vector<lts::StateIndex> first_pair_;
};

}  // namespace robochart::refine
