// Differences between two texts as people read them: the unified format of diff -u and patch.
#pragma once

#include <string>
#include <string_view>

namespace robochart::app {

/// The unified difference with three lines of context, "" if the texts are equal. Line ends belong to their lines, so
/// that a change of line ends shows. Shortest up to 1,000 changed lines in a row, then larger blocks.
[[nodiscard]] std::string unified_diff(const std::string& path, std::string_view before, std::string_view after);

}  // namespace robochart::app
