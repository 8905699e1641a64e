// SPDX-License-Identifier: Apache-2.0
// Decides whether an event can always happen again. This is AG EF of computation tree logic (Clarke, Emerson and
// Sistla, TOPLAS 8, 1986), with an event in place of a condition on states.
#pragma once

#include "checker/refine/verdict/verdict.hpp"

namespace robochart::refine {

/// Checks that every reachable state has a run to a state in which an event of `goal` can happen. `goal` must be
/// ascending and must not contain tau. If the check fails, the counterexample is a run to a state from which no such
/// run exists (ViolationKind::no_return). No other searched state without such a run is nearer to the initial state.
///
/// The algorithm explores all states, marks those in which an event of the goal is possible, and then marks backwards
/// the states that lead to marked states. It takes linear time in the number of states and transitions. With reduction,
/// the algorithm omits states from which it follows a confluent tau. If every exchange of replicas maps the goal to
/// itself, one state represents all its images. Both reductions preserve the answer: a state and its representative are
/// branching bisimilar, or they are images of each other (docs/search.md). So they have runs to the same events, or to
/// images of these events.
///
/// About fairness: consider a Markov chain on the same finite set of states in which each transition has positive
/// probability. In this chain the events happen infinitely often with probability 1 if and only if they always can
/// (Baier and Katoen, Principles of Model Checking, 2008, theorem 10.27). So for a finite process with such
/// probabilities, "holds" also means that the events happen infinitely often with probability 1. Without probabilities
/// the answer only states what can happen.
[[nodiscard]] Verdict recurrent(lts::TransitionSystem&, const process::EventSet& goal, const Limits&);

}  // namespace robochart::refine
