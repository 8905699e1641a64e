// SPDX-License-Identifier: Apache-2.0
// Monitors a log, or a robot of a simulation, with SLEEC rules.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "claims/sleec/monitor/rule_monitor.hpp"
#include "driver/rules/model_rules.hpp"

namespace robochart::driver {

/// Maps words of logs to events and measures of a rule file. A word is the text of one event in a log, such as `e?3`.
/// If the rule file has no `map`, a word is linked to the event or measure with the same name. Stores a reference to
/// the rules.
class RuleWords {
public:
    explicit RuleWords(const sleec::CheckedRules& rules);

    /// Returns the events of the rule file that are linked to the name in the word (the part before `?` or `!`).
    [[nodiscard]] std::vector<std::size_t> declared_by_word(std::string_view word) const;
    /// Returns the cases of these events that match the values in the word. An event with arguments has one case for
    /// each combination of values. An event without arguments matches all values.
    [[nodiscard]] std::vector<std::size_t> events_of_word(std::string_view word) const;
    [[nodiscard]] std::vector<std::size_t> measures_of_word(std::string_view word) const;
    /// Returns the value of a measure in the word. Returns no value if the rules cannot express the value, because it
    /// is a fraction or a literal that the rules do not declare.
    [[nodiscard]] std::optional<std::int64_t> value_in(std::size_t measure, std::string_view word) const;

private:
    using Names = std::multimap<std::string, std::size_t>;
    [[nodiscard]] std::string model_name(const std::string& name) const;

    const sleec::CheckedRules& rules_;
    Names events_, measures_;
};

/// Monitors one run. All events and readings of an instant are processed together, because a measure may be read after
/// a trigger. Stores a reference to the rules.
class RuleRun {
public:
    RuleRun(RulesOf of, sleec::WithoutLimit without);

    /// Adds a reading at this instant. If the rules cannot express the value of the reading, the reading has no value.
    void read(std::size_t measure, std::optional<std::int64_t> value);
    /// Adds an event at this instant; `line` is its line in a log.
    void add_event(std::size_t event, std::uint64_t line = 0);
    /// Ends the current second.
    void end_second(std::uint64_t line = 0);
    /// Drops all open obligations.
    void drop_obligations();
    /// Ends the run, possibly in the middle of an instant.
    void end() { end_instant(); }

    [[nodiscard]] bool is_broken() const { return !text_.empty(); }
    /// The next three functions describe the first violation. The text has one line for each duty, and then a line for
    /// the event that broke the duties.
    [[nodiscard]] std::uint64_t violation_line() const { return line_; }
    [[nodiscard]] const std::vector<std::string>& violation_text() const { return text_; }
    [[nodiscard]] diagnostics::Span violation_place() const { return place_; }
    /// Returns the rules that the monitor did not follow after a trigger, because a measure had not been read.
    [[nodiscard]] const std::vector<std::size_t>& open_triggers() const { return monitor_.open_triggers(); }
    [[nodiscard]] std::int64_t elapsed_seconds() const { return monitor_.current_second(); }

private:
    struct Happened {
        std::size_t event;
        std::uint64_t line;
    };
    void end_instant();
    void note_violations(std::uint64_t line);

    RulesOf of_;
    sleec::RuleMonitor monitor_;
    sleec::MeasureReadings readings_;
    std::vector<bool> read_;
    std::vector<Happened> instant_;
    std::vector<std::string> text_;
    diagnostics::Span place_;
    std::uint64_t line_ = 0;
};

}  // namespace robochart::driver
