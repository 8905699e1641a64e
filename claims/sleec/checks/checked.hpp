// SPDX-License-Identifier: Apache-2.0
// Rules after name resolution and type checking: events and measures are numbers, constants are values, times are
// whole numbers of steps. A step is a second, or a time unit of the model if its length is declared.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/durations/time_unit.hpp"
#include "claims/sleec/syntax/syntax.hpp"

namespace robochart::sleec {

/// A condition with resolved names. Truth values are 0 and 1; values of a scale are indices from 0.
struct Condition {
    Op op = Op::number;       ///< `number`: `value`; `name`: the measure
    std::int64_t value = 0;   ///< the value of a number
    std::size_t measure = 0;  ///< the measure of a name
    std::vector<Condition> parts;
    const Expr* written = nullptr;
};

/// A value for each measure of the file.
using Valuation = std::vector<std::int64_t>;
/// The value of a condition, or of a number in it.
[[nodiscard]] std::int64_t evaluate_condition(const Condition& condition, const Valuation& values);

struct Duty;
using DutyPtr = std::shared_ptr<const Duty>;

struct CheckedDefeater {
    Condition condition;               ///< over measures; unused if an event defeats
    std::optional<std::size_t> event;  ///< extension: this event ends the duty
    DutyPtr duty;                      ///< null: no duty is left
    const Defeater* written = nullptr;
};

/// The demand of a response.
struct Duty {
    bool forbids = false;
    std::size_t event = 0;
    std::int64_t from = 0;           ///< steps
    std::optional<std::int64_t> to;  ///< steps, inclusive; no value: no limit. Below `from`: the duty is empty
    bool measured = false;           ///< a measure determines the limit: `from` and `to` are unknown
    DutyPtr otherwise;               ///< null: none
    std::vector<CheckedDefeater> defeaters;
    const Response* written = nullptr;
};

struct CheckedRule {
    std::size_t trigger = 0;
    std::optional<Condition> condition;
    DutyPtr duty;
    bool assumed = false;
    const Rule* written = nullptr;
};

struct CheckedProperty {
    bool exists = false;
    std::size_t trigger = 0;
    std::optional<Condition> condition;
    DutyPtr duty;                       ///< null: no demand
    std::optional<std::size_t> during;  ///< `while` this event
    std::optional<Condition> during_condition;
    const Property* written = nullptr;
};

/// A file that satisfies the rules of the language.
struct CheckedRules {
    std::shared_ptr<const RuleFile> file;  ///< owner of the data to which `written` points
    std::vector<CheckedRule> rules;
    std::vector<CheckedProperty> concerns, purposes;
    durations::Unit unit;  ///< the length of a step; no value: a step is a second

    [[nodiscard]] const std::string& event_name(std::size_t index) const { return file->events[index].name.text; }
    [[nodiscard]] const Measure& measure(std::size_t index) const { return file->measures[index]; }
    [[nodiscard]] const std::string& name(std::size_t rule) const { return rules[rule].written->name.text; }
};

/// "second 3"; with a time unit "t=30 (3.0 s)".
[[nodiscard]] std::string instant_text(const CheckedRules& rules, std::int64_t step);
/// "3 seconds"; with a time unit "30 units (3 s)".
[[nodiscard]] std::string steps_text(const CheckedRules& rules, std::int64_t steps);
/// "near", "level = 3", "load = high": a measure with its value, for messages.
[[nodiscard]] std::string value_text(const Measure& measure, std::int64_t value);

}  // namespace robochart::sleec
