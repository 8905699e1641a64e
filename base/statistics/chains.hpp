// SPDX-License-Identifier: Apache-2.0
// Estimates Markov chains from sequences of states. Assume that the sequences are independent runs of one chain. Then
// the successors of a state's visits, sequence by sequence and in order of time, are independent draws from the state's
// row, because only earlier draws decide whether there is another visit. But the number of visits also depends on the
// draws, so an interval for a fixed number of trials is not valid after all visits. Intervals at several looks that
// share the error are valid (sequential.hpp). The interval of the last look that was reached is used.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/diagnostics/pollable.hpp"
#include "base/statistics/binomial.hpp"
#include "base/statistics/sequential.hpp"

namespace robochart::statistics {

/// The states of one run, as numbers, at consecutive, equidistant times.
using StateSequence = std::vector<std::size_t>;

/// Counts transitions between states, both at present and at the last look at the source state.
class TransitionCounts {
public:
    explicit TransitionCounts(std::size_t states);
    /// Adds a sequence. Each state must be less than the number of states. The last state of the sequence has no
    /// successor.
    void add(const StateSequence& sequence);
    [[nodiscard]] std::size_t state_count() const { return states_; }
    [[nodiscard]] std::uint64_t count(std::size_t from, std::size_t to) const { return counts_[from * states_ + to]; }
    /// Returns the number of visits that have a successor.
    [[nodiscard]] std::uint64_t visit_count(std::size_t from) const { return visits_[from]; }
    /// Returns the count of this transition at the last look at its source state.
    [[nodiscard]] std::uint64_t count_at_last_look(std::size_t from, std::size_t to) const {
        return looked_[from * states_ + to];
    }
    /// Returns the number of visits at the last look of `looks_for_error()`, or 0 before the first look.
    [[nodiscard]] std::uint64_t count_at_last_look(std::size_t from) const { return looked_visits_[from]; }
    /// Returns the looks at a state, which together use this error.
    [[nodiscard]] static Looks looks_for_error(double error) { return {~std::uint64_t{0}, error}; }

private:
    std::size_t states_;
    std::vector<std::uint64_t> counts_, looked_;
    std::vector<std::uint64_t> visits_, looked_visits_, next_;
};

/// Which transitions a model permits, by source and target.
using Permitted = std::vector<std::vector<bool>>;
/// Returns a value that permits every transition.
[[nodiscard]] Permitted all_permitted(std::size_t states);

/// Returns intervals for the probabilities of all transitions. The chance that any of them does not contain the true
/// probability is at most `error`. They are the intervals of Clopper and Pearson at the last look at each state, or [0,
/// 1] before the first look. The error is divided among the transitions of all states that have more than one permitted
/// transition. A transition that was never seen has an upper bound above 0 if it is permitted, and [0, 0] otherwise. If
/// a state has only one permitted transition, the interval of this transition is [1, 1]. Throws std::invalid_argument
/// if a transition was seen that is not permitted, or if no transition is permitted.
[[nodiscard]] std::vector<std::vector<Interval>> transition_intervals(const TransitionCounts&, const Permitted&,
                                                                      double error);

/// A state whose next state depends on the state before it: for two different states before it, the intervals are
/// disjoint.
struct OrderContradiction {
    std::size_t state = 0, next = 0;
    std::size_t less = 0, more = 0;  ///< two states that can come before `state`
    Interval after_less, after_more;
};

/// Tests whether sequences contradict a chain of order 1 (Anderson and Goodman, "Statistical inference about Markov
/// chains", Annals of Mathematical Statistics 28, 1957, use chi-squared tests for many visits). For each pair of
/// consecutive states, the test computes intervals for the probabilities of the next state at the pair's last look. The
/// intervals hold jointly, because the error is divided among all permitted triples. In a chain of order 1, all
/// intervals for the same middle state and next state contain the same probability, so they overlap. So a chain of
/// order 1 is contradicted with a chance of at most `error`, for any number of visits. Returns the contradiction whose
/// intervals are farthest apart. Polls the budget for each next state that was seen.
[[nodiscard]] std::optional<OrderContradiction> order_contradiction(
    const std::vector<StateSequence>&, const Permitted&, double error,
    diagnostics::Pollable& budget = diagnostics::unlimited);
/// Returns the number of permitted triples of states whose last state is not the only permitted state, but at least 1.
/// The error is divided among these triples.
[[nodiscard]] double order_triples(const Permitted&);

/// Returns true if new trials contradict a prediction: the interval of their success probability at this error is
/// disjoint from the predicted interval.
[[nodiscard]] bool contradicts_prediction(std::uint64_t successes, std::uint64_t trials, double error,
                                          const Interval& predicted);

}  // namespace robochart::statistics
