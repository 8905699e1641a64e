// Probabilities as text. What is said of a bound is true of the text too: a lower bound is rounded down, an upper one
// up.
#pragma once

#include <string>

namespace robochart::simulation {

/// "95 %", "0.25 %": at most six digits.
[[nodiscard]] std::string percent(double probability);
/// Three decimals, rounded down, and up.
[[nodiscard]] std::string percent_below(double probability);
[[nodiscard]] std::string percent_above(double probability);

}  // namespace robochart::simulation
