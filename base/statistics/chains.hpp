// SPDX-License-Identifier: Apache-2.0
// Markov chains estimated from sequences of states. Assume that the sequences are independent runs of one chain. Then
// the successors of a state's visits, sequence by sequence and in order of time, are independent draws from its row,
// because only earlier draws decide whether there is another visit. The number of visits also depends on the draws, so
// an interval for a fixed number of trials is not valid after all visits. Intervals at several looks that share the
// error are valid (sequential.hpp), and the last look that was reached is used.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/diagnostics/pollable.hpp"
#include "base/statistics/binomial.hpp"
#include "base/statistics/sequential.hpp"

namespace robochart::statistics {

/// The states of one run at consecutive, equidistant times, as numbers.
using StateSequence = std::vector<std::size_t>;

/// Counts transitions between states, at present and at the last look of the source state.
class TransitionCounts {
public:
    explicit TransitionCounts(std::size_t states);
    /// Each state must be less than the number of states. The last state of a sequence has no successor.
    void add(const StateSequence& sequence);
    [[nodiscard]] std::size_t state_count() const { return states_; }
    [[nodiscard]] std::uint64_t count(std::size_t from, std::size_t to) const { return counts_[from * states_ + to]; }
    /// The number of visits with a successor.
    [[nodiscard]] std::uint64_t visit_count(std::size_t from) const { return visits_[from]; }
    /// The count of this transition at the last look at its source state.
    [[nodiscard]] std::uint64_t count_at_last_look(std::size_t from, std::size_t to) const {
        return looked_[from * states_ + to];
    }
    /// The number of visits at the last look of `looks_for_error()`; 0 before the first look.
    [[nodiscard]] std::uint64_t count_at_last_look(std::size_t from) const { return looked_visits_[from]; }
    /// The looks at a state; together they use this error.
    [[nodiscard]] static Looks looks_for_error(double error) { return {~std::uint64_t{0}, error}; }

private:
    std::size_t states_;
    std::vector<std::uint64_t> counts_, looked_;
    std::vector<std::uint64_t> visits_, looked_visits_, next_;
};

/// The transitions that a model permits, as `[from][to]`.
using Permitted = std::vector<std::vector<bool>>;
/// Permits every transition.
[[nodiscard]] Permitted all_permitted(std::size_t states);

/// Intervals for the probabilities of all permitted transitions. The chance that any of them misses the chain is at
/// most `error`. They are the intervals of Clopper and Pearson at the last look at each state, or [0, 1] before the
/// first look; the error is divided among the transitions of states with more than one. A transition that was never
/// seen has an upper bound above 0 if it is permitted, otherwise [0, 0]. The only permitted transition of a state has
/// [1, 1]. Throws std::invalid_argument if a transition was seen that is not permitted, or if none is permitted.
[[nodiscard]] std::vector<std::vector<Interval>> transition_intervals(const TransitionCounts&, const Permitted&,
                                                                      double error);

/// A state whose next state depends on the state before it: the intervals for two different states before it are
/// disjoint.
struct OrderContradiction {
    std::size_t state = 0, next = 0;
    std::size_t less = 0, more = 0;  ///< the two states before it
    Interval after_less, after_more;
};

/// Tests whether sequences contradict a chain of order 1 (Anderson and Goodman, "Statistical inference about Markov
/// chains", Annals of Mathematical Statistics 28, 1957, use chi-squared tests for many visits). The test computes, for
/// each pair of consecutive states, intervals for the probabilities of the next state at the pair's last look. They
/// hold jointly, because the error is divided among all permitted triples. In a chain of order 1, the intervals of one
/// middle state and one next state overlap. So a chain of order 1 is contradicted with a chance of at most `error`, for
/// any number of visits. Returns the contradiction whose intervals are farthest apart. Polls the budget for each next
/// state that was seen.
[[nodiscard]] std::optional<OrderContradiction> order_contradiction(
    const std::vector<StateSequence>&, const Permitted&, double error,
    diagnostics::Pollable& budget = diagnostics::unlimited);
/// The number of permitted triples of states whose last state is not the only permitted one; the error is divided among
/// them. At least 1.
[[nodiscard]] double order_triples(const Permitted&);

/// True if fresh trials contradict a prediction: the interval of their success probability at this error is disjoint
/// from the predicted interval.
[[nodiscard]] bool contradicts_prediction(std::uint64_t successes, std::uint64_t trials, double error,
                                          const Interval& predicted);

}  // namespace robochart::statistics
