// Whether something can always happen again: AG EF of computation tree logic (Clarke, Emerson and Sistla, TOPLAS 8,
// 1986), for an event instead of a condition on states.
#pragma once

#include "checker/refine/verdict/verdict.hpp"

namespace robochart::refine {

/// Whether from every state that can be reached some run leads to one in which an event of `goal` can happen
/// (ascending, without tau). Fails with a run to a state from which none does (ViolationKind::no_return), and to a
/// nearest one of the states that were searched.
///
/// All states are explored; those in which an event of the goal is possible are marked, and so are, backwards, those
/// that lead to marked ones: linear in states and transitions. With reduction, states that confluent taus lead on from
/// are left out, and replicas are folded if every exchange maps the goal to itself. Both keep the answer: a state and
/// the one that stands for it are branching bisimilar, or images of each other (docs/search.md), and so have runs to
/// the same events, or to their images.
///
/// About fairness: in a finite system the answer "holds" is that of a Markov chain on the same states in which each
/// transition has a chance above 0: there the events happen again and again with probability 1 iff they always can
/// (Baier and Katoen, Principles of Model Checking, 2008, theorem 10.27). Without chances it says what can happen.
[[nodiscard]] Verdict recurrent(lts::TransitionSystem&, const process::EventSet& goal, const Limits&);

}  // namespace robochart::refine
