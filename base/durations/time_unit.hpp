// SPDX-License-Identifier: Apache-2.0
// The length of a time unit, and durations as exact numbers of it (docs/claims.md, "One unit"). Models count time
// units; claims, rules, scenarios, messages and reports name times.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace robochart::durations {

inline constexpr std::int64_t millisecond = 1'000'000;
inline constexpr std::int64_t second = 1000 * millisecond;
/// The longest time that is computed: a hundred years.
inline constexpr std::int64_t longest = 100LL * 366 * 24 * 3600 * second;

/// The length of a time unit in nanoseconds; no value if it is not declared.
using Unit = std::optional<std::int64_t>;

/// "100 ms", "2.5 s".
[[nodiscard]] std::string duration_text(std::int64_t nanoseconds);
/// "0.1", "2.5": a time in seconds as a decimal number.
[[nodiscard]] std::string seconds_text(std::int64_t nanoseconds);
/// "30 units (3 s)", "1 unit"; without a declared unit only the units.
[[nodiscard]] std::string units_text(std::int64_t units, Unit unit);
/// "t=30 (3.0 s)", with the decimals of the unit, so that times of one report have equal lengths; without a declared
/// unit "t=30".
[[nodiscard]] std::string time_text(std::int64_t time, Unit unit);

/// The nanoseconds of a decimal number of seconds, such as "0.1"; no value for other texts, and for times that are
/// finer than a nanosecond or longer than `longest`.
[[nodiscard]] std::optional<std::int64_t> nanoseconds_of_seconds(std::string_view text);
/// The nanoseconds of a number of seconds that was read from a short decimal; no value beyond `longest`.
[[nodiscard]] std::optional<std::int64_t> nanoseconds_of_seconds(double seconds);

/// A whole number of time units, or the reason why there is none.
struct UnitCount {
    std::int64_t units = 0;
    std::string error;  ///< "" if there is none
};
/// Converts a time of at least 0 to a number of units. A time that is not a multiple of the unit is an error, and the
/// error names both neighbours. The time is never rounded, because rounding down is wrong for lower limits, and
/// rounding up is wrong for upper limits.
[[nodiscard]] UnitCount count_units(std::int64_t nanoseconds, std::int64_t unit);

/// States the length of a second in rules: "1 second = 10 units", or that a second is one time unit because no unit is
/// declared.
[[nodiscard]] std::string second_text(Unit unit);

}  // namespace robochart::durations
