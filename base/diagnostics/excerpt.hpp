// SPDX-License-Identifier: Apache-2.0
// One source line with a marked range, prepared for a terminal.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace robochart::diagnostics {

/// A shown line: `text`, and the range of the mark below it (in shown columns from 0).
struct Excerpt {
    std::string text;
    std::size_t mark_begin = 0;
    std::size_t mark_width = 1;
};

/// Expands tabs to multiples of four, replaces control characters and bytes that are not UTF-8, and cuts lines wider
/// than `max_width` around the mark. `begin` and `end` are byte offsets in the line.
[[nodiscard]] Excerpt make_excerpt(std::string_view line, std::size_t begin, std::size_t end, std::size_t max_width);

}  // namespace robochart::diagnostics
