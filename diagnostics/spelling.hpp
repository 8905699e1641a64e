// What a misspelt word may have been meant to be: the nearest of the words that are known.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace robochart::diagnostics {

/// The candidate nearest to a misspelt name, if it is near enough to be meant; "" otherwise.
[[nodiscard]] std::string nearest(std::string_view name, const std::vector<std::string>& candidates);
/// Is it certain that `meant` was meant: at most two letters away, and nothing else as near?
[[nodiscard]] bool is_certain(std::string_view name, std::string_view meant,
                              const std::vector<std::string>& candidates);
/// The title of a fix by another name.
[[nodiscard]] std::string suggested(bool certain);

}  // namespace robochart::diagnostics
