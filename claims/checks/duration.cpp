// SPDX-License-Identifier: Apache-2.0
// See duration.hpp.
#include "claims/checks/duration.hpp"

#include <fmt/format.h>

#include <numeric>

#include "claims/checks/fraction.hpp"

namespace robochart::claims {
namespace {

constexpr std::int64_t millisecond = 1'000'000;
constexpr std::int64_t second = 1000 * millisecond;
constexpr std::int64_t longest = 100LL * 366 * 24 * 3600 * second;

std::int64_t nanoseconds_of(TimeUnit unit) {
    switch (unit) {
        case TimeUnit::none:
        case TimeUnit::units:
            return 0;
        case TimeUnit::milliseconds:
            return millisecond;
        case TimeUnit::seconds:
            return second;
        case TimeUnit::minutes:
            return 60 * second;
        case TimeUnit::hours:
            return 3600 * second;
    }
    return 0;
}

std::string decimal_text(std::int64_t number, std::int64_t of_one) {
    std::string result = fmt::format("{}", number / of_one);
    std::int64_t rest = number % of_one;
    if (rest == 0) return result;
    result += '.';
    while (rest != 0) {
        rest *= 10;
        result += static_cast<char>('0' + rest / of_one);
        rest %= of_one;
    }
    return result;
}

}  // namespace

std::optional<std::int64_t> nanoseconds_of(const Duration& duration) {
    try {
        const Fraction result = Fraction::of_decimal(duration.number) * Fraction(nanoseconds_of(duration.unit));
        if (!result.is_whole() || result.numerator() > longest) return std::nullopt;
        return result.numerator();
    } catch (const NotComputable&) {
        return std::nullopt;
    }
}

std::string duration_text(std::int64_t nanoseconds) {
    if (nanoseconds >= second || nanoseconds == 0) return decimal_text(nanoseconds, second) + " s";
    return decimal_text(nanoseconds, millisecond) + " ms";
}

std::string units_text(std::int64_t units, std::optional<std::int64_t> unit) {
    const std::string text = fmt::format("{} unit{}", units, units == 1 ? "" : "s");
    std::int64_t nanoseconds = 0;
    if (!unit || __builtin_mul_overflow(units, *unit, &nanoseconds)) return text;
    return fmt::format("{} ({})", text, duration_text(nanoseconds));
}

UnitCount units_of(const Duration& duration, std::optional<std::int64_t> unit) {
    const auto error = [](std::string text) { return UnitCount{0, std::move(text)}; };
    if (duration.negative) return error("a duration is not negative");
    if (duration.unit == TimeUnit::none)
        return error(fmt::format("a duration has a unit: write `{} units`, or a time such as `{} s`", duration.number,
                                 duration.number));
    const std::string most = fmt::format("at most {} time units are decided", most_units);
    if (duration.unit == TimeUnit::units) {
        const Fraction count = Fraction::of_decimal(duration.number);
        if (!count.is_whole()) return error("the number of time units is whole");
        return count.numerator() > most_units ? error(most) : UnitCount{count.numerator(), ""};
    }
    if (!unit)
        return error(
            "how long is a time unit? Declare it before the claims, such as `unit 0.1 s`, or write `units` here");
    const std::optional<std::int64_t> length = nanoseconds_of(duration);
    if (!length) return error("the duration is finer than a nanosecond or longer than a century");
    const std::int64_t below = *length / *unit;
    if (below > most_units) return error(most);
    if (*length % *unit == 0) return {below, ""};
    return error(
        fmt::format("{} is not a multiple of the time unit {}: the neighbours are {} and {}; `unit {}` would do",
                    duration_text(*length), duration_text(*unit), duration_text(below * *unit),
                    duration_text((below + 1) * *unit), duration_text(std::gcd(*length, *unit))));
}

}  // namespace robochart::claims
