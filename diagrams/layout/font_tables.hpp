// The widths of the characters of DejaVu Sans, the font that diagrams name first.
#pragma once

#include <cstdint>
#include <span>

namespace robochart::diagrams::layout {

/// Of how many parts the widths are: the em of the font.
inline constexpr double units_of_em = 2048;

/// The widths of consecutive characters, in regular and in bold (oblique letters are as wide as regular ones).
struct WidthRange {
    std::uint32_t first, last;
    const std::uint16_t* regular;
    const std::uint16_t* bold;
};

/// In ascending order. A character in no range is taken to be an em wide.
[[nodiscard]] std::span<const WidthRange> width_ranges();

}  // namespace robochart::diagrams::layout
