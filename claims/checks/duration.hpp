// SPDX-License-Identifier: Apache-2.0
// Durations of claims as exact numbers of nanoseconds and of time units (docs/claims.md, "One unit").
#pragma once

#include <cstdint>
#include <optional>

#include "base/durations/time_unit.hpp"
#include "claims/syntax/syntax.hpp"

namespace robochart::claims {

/// The longest duration that is decided, in time units.
inline constexpr std::int64_t most_units = 10'000;

/// The nanoseconds of a duration in seconds, minutes or hours. No value if it is finer than a nanosecond or longer
/// than a hundred years.
[[nodiscard]] std::optional<std::int64_t> nanoseconds_of(const Duration& duration);

/// The number of units of a duration, or the reason why there is none.
[[nodiscard]] durations::UnitCount units_of(const Duration& duration, durations::Unit unit);

}  // namespace robochart::claims
