// SPDX-License-Identifier: Apache-2.0
// Defines rules after name resolution and type checking. Events and measures are numbers, constants are values, times
// are whole numbers of steps. A step is a second, or a time unit of the model if its length is declared.
//
// An event with arguments is represented by several events, its cases. There is one case for each combination of values
// that the file names, and further cases for other values. A state of the model is a boolean measure, which the model
// decides.
#pragma once

#include <algorithm>
#include <compare>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
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
/// Returns the value of a condition, or of a number in it.
[[nodiscard]] std::int64_t evaluate_condition(const Condition& condition, const Valuation& values);

/// The cases of an event that an event in a rule denotes. There is one case, unless an argument in the rule is `_`.
/// Several cases differ only in the arguments that are `_` in the rule.
class EventCases {
public:
    // NOLINTNEXTLINE(google-explicit-constructor): an event without arguments is its only case
    EventCases(std::size_t only = 0) : cases_{only} {}
    /// `cases` are ascending and not empty.
    explicit EventCases(std::vector<std::size_t> cases) : cases_(std::move(cases)) {}

    [[nodiscard]] bool contains(std::size_t event) const { return std::ranges::find(cases_, event) != cases_.end(); }
    [[nodiscard]] bool meets(const EventCases& other) const {
        return std::ranges::any_of(cases_, [&](std::size_t event) { return other.contains(event); });
    }
    [[nodiscard]] std::size_t size() const { return cases_.size(); }
    [[nodiscard]] auto begin() const { return cases_.begin(); }
    [[nodiscard]] auto end() const { return cases_.end(); }

    friend auto operator<=>(const EventCases&, const EventCases&) = default;

private:
    std::vector<std::size_t> cases_;
};

struct Duty;
using DutyPtr = std::shared_ptr<const Duty>;

struct CheckedDefeater {
    Condition condition;              ///< condition on measures; unused if `event` is set
    std::optional<EventCases> event;  ///< extension: this event ends the duty
    DutyPtr duty;                     ///< null if no duty is left
    const Defeater* written = nullptr;
};

/// The demand of a response.
struct Duty {
    bool forbids = false;
    EventCases event;
    std::int64_t from = 0;           ///< steps
    std::optional<std::int64_t> to;  ///< steps, inclusive; no value: no limit. If below `from`, the duty is empty
    bool measured = false;           ///< a measure determines the limit: `from` and `to` are unknown
    DutyPtr otherwise;               ///< null if there is none
    std::vector<CheckedDefeater> defeaters;
    const Response* written = nullptr;
};

struct CheckedRule {
    EventCases trigger;
    std::optional<Condition> condition;
    DutyPtr duty;
    bool assumed = false;
    const Rule* written = nullptr;
};

struct CheckedProperty {
    bool exists = false;
    EventCases trigger;
    std::optional<Condition> condition;
    DutyPtr duty;                      ///< null if there is no demand
    std::optional<EventCases> during;  ///< `while` this event
    std::optional<Condition> during_condition;
    const Property* written = nullptr;
};

/// The type of the values that the rules give to an argument of an event.
enum class ArgumentKind : std::uint8_t { any, number, truth, literal };

/// An argument of an event in all rules of the file.
struct Argument {
    ArgumentKind kind = ArgumentKind::any;
    std::vector<std::string> values;  ///< the values that rules name: "1", "true", "red"; for `truth` both
};

/// One case of an event.
struct EventCase {
    std::size_t declared = 0;         ///< index in the file
    std::vector<std::string> values;  ///< values of the arguments; "": a value that no rule names
    std::string text;                 ///< "goTo(1)"; values that no rule names are `other`, or `_` if rules name none
};

/// A file that satisfies the rules of the language.
struct CheckedRules {
    std::shared_ptr<const RuleFile> file;          ///< owner of the data to which `written` points
    std::vector<std::vector<Argument>> arguments;  ///< index: the event of the file
    std::vector<EventCase> events;                 ///< in the order of the file
    std::vector<Measure> measures;                 ///< the measures of the file, then the states of the model
    std::vector<CheckedRule> rules;
    std::vector<CheckedProperty> concerns, purposes;
    durations::Unit unit;  ///< the length of a step; if it has no value, a step is a second

    [[nodiscard]] const std::string& event_name(std::size_t index) const { return events[index].text; }
    /// Returns the event as in a rule: "goTo(_)".
    [[nodiscard]] std::string event_name(const EventCases& cases) const;
    /// Returns the name without arguments.
    [[nodiscard]] const std::string& declared_name(std::size_t index) const {
        return file->events[events[index].declared].name.text;
    }
    /// Returns the case of an event of the file with these values, given as texts. Returns no value if the event has a
    /// different number of arguments.
    [[nodiscard]] std::optional<std::size_t> case_of(std::size_t declared,
                                                     const std::vector<std::string>& values) const;
    [[nodiscard]] const Measure& measure(std::size_t index) const { return measures[index]; }
    /// True if the measure is a state of the model.
    [[nodiscard]] bool is_state(std::size_t measure) const { return measure >= file->measures.size(); }
    [[nodiscard]] const std::string& name(std::size_t rule) const { return rules[rule].written->name.text; }
};

/// Returns "second 3"; with a time unit, "t=30 (3.0 s)".
[[nodiscard]] std::string instant_text(const CheckedRules& rules, std::int64_t step);
/// Returns "3 seconds"; with a time unit, "30 units (3 s)".
[[nodiscard]] std::string steps_text(const CheckedRules& rules, std::int64_t steps);
/// Returns a measure with its value, for messages: "near", "level = 3", "load = high".
[[nodiscard]] std::string value_text(const Measure& measure, std::int64_t value);

}  // namespace robochart::sleec
