// SPDX-License-Identifier: Apache-2.0
// Prepares one source line with a marked range for a terminal.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace robochart::diagnostics {

/// The line as it is shown: its text, and the range of the mark below it (in columns of the text, from 0).
struct Excerpt {
    std::string text;
    std::size_t mark_begin = 0;
    std::size_t mark_width = 1;
};

/// Expands tabs to multiples of four, and replaces control characters and bytes that are not UTF-8. Lines wider than
/// `max_width` are cut around the mark. `begin` and `end` are byte offsets in the line.
[[nodiscard]] Excerpt make_excerpt(std::string_view line, std::size_t begin, std::size_t end, std::size_t max_width);

}  // namespace robochart::diagnostics
