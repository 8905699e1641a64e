// SPDX-License-Identifier: Apache-2.0
// Guesses the values of a component in plain floating point, and proves bounds near the guesses.
#pragma once

#include <optional>
#include <vector>

#include "prism/markov/solve/interval.hpp"
#include "prism/markov/solve/system.hpp"

namespace robochart::markov {

/// The guess for one unknown: its value if all constants are at their low bounds, and its value if they are at their
/// high bounds.
struct Guess {
    double low = 0;
    double high = 0;
    double weight = 0;  ///< approximately high + the sum of p * weight over the unknowns to which the best choices lead
};
using Guesses = std::vector<Guess>;

/// Proves bounds near guesses. With the weights w and a small e, it checks two conditions. First, high + e w is at
/// least its image under any policy (for a minimum: under one policy). Second, low - e w is at most its image under one
/// policy (for a minimum: under any policy). By induction over the steps, the values are between high + e w and low - e
/// w (Park's lemma; the last step uses that the equations have one solution). If the weights of a row do not shrink,
/// its choice must be clearly worse than the best one, and the distance limits e. All rounding is to the safe side, so
/// the origin of the guesses does not matter. `most` is an upper bound on all values. Returns no value if no e
/// satisfies the conditions.
[[nodiscard]] std::optional<std::vector<Interval>> prove(const System<Interval>& system, Direction direction,
                                                         const Guesses& guesses, double most);

/// Returns the greatest relative width of the intervals.
[[nodiscard]] double relative_width(const std::vector<Interval>& values);

/// Improves the guesses by Gauss-Seidel iteration.
class GuessIteration {
public:
    GuessIteration(const System<Interval>& system, Direction direction);

    /// Updates each unknown once, from the last to the first. Returns the greatest relative change.
    double sweep();
    [[nodiscard]] Guesses& guesses() { return guesses_; }
    /// Sets the relative distance from the best choice. All choices whose worth is within it determine the weights
    /// together.
    void set_tie(double share) { tie_ = share; }
    /// Returns the best choices according to the guesses.
    [[nodiscard]] Policy policy() const;

private:
    struct Worth {
        double low;
        double high;
        double weight;  // weight of the targets
        double leaving;
    };
    [[nodiscard]] Worth choice_worth(std::uint32_t unknown, std::uint32_t choice) const;
    [[nodiscard]] Guess improve_guess(std::uint32_t unknown);

    const System<Interval>& system_;
    const Direction direction_;
    std::vector<double> numbers_;
    Guesses guesses_;
    double tie_ = 1e-6;
    std::vector<Worth> offers_;  // by choice of one unknown
};

}  // namespace robochart::markov
