// SPDX-License-Identifier: Apache-2.0
// Transforms texts.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace robochart::diagnostics {

/// Replaces every sequence of blanks and line ends by one blank, and removes those at both ends; for titles and
/// excerpts.
[[nodiscard]] std::string on_one_line(std::string_view text);

/// Joins items with ", ". Three or more equal neighbours are written once, with their number: `30 times 0.5, 1`.
[[nodiscard]] std::string join_equal(const std::vector<std::string>& items);

/// Replaces every @KEY@ in the text by its value. The values are not searched again.
[[nodiscard]] std::string fill_template(const std::string& text, const std::map<std::string, std::string>& keys);

}  // namespace robochart::diagnostics
