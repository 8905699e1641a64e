// SPDX-License-Identifier: Apache-2.0
// Durations as exact numbers of nanoseconds and of time units (docs/claims.md, "One unit").
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "claims/syntax/syntax.hpp"

namespace robochart::claims {

/// The longest duration that is decided, in time units.
inline constexpr std::int64_t most_units = 10'000;

/// The nanoseconds of a duration in seconds, minutes or hours. No value if it is finer than a nanosecond or longer
/// than a hundred years.
[[nodiscard]] std::optional<std::int64_t> nanoseconds_of(const Duration& duration);

/// "100 ms", "2.5 s".
[[nodiscard]] std::string duration_text(std::int64_t nanoseconds);

/// "30 units (3 s)", "1 unit"; without a declared unit only the units.
[[nodiscard]] std::string units_text(std::int64_t units, std::optional<std::int64_t> unit);

/// The number of units of a duration, or the reason why there is none.
struct UnitCount {
    std::int64_t units = 0;
    std::string error;  ///< "" if there is none
};
/// `unit`: the nanoseconds of one time unit, if declared.
[[nodiscard]] UnitCount units_of(const Duration& duration, std::optional<std::int64_t> unit);

}  // namespace robochart::claims
