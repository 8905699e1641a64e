// SPDX-License-Identifier: Apache-2.0
// See checked.hpp.
#include "claims/sleec/checks/checked.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace robochart::sleec {
namespace {

/// The bound on values. Sums and products of the numbers in a text are far below this bound.
constexpr std::int64_t largest = 4'000'000'000'000'000'000;

std::int64_t saturate_overflow(std::int64_t value, bool overflow, bool negative) {
    if (overflow) return negative ? -largest : largest;
    return std::clamp(value, -largest, largest);
}

std::int64_t saturating_sum(std::int64_t a, std::int64_t b) {
    std::int64_t result = 0;
    const bool overflow = __builtin_add_overflow(a, b, &result);
    return saturate_overflow(result, overflow, a < 0);
}

std::int64_t saturating_product(std::int64_t a, std::int64_t b) {
    std::int64_t result = 0;
    const bool overflow = __builtin_mul_overflow(a, b, &result);
    return saturate_overflow(result, overflow, (a < 0) != (b < 0));
}

}  // namespace

std::int64_t evaluate_condition(const Condition& condition, const Valuation& values) {
    const auto part = [&](std::size_t i) { return evaluate_condition(condition.parts[i], values); };
    switch (condition.op) {
        case Op::truth:
        case Op::number:
            return condition.value;
        case Op::name:
        case Op::in_state:
            return values[condition.measure];
        case Op::disjunction:
            return static_cast<std::int64_t>(part(0) != 0 || part(1) != 0);
        case Op::conjunction:
            return static_cast<std::int64_t>(part(0) != 0 && part(1) != 0);
        case Op::negation:
            return static_cast<std::int64_t>(part(0) == 0);
        case Op::less:
            return static_cast<std::int64_t>(part(0) < part(1));
        case Op::less_equal:
            return static_cast<std::int64_t>(part(0) <= part(1));
        case Op::greater:
            return static_cast<std::int64_t>(part(0) > part(1));
        case Op::greater_equal:
            return static_cast<std::int64_t>(part(0) >= part(1));
        case Op::equal:
            return static_cast<std::int64_t>(part(0) == part(1));
        case Op::unequal:
            return static_cast<std::int64_t>(part(0) != part(1));
        case Op::add:
            return saturating_sum(part(0), part(1));
        case Op::subtract:
            return saturating_sum(part(0), saturating_product(-1, part(1)));
        case Op::multiply:
            return saturating_product(part(0), part(1));
    }
    return 0;
}

std::string CheckedRules::event_name(const EventCases& cases) const {
    EventCase whole = events[*cases.begin()];
    if (cases.size() == 1) return whole.text;
    std::string text;
    for (std::size_t i = 0; i < whole.values.size(); ++i) {
        const bool fixed =
            std::ranges::all_of(cases, [&](std::size_t event) { return events[event].values[i] == whole.values[i]; });
        text += fmt::format("{}{}", i == 0 ? "" : ", ", fixed && !whole.values[i].empty() ? whole.values[i] : "_");
    }
    return fmt::format("{}({})", declared_name(*cases.begin()), text);
}

std::optional<std::size_t> CheckedRules::case_of(std::size_t declared, const std::vector<std::string>& values) const {
    const std::vector<Argument>& places = arguments[declared];
    if (values.size() != places.size()) return std::nullopt;
    std::vector<std::string> known;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const bool named = std::ranges::find(places[i].values, values[i]) != places[i].values.end();
        known.push_back(named ? values[i] : "");
    }
    for (std::size_t i = 0; i < events.size(); ++i)
        if (events[i].declared == declared && events[i].values == known) return i;
    return std::nullopt;
}

std::string instant_text(const CheckedRules& rules, std::int64_t step) {
    return rules.unit ? durations::time_text(step, rules.unit) : fmt::format("second {}", step);
}

std::string steps_text(const CheckedRules& rules, std::int64_t steps) {
    if (rules.unit) return durations::units_text(steps, rules.unit);
    return fmt::format("{} second{}", steps, steps == 1 ? "" : "s");
}

std::string value_text(const Measure& measure, std::int64_t value) {
    if (measure.type == MeasureType::boolean)
        return value != 0 ? measure.name.text : fmt::format("not {}", measure.name.text);
    if (measure.type == MeasureType::numeric) return fmt::format("{} = {}", measure.name.text, value);
    return fmt::format("{} = {}", measure.name.text, measure.literals[static_cast<std::size_t>(value)].text);
}

}  // namespace robochart::sleec
