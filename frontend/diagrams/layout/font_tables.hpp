// SPDX-License-Identifier: Apache-2.0
// Lists the widths of the characters of DejaVu Sans, the preferred font of diagrams.
#pragma once

#include <cstdint>
#include <span>

namespace robochart::diagrams::layout {

/// The number of font units of an em.
inline constexpr double units_of_em = 2048;

/// The widths of consecutive characters, in regular and bold. Oblique characters have the width of regular ones.
struct WidthRange {
    std::uint32_t first, last;
    const std::uint16_t* regular;
    const std::uint16_t* bold;
};

/// Returns the ranges in ascending order. A character outside all ranges is assumed to be one em wide.
[[nodiscard]] std::span<const WidthRange> width_ranges();

}  // namespace robochart::diagrams::layout
