// SPDX-License-Identifier: Apache-2.0
// Computes the width of text and breaks text into lines. The widths are those of DejaVu Sans, and no font is loaded.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace robochart::diagrams::layout {

/// A factor for substitute fonts that are wider than DejaVu Sans.
inline constexpr double font_slack = 1.06;

/// Returns the width of UTF-8 text in pixels, including the allowance. A byte that is not UTF-8 counts as a character
/// of one em.
[[nodiscard]] double text_width(std::string_view text, double font_size, bool bold = false);

/// Text broken into lines, possibly shortened.
struct Lines {
    std::vector<std::string> lines;
    bool elided = false;  ///< text is missing; the last line ends with an ellipsis
};

/// Limits for breaking text.
struct LineLimits {
    std::size_t columns = 34;  ///< characters per line, if the text can be broken at a blank
    std::size_t lines = 6;     ///< longer text is elided
};

/// Joins pieces and breaks them into lines: between pieces if possible, otherwise at blanks, otherwise anywhere.
[[nodiscard]] Lines break_lines(const std::vector<std::string>& pieces, const LineLimits& limits);

/// Returns the beginning of a text, with an ellipsis if characters are missing.
[[nodiscard]] std::string elide_text(std::string_view text, std::size_t columns);

}  // namespace robochart::diagrams::layout
