// SPDX-License-Identifier: Apache-2.0
// Converts between time units and times, and prints both.
#include "base/durations/time_unit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace robochart::durations {
namespace {

/// Returns the decimal number with at least `least` decimal places.
std::string decimal_text(std::int64_t number, std::int64_t of_one, std::size_t least = 0) {
    std::string result = fmt::format("{}", number / of_one);
    std::int64_t rest = number % of_one;
    if (rest == 0 && least == 0) return result;
    result += '.';
    for (std::size_t places = 0; rest != 0 || places < least; ++places) {
        rest *= 10;
        result += static_cast<char>('0' + rest / of_one);
        rest %= of_one;
    }
    return result;
}

/// Returns the number of decimal places of a time in seconds.
std::size_t decimals_of(std::int64_t nanoseconds) {
    std::size_t places = 9;
    while (places > 0 && nanoseconds % 10 == 0) {
        nanoseconds /= 10;
        --places;
    }
    return places;
}

}  // namespace

std::string duration_text(std::int64_t nanoseconds) {
    if (nanoseconds >= second || nanoseconds == 0) return decimal_text(nanoseconds, second) + " s";
    return decimal_text(nanoseconds, millisecond) + " ms";
}

std::string seconds_text(std::int64_t nanoseconds) {
    return decimal_text(nanoseconds, second);
}

std::string units_text(std::int64_t units, Unit unit) {
    const std::string text = fmt::format("{} unit{}", units, units == 1 ? "" : "s");
    std::int64_t nanoseconds = 0;
    if (!unit || __builtin_mul_overflow(units, *unit, &nanoseconds)) return text;
    return fmt::format("{} ({})", text, duration_text(nanoseconds));
}

std::string time_text(std::int64_t time, Unit unit) {
    const std::string text = fmt::format("t={}", time);
    std::int64_t nanoseconds = 0;
    if (!unit || __builtin_mul_overflow(time, *unit, &nanoseconds)) return text;
    return fmt::format("{} ({} s)", text, decimal_text(nanoseconds, second, decimals_of(*unit)));
}

std::string second_text(Unit unit) {
    if (!unit)
        return "1 second = 1 time unit (no .claims file declares the length of a time unit, such as `unit 0.1 s`)";
    if (second % *unit == 0) return fmt::format("1 second = {}", units_text(second / *unit, {}));
    return fmt::format("1 time unit = {}", duration_text(*unit));
}

std::optional<std::int64_t> nanoseconds_of_seconds(std::string_view text) {
    const std::size_t point = std::min(text.find('.'), text.size());
    const std::string_view whole = text.substr(0, point);
    const std::string_view fraction = text.substr(std::min(point + 1, text.size()));
    const auto is_number = [](std::string_view digits) {
        return std::ranges::all_of(digits, [](char c) { return c >= '0' && c <= '9'; });
    };
    constexpr std::size_t most_whole = 10, most_fraction = 9;
    if (whole.empty() || !is_number(whole) || !is_number(fraction)) return std::nullopt;
    if (whole.size() > most_whole || fraction.size() > most_fraction) return std::nullopt;
    std::int64_t result = 0;
    for (const char c : whole) result = 10 * result + (c - '0');
    if (result > longest / second) return std::nullopt;
    for (std::size_t i = 0; i < most_fraction; ++i)
        result = 10 * result + (i < fraction.size() ? fraction[i] - '0' : 0);
    return result > longest ? std::nullopt : std::optional(result);
}

std::optional<std::int64_t> nanoseconds_of_seconds(double seconds) {
    const double nanoseconds = seconds * static_cast<double>(second);
    if (!(nanoseconds >= 0 && nanoseconds <= static_cast<double>(longest))) return std::nullopt;
    return std::llround(nanoseconds);
}

UnitCount count_units(std::int64_t nanoseconds, std::int64_t unit) {
    const std::int64_t below = nanoseconds / unit;
    if (nanoseconds % unit == 0) return {below, ""};
    return {0, fmt::format("{} is not a multiple of the time unit {}: the neighbours are {} and {}; `unit {}` would do",
                           duration_text(nanoseconds), duration_text(unit), duration_text(below * unit),
                           duration_text((below + 1) * unit), duration_text(std::gcd(nanoseconds, unit)))};
}

}  // namespace robochart::durations
