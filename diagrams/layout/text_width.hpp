// How wide text is, and text broken into lines: by the widths of DejaVu Sans, without a font at hand.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace robochart::diagrams::layout {

/// What fonts that stand in for DejaVu Sans may be wider.
inline constexpr double font_slack = 1.06;

/// Width of UTF-8 text in pixels, with the slack. A byte that is no UTF-8 counts as a character of one em.
[[nodiscard]] double text_width(std::string_view text, double font_size, bool bold = false);

/// Text in lines, perhaps not all of it.
struct Lines {
    std::vector<std::string> lines;
    bool elided = false;  ///< the last line ends with an ellipsis: there was more
};

/// How text is broken.
struct LineLimits {
    std::size_t columns = 34;  ///< characters of a line, where the text has a blank to be broken at
    std::size_t lines = 6;     ///< what is longer is elided
};

/// Pieces one behind the other, broken between pieces where they do not fit into one line, then at blanks, then
/// anywhere.
[[nodiscard]] Lines broken(const std::vector<std::string>& pieces, const LineLimits& limits);

/// The front of a text, with an ellipsis where something is missing.
[[nodiscard]] std::string elided(std::string_view text, std::size_t columns);

}  // namespace robochart::diagrams::layout
