// Rules followed while something runs: events with the values of the measures, and seconds, one after the other. Says
// where a rule is broken; a duty without limit is never broken by a finite history.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "sleec/obligations/open.hpp"

namespace robochart::sleec {

/// A duty that was broken.
struct Violation {
    std::size_t rule = 0;
    std::int64_t began = 0;  ///< second of its trigger
    Valuation values;        ///< at the trigger
    Obligation obligation;
    std::optional<std::size_t> event;  ///< that broke it; nothing: the end of a second
    std::int64_t second = 0;           ///< in which it was broken
};

/// A value for each measure of the file; nothing: it is not known.
using MeasureReadings = std::vector<std::optional<std::int64_t>>;

/// All rules of a file but its assumptions. Memory is bounded by the limits of the rules. Throws NotDecided where a
/// rule has too many alternatives.
class RuleMonitor {
public:
    RuleMonitor(const CheckedRules& rules, WithoutLimit without);

    /// An event with what is known of the measures. A trigger of a rule that asks for different duties as the values
    /// are that are not known is not followed; `open_triggers` has it.
    void event(std::size_t event, const MeasureReadings& values);
    /// The second ends, and the next begins.
    void second();
    /// What has been broken since it was last asked.
    [[nodiscard]] std::vector<Violation> take();
    /// Rules of which a trigger was not followed, each once.
    [[nodiscard]] const std::vector<std::size_t>& open_triggers() const { return open_triggers_; }
    /// What was asked for until now is forgotten: what has happened in between is not known.
    void forget() { open_.clear(); }
    [[nodiscard]] std::int64_t now() const { return now_; }
    /// What is owed: each duty, and how far it has come.
    [[nodiscard]] std::vector<std::pair<Obligation, Progress>> owed() const;

private:
    struct Open {
        std::size_t rule = 0;
        Obligation obligation;
        Progress progress;
        std::int64_t began = 0;
        Valuation values;
    };
    void trigger(std::size_t rule, const MeasureReadings& values);
    void after(Open open, Effect effect, std::optional<std::size_t> event, std::vector<Open>& left);
    void keep(Open open, std::vector<Open>& open_now) const;

    const CheckedRules& rules_;
    WithoutLimit without_;
    std::vector<Open> open_;
    std::vector<Violation> violations_;
    std::vector<std::size_t> open_triggers_;
    std::int64_t now_ = 0;
};

}  // namespace robochart::sleec
