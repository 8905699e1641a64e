// SPDX-License-Identifier: Apache-2.0
// Decides whether a specification distinguishes events that a symmetry of the implementation exchanges.
#pragma once

#include <optional>

#include "checker/lts/symmetry.hpp"
#include "checker/refine/verdict/normal_form.hpp"
#include "checker/refine/verdict/verdict.hpp"

namespace robochart::refine {

/// Answers questions about the normal form of a specification. The first call visits the whole normal form.
class Indifference {
public:
    Indifference(lts::TransitionSystem& specification, Model model, Budget& budget)
        : specification_(specification), model_(model), budget_(budget) {}

    /// Returns true if two conditions hold for the exchanged events. First, an event and its image lead from each node
    /// of the normal form to the same node. Second, except in the traces model, the image of each acceptance of a node
    /// is also an acceptance of the node. Then a state of an implementation violates a node if and only if its images
    /// do. Returns false if there are more than 10,000 nodes, or if the evaluation fails. (The search may never reach
    /// the term whose evaluation fails.)
    bool holds_for(const lts::EventPermutation& exchange);

private:
    [[nodiscard]] bool visit_nodes();
    [[nodiscard]] bool holds_at(NormalForm::Node node, const lts::EventPermutation& exchange);

    lts::TransitionSystem& specification_;
    Model model_;
    Budget& budget_;
    std::optional<NormalForm> normal_;
    bool whole_ = false;  // true after all nodes have been visited
};

}  // namespace robochart::refine
