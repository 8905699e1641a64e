// SPDX-License-Identifier: Apache-2.0
// Positions on a line that keep a given order and minimum gaps, and are as near as possible to wanted positions.
#pragma once

#include <span>
#include <vector>

namespace robochart::diagrams::layout {

/// An item to be placed.
struct Wish {
    double wanted = 0;
    double weight = 1;  ///< above 0
    double gap = 0;     ///< minimum distance from the item before
};

/// Minimises the sum of weight * (place - wanted)^2: isotonic regression by pooling adjacent violators (Barlow,
/// Bartholomew, Bremner, Brunk: Statistical inference under order restrictions, 1972).
[[nodiscard]] std::vector<double> nearest_places(std::span<const Wish> wishes);

/// Minimises the same sum with all positions between two bounds. If the bounds are too close together, the items are
/// distributed evenly.
[[nodiscard]] std::vector<double> nearest_places(std::span<const Wish> wishes, double low, double high);

}  // namespace robochart::diagrams::layout
