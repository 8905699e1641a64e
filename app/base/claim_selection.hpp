// What --assertion asks for: names, numbers, ranges of numbers and patterns, the same for models and for scripts.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace robochart::app {

/// The claims that the words of --assertion mean.
struct ClaimSelection {
    std::vector<std::size_t> chosen;  ///< places in the list of names, in order, each once
    std::vector<std::string> lost;    ///< words that mean none of them
};

/// Each word is a name, a number (`2`, from 1), a range of numbers (`3..5`) or a pattern (`Safe*`: `*` any text, `?`
/// one character). A word that is a name is no pattern. Without words all claims are chosen.
[[nodiscard]] ClaimSelection select_claims(const std::vector<std::string>& words,
                                           const std::vector<std::string>& names);

/// Why such a word means no claim of the subject: "the model has 3 assertions", "s.csp has no assertion of this name;
/// did you mean 'Safe'?".
[[nodiscard]] std::string why_lost(std::string_view word, const std::vector<std::string>& names,
                                   std::string_view subject);

}  // namespace robochart::app
