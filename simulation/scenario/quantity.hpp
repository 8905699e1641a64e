// SPDX-License-Identifier: Apache-2.0
// Represents numbers with units. Internally, lengths are in centimetres, times in seconds, angles in radians; fractions
// and counts are plain numbers.
#pragma once

#include <optional>
#include <string_view>

#include "base/diagnostics/source.hpp"

namespace robochart::simulation {

enum class Dimension { number, share, length, area, time, angle, speed, turn_rate };

/// Returns a text such as "a length (mm, cm, m)".
[[nodiscard]] std::string_view describe_dimension(Dimension);

/// Returns the unit printed after a number in results: " s", " cm" or " %"; "" for other dimensions.
[[nodiscard]] std::string_view printed_unit(Dimension);

struct Unit {
    Dimension dimension = Dimension::number;
    double factor = 1;  ///< factor to the internal unit
};

/// Returns the unit with this name, such as "cm", "s", "cm/s" or "%"; no value for other words.
[[nodiscard]] std::optional<Unit> unit_named(std::string_view);

/// A number from the text, converted to the internal unit.
struct Quantity {
    double value = 0;
    Dimension dimension = Dimension::number;  ///< the dimension of the written unit
    diagnostics::Span span;
};

}  // namespace robochart::simulation
