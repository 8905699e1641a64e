// SPDX-License-Identifier: Apache-2.0
// Selects claims by the words of --assertion: names, numbers, ranges of numbers and patterns. Models and scripts use
// the same words.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace robochart::driver {

/// The claims that the arguments (words) of --assertion select.
struct ClaimSelection {
    std::vector<std::size_t> chosen;  ///< indices in the list of names, ascending, without duplicates
    std::vector<std::string> lost;    ///< words that select no claim
};

/// Selects claims. Each word is a name, a number (`2`, from 1), a range of numbers (`3..5`) or a pattern (`Safe*`). In
/// a pattern, `*` matches any text and `?` matches one character. A word that equals a name is not a pattern. Without
/// words, all claims are selected.
[[nodiscard]] ClaimSelection select_claims(const std::vector<std::string>& words,
                                           const std::vector<std::string>& names);

/// Returns true if the word is a number or a range of numbers.
[[nodiscard]] bool selects_by_number(std::string_view word);

/// Explains why a word selects no claim, as in "the model has 3 assertions" or "s.csp has no assertion of this name;
/// did you mean 'Safe'?". `subject` names the model or script.
[[nodiscard]] std::string why_lost(std::string_view word, const std::vector<std::string>& names,
                                   std::string_view subject);

}  // namespace robochart::driver
