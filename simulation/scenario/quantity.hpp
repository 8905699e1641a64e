// Numbers with units. Inside, lengths are centimetres, times seconds, angles radians, shares and counts plain numbers.
#pragma once

#include <optional>
#include <string_view>

#include "diagnostics/source.hpp"

namespace robochart::simulation {

enum class Dimension { number, share, length, area, time, angle, speed, turn_rate };

/// "a length (mm, cm, m)".
[[nodiscard]] std::string_view described(Dimension);

/// What is printed behind a number of a result: " s", " cm", " %"; "" of other dimensions.
[[nodiscard]] std::string_view printed_unit(Dimension);

struct Unit {
    Dimension dimension = Dimension::number;
    double factor = 1;  ///< to the unit used inside
};

/// "cm", "s", "cm/s", "%"; nothing for other words.
[[nodiscard]] std::optional<Unit> unit_named(std::string_view);

/// As written, in the unit used inside.
struct Quantity {
    double value = 0;
    Dimension dimension = Dimension::number;  ///< of the unit that is written
    diagnostics::Span span;
};

}  // namespace robochart::simulation
