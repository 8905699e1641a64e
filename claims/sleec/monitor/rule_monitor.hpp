// SPDX-License-Identifier: Apache-2.0
// Monitors rules at run time. A monitor receives a sequence of events, with the values of the measures, and seconds. It
// reports every violation of a rule. A finite history never breaks a duty without limit.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "claims/sleec/obligations/open.hpp"

namespace robochart::sleec {

/// A duty that was broken.
struct Violation {
    std::size_t rule = 0;
    std::int64_t began = 0;  ///< the second of the trigger
    Valuation values;        ///< the values at the trigger
    Obligation obligation;
    std::optional<std::size_t> event;  ///< the event that broke the duty; no value: the end of a second
    std::int64_t second = 0;           ///< the second in which the duty was broken
};

/// A value for each measure of the file; no value: unknown.
using MeasureReadings = std::vector<std::optional<std::int64_t>>;

/// Monitors all rules of a file except its assumptions. Memory is bounded by the limits of the rules. The constructor
/// throws NotDecided if a rule has too many alternatives.
class RuleMonitor {
public:
    RuleMonitor(const CheckedRules& rules, WithoutLimit without);

    /// Observes an event with the known values of the measures. If a rule's demand depends on unknown values, its
    /// trigger is not followed, and `open_triggers` contains the rule.
    void observe_event(std::size_t event, const MeasureReadings& values);
    /// Ends the current second and begins the next.
    void end_second();
    /// Returns the violations since the last call.
    [[nodiscard]] std::vector<Violation> take_violations();
    /// Returns the rules with a trigger that was not followed, without duplicates.
    [[nodiscard]] const std::vector<std::size_t>& open_triggers() const { return open_triggers_; }
    /// Drops all open obligations, because the events in between are unknown.
    void drop_obligations() { open_.clear(); }
    [[nodiscard]] std::int64_t current_second() const { return now_; }
    /// Returns the open duties with their progress.
    [[nodiscard]] std::vector<std::pair<Obligation, Progress>> open_duties() const;

private:
    struct Open {
        std::size_t rule = 0;
        Obligation obligation;
        Progress progress;
        std::int64_t began = 0;
        Valuation values;
    };
    void start_rule(std::size_t rule, const MeasureReadings& values);
    void update_open(Open open, Effect effect, std::optional<std::size_t> event, std::vector<Open>& left);
    void keep_distinct(Open open, std::vector<Open>& open_now) const;

    const CheckedRules& rules_;
    WithoutLimit without_;
    std::vector<Open> open_;
    std::vector<Violation> violations_;
    std::vector<std::size_t> open_triggers_;
    std::int64_t now_ = 0;
};

}  // namespace robochart::sleec
