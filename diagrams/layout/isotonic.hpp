// Places on a line that keep their order and their distances, as near as possible to where they want to be.
#pragma once

#include <span>
#include <vector>

namespace robochart::diagrams::layout {

/// One of the things to be placed.
struct Wish {
    double wanted = 0;
    double weight = 1;  ///< above 0
    double gap = 0;     ///< at least so far behind the one before
};

/// Minimises the sum of weight * (place - wanted)^2: isotonic regression by pooling adjacent violators (Barlow,
/// Bartholomew, Bremner, Brunk: Statistical inference under order restrictions, 1972).
[[nodiscard]] std::vector<double> nearest_places(std::span<const Wish> wishes);

/// The same between two bounds that are far enough apart; where they are not, evenly between them.
[[nodiscard]] std::vector<double> nearest_places(std::span<const Wish> wishes, double low, double high);

}  // namespace robochart::diagrams::layout
