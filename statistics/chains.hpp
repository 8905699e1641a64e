// Markov chains estimated from sequences of states. Under the assumption that the sequences are independent runs of one
// chain, the successors of a state's visits, sequence by sequence and in the order of time, are independent draws of
// its row: whether there is another visit depends on earlier draws alone. How many there are depends on them too, so
// intervals for a number that is fixed before do not hold for all of them; those at several looks that share the error
// do (sequential.hpp), and the last look that was reached is taken.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "statistics/binomial.hpp"
#include "statistics/sequential.hpp"

namespace robochart::statistics {

/// Numbers of states at equal times.
using StateSequence = std::vector<std::size_t>;

/// How often a visit of each state was followed by each state, now and at the state's last look.
class TransitionCounts {
public:
    explicit TransitionCounts(std::size_t states);
    /// States are below the number of states; the last state of a sequence has no successor.
    void add(const StateSequence& sequence);
    [[nodiscard]] std::size_t states() const { return states_; }
    [[nodiscard]] std::uint64_t count(std::size_t from, std::size_t to) const { return counts_[from * states_ + to]; }
    /// Visits that have a successor.
    [[nodiscard]] std::uint64_t visits(std::size_t from) const { return visits_[from]; }
    /// Of the visits up to the last look.
    [[nodiscard]] std::uint64_t looked(std::size_t from, std::size_t to) const { return looked_[from * states_ + to]; }
    /// How many visits these are: those of the last of `looks()`; 0 before the first.
    [[nodiscard]] std::uint64_t looked(std::size_t from) const { return looked_visits_[from]; }
    /// The looks that share an error.
    [[nodiscard]] static Looks looks(double error) { return {~std::uint64_t{0}, error}; }

private:
    std::size_t states_;
    std::vector<std::uint64_t> counts_, looked_;
    std::vector<std::uint64_t> visits_, looked_visits_, next_;
};

/// The transitions that a model permits: `[from][to]`.
using Permitted = std::vector<std::vector<bool>>;
/// All of them.
[[nodiscard]] Permitted all_permitted(std::size_t states);

/// Intervals for the probabilities of all permitted transitions that together miss the chain with a chance of at most
/// `error`: those of Clopper and Pearson at the last look at each state, [0, 1] before the first one, the error divided
/// among the transitions of states with more than one. A
/// transition that was never seen has an upper bound above 0 where it is permitted, and [0, 0] where it is not; a
/// state's only one has [1, 1]. Throws std::invalid_argument where one was seen that is not permitted, or none is.
[[nodiscard]] std::vector<std::vector<Interval>> transition_intervals(const TransitionCounts&, const Permitted&,
                                                                      double error);

/// The radius of the ball around the frequencies, in the sum of absolute differences, that misses a distribution on so
/// many values with a chance of at most `error` after so many draws (Weissman, Ordentlich, Seroussi, Verdu and
/// Weinberger, HPL-2003-97): sqrt(2 ln((2^values - 2) / error) / draws), at most 2. 0 for one value.
[[nodiscard]] double weissman_radius(std::size_t values, std::uint64_t draws, double error);

/// Two states before the same one after which the next differs: their intervals for it have no point in common.
struct OrderContradiction {
    std::size_t state = 0, next = 0;
    std::size_t less = 0, more = 0;  ///< the states before it
    Interval after_less, after_more;
};

/// Whether sequences contradict a chain of order 1 (Anderson and Goodman, "Statistical inference about Markov chains",
/// Annals of Mathematical Statistics 28, 1957, test it by chi-squared, for many visits). Of each two states one after
/// the other, the intervals for what comes next, at their last look, hold jointly, the error divided among all
/// permitted triples; in a chain of order 1 those of one middle state have a point in common. So one is contradicted
/// with a chance of at most `error`, however few its visits are. The one whose intervals are farthest apart.
/// `poll` is called again and again, and may throw.
[[nodiscard]] std::optional<OrderContradiction> order_contradiction(const std::vector<StateSequence>&, const Permitted&,
                                                                    double error,
                                                                    const std::function<void()>& poll = {});
/// How many triples of states are permitted whose last is not the only one that may follow: among them the error is
/// divided. At least 1.
[[nodiscard]] double order_triples(const Permitted&);

/// Whether a number of fresh successes contradicts what was predicted: their interval at this error has no point in
/// common with the prediction.
[[nodiscard]] bool contradicts(std::uint64_t successes, std::uint64_t trials, double error, const Interval& predicted);

}  // namespace robochart::statistics
