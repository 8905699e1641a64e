// SPDX-License-Identifier: Apache-2.0
// Differences between two texts in the unified format of diff -u and patch.
#pragma once

#include <string>
#include <string_view>

namespace robochart::app {

/// The unified difference with three lines of context; "" if the texts are equal. Line ends belong to their lines, so
/// that a change of line ends is shown. Shortest for up to 1,000 consecutive changed lines, then in larger blocks.
[[nodiscard]] std::string unified_diff(const std::string& path, std::string_view before, std::string_view after);

}  // namespace robochart::app
