// SPDX-License-Identifier: Apache-2.0
// Converts durations of claims to exact numbers of nanoseconds and of time units (docs/claims.md, "One unit").
#pragma once

#include <cstdint>
#include <optional>

#include "base/durations/time_unit.hpp"
#include "claims/syntax/syntax.hpp"

namespace robochart::claims {

/// The longest duration, in time units, for which claims are decided.
inline constexpr std::int64_t most_units = 10'000;

/// Returns the nanoseconds of a duration in seconds, minutes or hours. Returns no value if the duration is not a whole
/// number of nanoseconds, or is longer than a hundred years.
[[nodiscard]] std::optional<std::int64_t> nanoseconds_of(const Duration& duration);

/// Returns the number of time units of a duration, or the reason why the duration has none.
[[nodiscard]] durations::UnitCount units_of(const Duration& duration, durations::Unit unit);

}  // namespace robochart::claims
