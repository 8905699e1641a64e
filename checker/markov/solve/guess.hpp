// Guesses of a component's values, in plain floating point, and their proof.
#pragma once

#include <optional>
#include <vector>

#include "checker/markov/solve/interval.hpp"
#include "checker/markov/solve/system.hpp"

namespace robochart::markov {

/// Of one unknown. Two values: with all constants at their low and at their high bounds.
struct Guess {
    double low = 0;
    double high = 0;
    double weight = 0;  ///< about high + the sum of p * weight over the unknowns that the best choices lead to
};
using Guesses = std::vector<Guess>;

/// Proves bounds near guesses. With the weights w and a small e, high + e w is found to be at least what any (minimum:
/// one) policy makes of it, and low - e w at most what one (minimum: any) policy makes of it. By induction over the
/// steps the values lie between (Park's lemma; the last step uses that the equations have one solution). Rows where the
/// weights do not shrink, those of clearly worse choices, allow only an e that their distance from the best covers.
/// Everything is rounded to the safe side, so what the guesses come from does not matter. `most`: no value is above it.
/// Nothing where no e does it.
[[nodiscard]] std::optional<std::vector<Interval>> prove(const System<Interval>& system, Direction direction,
                                                         const Guesses& guesses, double most);

/// The greatest relative width.
[[nodiscard]] double relative_width(const std::vector<Interval>& values);

/// Gauss-Seidel from the guesses so far.
class GuessIteration {
public:
    GuessIteration(const System<Interval>& system, Direction direction);

    /// One sweep over the unknowns, last first; the greatest relative change.
    double sweep();
    [[nodiscard]] Guesses& guesses() { return guesses_; }
    /// Choices whose worth is within this share of the best count as equally good, for the weights.
    void set_tie(double share) { tie_ = share; }
    /// The best choices by the guesses.
    [[nodiscard]] Policy policy() const;

private:
    struct Worth {
        double low;
        double high;
        double weight;  // of the targets
        double leaving;
    };
    [[nodiscard]] Worth worth(std::uint32_t unknown, std::uint32_t choice) const;
    [[nodiscard]] Guess improved(std::uint32_t unknown);

    const System<Interval>& system_;
    const Direction direction_;
    std::vector<double> numbers_;
    Guesses guesses_;
    double tie_ = 1e-6;
    std::vector<Worth> offers_;  // of the choices of one unknown
};

}  // namespace robochart::markov
