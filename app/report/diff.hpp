// SPDX-License-Identifier: Apache-2.0
// Computes differences between two texts in the unified format of diff -u and patch.
#pragma once

#include <string>
#include <string_view>

namespace robochart::app {

/// Returns the unified difference with three lines of context; "" if the texts are equal. A line includes its line end,
/// so that a change of line ends is shown. The difference is minimal for up to 1,000 consecutive changed lines; larger
/// changes are shown as blocks.
[[nodiscard]] std::string unified_diff(const std::string& path, std::string_view before, std::string_view after);

}  // namespace robochart::app
