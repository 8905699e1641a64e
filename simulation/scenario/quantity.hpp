// SPDX-License-Identifier: Apache-2.0
// Numbers with units. Internally, lengths are in centimetres, times in seconds, angles in radians; fractions and counts
// are plain numbers.
#pragma once

#include <optional>
#include <string_view>

#include "base/diagnostics/source.hpp"

namespace robochart::simulation {

enum class Dimension { number, share, length, area, time, angle, speed, turn_rate };

/// "a length (mm, cm, m)".
[[nodiscard]] std::string_view describe_dimension(Dimension);

/// The unit printed after a number in results: " s", " cm", " %"; "" for other dimensions.
[[nodiscard]] std::string_view printed_unit(Dimension);

struct Unit {
    Dimension dimension = Dimension::number;
    double factor = 1;  ///< to the internal unit
};

/// "cm", "s", "cm/s", "%"; no value for other words.
[[nodiscard]] std::optional<Unit> unit_named(std::string_view);

/// A written number in the internal unit.
struct Quantity {
    double value = 0;
    Dimension dimension = Dimension::number;  ///< the dimension of the written unit
    diagnostics::Span span;
};

}  // namespace robochart::simulation
