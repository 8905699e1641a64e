// SPDX-License-Identifier: Apache-2.0
// Writes probabilities as text. Rounded bounds are correct: a lower bound is rounded down, and an upper bound is
// rounded up.
#pragma once

#include <string>

namespace robochart::simulation {

/// Returns a text such as "95 %" or "0.25 %", with at most six digits.
[[nodiscard]] std::string percent_text(double probability);
/// These functions write three decimals, rounded down or up.
[[nodiscard]] std::string percent_below(double probability);
[[nodiscard]] std::string percent_above(double probability);

}  // namespace robochart::simulation
