// Rules in SLEEC beside what runs: a log, or a robot of a simulation.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/rules/model_rules.hpp"
#include "sleec/monitor/rule_monitor.hpp"

namespace robochart::app {

/// Words of logs as events and measures of a file of rules. Equal names are linked, unless `map` says otherwise. Refers
/// to the rules.
class RuleWords {
public:
    explicit RuleWords(const sleec::CheckedRules& rules);

    /// Those that the word is about: its name in front of `?` or `!`.
    [[nodiscard]] std::vector<std::size_t> events(std::string_view word) const;
    [[nodiscard]] std::vector<std::size_t> measures(std::string_view word) const;
    /// The value in the word; nothing where the rules cannot say it: a fraction, a literal that they do not have.
    [[nodiscard]] std::optional<std::int64_t> value(std::size_t measure, std::string_view word) const;

private:
    using Names = std::multimap<std::string, std::size_t>;
    [[nodiscard]] std::string model_name(const std::string& name) const;

    const sleec::CheckedRules& rules_;
    Names events_, measures_;
};

/// One run. What happens in an instant is taken together, since a measure may be read behind a trigger. Refers to the
/// rules.
class RuleRun {
public:
    RuleRun(RulesOf of, sleec::WithoutLimit without);

    /// A reading at this instant; nothing: of a value that the rules cannot say.
    void read(std::size_t measure, std::optional<std::int64_t> value);
    /// An event at this instant, in a line of a log.
    void happen(std::size_t event, std::uint64_t line = 0);
    /// The second ends.
    void second(std::uint64_t line = 0);
    /// What was asked for until now is forgotten.
    void forget();
    /// The run ends here, which may be in the middle of an instant.
    void end() { end_instant(); }

    [[nodiscard]] bool broken() const { return !text_.empty(); }
    /// Where it was first broken, and what was: each duty on a line, then what broke them.
    [[nodiscard]] std::uint64_t line() const { return line_; }
    [[nodiscard]] const std::vector<std::string>& text() const { return text_; }
    [[nodiscard]] diagnostics::Span place() const { return place_; }
    /// Rules of which a trigger was not followed, since a measure was not read.
    [[nodiscard]] const std::vector<std::size_t>& open() const { return monitor_.open_triggers(); }
    [[nodiscard]] std::int64_t seconds() const { return monitor_.now(); }

private:
    struct Happened {
        std::size_t event;
        std::uint64_t line;
    };
    void end_instant();
    void note(std::uint64_t line);

    RulesOf of_;
    sleec::RuleMonitor monitor_;
    sleec::MeasureReadings readings_;
    std::vector<bool> read_;
    std::vector<Happened> instant_;
    std::vector<std::string> text_;
    diagnostics::Span place_;
    std::uint64_t line_ = 0;
};

}  // namespace robochart::app
