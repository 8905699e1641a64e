// SPDX-License-Identifier: Apache-2.0
// Represents the length of a time unit, and converts durations to exact numbers of units (docs/claims.md, "One unit").
// Models count time units; claims, rules, scenarios, messages and reports contain times.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace robochart::durations {

inline constexpr std::int64_t millisecond = 1'000'000;
inline constexpr std::int64_t second = 1000 * millisecond;
/// The longest time that can be represented: a hundred years.
inline constexpr std::int64_t longest = 100LL * 366 * 24 * 3600 * second;

/// The length of a time unit in nanoseconds. It has no value if the unit is not declared.
using Unit = std::optional<std::int64_t>;

/// Returns a text such as "100 ms" or "2.5 s".
[[nodiscard]] std::string duration_text(std::int64_t nanoseconds);
/// Returns a time in seconds as a decimal number, such as "0.1" or "2.5".
[[nodiscard]] std::string seconds_text(std::int64_t nanoseconds);
/// Returns a text such as "30 units (3 s)" or "1 unit". Without a declared unit, it contains only the units.
[[nodiscard]] std::string units_text(std::int64_t units, Unit unit);
/// Returns a text such as "t=30 (3.0 s)". It has the decimals of the unit, so that all times of a report have the same
/// number of decimals. Without a declared unit, the text is "t=30".
[[nodiscard]] std::string time_text(std::int64_t time, Unit unit);

/// Converts a decimal number of seconds, such as "0.1", to nanoseconds. Returns no value for other texts, for times
/// finer than a nanosecond, and for times longer than `longest`.
[[nodiscard]] std::optional<std::int64_t> nanoseconds_of_seconds(std::string_view text);
/// Converts a number of seconds that was read from a short decimal to nanoseconds. Returns no value for times longer
/// than `longest`.
[[nodiscard]] std::optional<std::int64_t> nanoseconds_of_seconds(double seconds);

/// A whole number of time units, or the reason why the time is not a whole number of units.
struct UnitCount {
    std::int64_t units = 0;
    std::string error;  ///< "" if there is no error
};
/// Converts a time of at least 0 to a number of units. A time that is not a multiple of the unit is an error, and the
/// error names both neighbours. The time is never rounded, because rounding down is wrong for lower limits, and
/// rounding up is wrong for upper limits.
[[nodiscard]] UnitCount count_units(std::int64_t nanoseconds, std::int64_t unit);

/// Returns a text about the length of a second in rules: "1 second = 10 units". If no unit is declared, the text states
/// that a second is one time unit.
[[nodiscard]] std::string second_text(Unit unit);

}  // namespace robochart::durations
