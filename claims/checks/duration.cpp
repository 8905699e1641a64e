// SPDX-License-Identifier: Apache-2.0
// See duration.hpp.
#include "claims/checks/duration.hpp"

#include <fmt/format.h>

#include <utility>

#include "claims/checks/fraction.hpp"

namespace robochart::claims {
namespace {

std::int64_t nanoseconds_of(TimeUnit unit) {
    switch (unit) {
        case TimeUnit::none:
        case TimeUnit::units:
            return 0;
        case TimeUnit::milliseconds:
            return durations::millisecond;
        case TimeUnit::seconds:
            return durations::second;
        case TimeUnit::minutes:
            return 60 * durations::second;
        case TimeUnit::hours:
            return 3600 * durations::second;
    }
    return 0;
}

}  // namespace

std::optional<std::int64_t> nanoseconds_of(const Duration& duration) {
    try {
        const Fraction result = Fraction::of_decimal(duration.number) * Fraction(nanoseconds_of(duration.unit));
        if (!result.is_whole() || result.numerator() > durations::longest) return std::nullopt;
        return result.numerator();
    } catch (const NotComputable&) {
        return std::nullopt;
    }
}

durations::UnitCount units_of(const Duration& duration, durations::Unit unit) {
    const auto error = [](std::string text) { return durations::UnitCount{0, std::move(text)}; };
    if (duration.negative) return error("a duration is not negative");
    if (duration.unit == TimeUnit::none)
        return error(fmt::format("a duration has a unit: write `{} units`, or a time such as `{} s`", duration.number,
                                 duration.number));
    const std::string most = fmt::format("at most {} time units are decided", most_units);
    if (duration.unit == TimeUnit::units) {
        const Fraction count = Fraction::of_decimal(duration.number);
        if (!count.is_whole()) return error("the number of time units is whole");
        return count.numerator() > most_units ? error(most) : durations::UnitCount{count.numerator(), ""};
    }
    if (!unit)
        return error(
            "how long is a time unit? Declare it before the claims, such as `unit 0.1 s`, or write `units` here");
    const std::optional<std::int64_t> length = nanoseconds_of(duration);
    if (!length) return error("the duration is finer than a nanosecond or longer than a century");
    return *length / *unit > most_units ? error(most) : durations::count_units(*length, *unit);
}

}  // namespace robochart::claims
