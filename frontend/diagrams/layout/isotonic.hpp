// SPDX-License-Identifier: Apache-2.0
// Places items on a line in a given order with minimum gaps, as near as possible to their wanted positions.
#pragma once

#include <span>
#include <vector>

namespace robochart::diagrams::layout {

/// An item to be placed.
struct Wish {
    double wanted = 0;
    double weight = 1;  ///< greater than 0
    double gap = 0;     ///< minimum distance from the item before
};

/// Returns the positions that minimise the sum of weight * (place - wanted)^2. This is isotonic regression, computed by
/// pooling adjacent violators (Barlow, Bartholomew, Bremner, Brunk: Statistical inference under order restrictions,
/// 1972).
[[nodiscard]] std::vector<double> nearest_places(std::span<const Wish> wishes);

/// Minimises the same sum for positions between two bounds. If the bounds are too close together, the items are
/// distributed evenly.
[[nodiscard]] std::vector<double> nearest_places(std::span<const Wish> wishes, double low, double high);

}  // namespace robochart::diagrams::layout
