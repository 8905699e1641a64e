// SPDX-License-Identifier: Apache-2.0
// Guesses for a component's values in plain floating point, and their proof.
#pragma once

#include <optional>
#include <vector>

#include "prism/markov/solve/interval.hpp"
#include "prism/markov/solve/system.hpp"

namespace robochart::markov {

/// The guess for one unknown: its values with all constants at their low and at their high bounds.
struct Guess {
    double low = 0;
    double high = 0;
    double weight = 0;  ///< approximately high + the sum of p * weight over the unknowns to which the best choices lead
};
using Guesses = std::vector<Guess>;

/// Proves bounds near guesses. With the weights w and a small e, it checks that high + e w is at least its image under
/// any (minimum: one) policy, and that low - e w is at most its image under one (minimum: any) policy. By induction
/// over the steps the values lie between them (Park's lemma; the last step uses that the equations have one solution).
/// Rows of clearly worse choices, in which the weights do not shrink, limit e by their distance from the best choice.
/// All rounding is to the safe side, so the origin of the guesses does not matter. `most`: an upper bound on all
/// values. No value if no e satisfies the conditions.
[[nodiscard]] std::optional<std::vector<Interval>> prove(const System<Interval>& system, Direction direction,
                                                         const Guesses& guesses, double most);

/// The greatest relative width of the intervals.
[[nodiscard]] double relative_width(const std::vector<Interval>& values);

/// Gauss-Seidel iteration that improves the guesses.
class GuessIteration {
public:
    GuessIteration(const System<Interval>& system, Direction direction);

    /// Updates each unknown once, last first. Returns the greatest relative change.
    double sweep();
    [[nodiscard]] Guesses& guesses() { return guesses_; }
    /// Choices whose worth is within this relative distance of the best are used together for the weights.
    void set_tie(double share) { tie_ = share; }
    /// The best choices according to the guesses.
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
