// Markov chains estimated from sequences of states. Under the assumption that the sequences are independent runs of one
// chain, the successors of a state's first visits in the sequences are independent draws of its row, and whether a
// sequence visits the state does not depend on that draw: so intervals for a fixed number of trials hold. Later visits
// of the same sequence are not used.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "statistics/binomial.hpp"

namespace robochart::statistics {

/// Numbers of states at equal times.
using StateSequence = std::vector<std::size_t>;

/// How often the first visit of each state in a sequence was followed by each state.
class TransitionCounts {
public:
    explicit TransitionCounts(std::size_t states) : states_(states), counts_(states * states) {}
    /// States are below the number of states; the last state of a sequence has no successor.
    void add(const StateSequence& sequence);
    [[nodiscard]] std::size_t states() const { return states_; }
    [[nodiscard]] std::uint64_t count(std::size_t from, std::size_t to) const { return counts_[from * states_ + to]; }
    /// Sequences that have a successor of this state.
    [[nodiscard]] std::uint64_t visits(std::size_t from) const;

private:
    std::size_t states_;
    std::vector<std::uint64_t> counts_;
};

/// The transitions that a model permits: `[from][to]`.
using Permitted = std::vector<std::vector<bool>>;
/// All of them.
[[nodiscard]] Permitted all_permitted(std::size_t states);

/// Intervals for the probabilities of all permitted transitions that together miss the chain with a chance of at most
/// `error`: those of Clopper and Pearson, the error divided among the transitions of states with more than one. A
/// transition that was never seen has an upper bound above 0 where it is permitted, and [0, 0] where it is not; a
/// state's only one has [1, 1]. Throws std::invalid_argument where one was seen that is not permitted, or none is.
[[nodiscard]] std::vector<std::vector<Interval>> transition_intervals(const TransitionCounts&, const Permitted&,
                                                                      double error);

/// The radius of the ball around the frequencies, in the sum of absolute differences, that misses a distribution on so
/// many values with a chance of at most `error` after so many draws (Weissman, Ordentlich, Seroussi, Verdu and
/// Weinberger, HPL-2003-97): sqrt(2 ln((2^values - 2) / error) / draws), at most 2. 0 for one value.
[[nodiscard]] double weissman_radius(std::size_t values, std::uint64_t draws, double error);

/// Whether a number of fresh successes contradicts what was predicted: their interval at this error has no point in
/// common with the prediction.
[[nodiscard]] bool contradicts(std::uint64_t successes, std::uint64_t trials, double error, const Interval& predicted);

}  // namespace robochart::statistics
