// SPDX-License-Identifier: Apache-2.0
// Monitors the robots of a simulation with SLEEC rules (`simulate --monitor RULES.sleec`). The inputs and outputs of
// each robot's controller must obey the rules.
#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "app/command/options.hpp"
#include "cpp_emit/simulator_api.hpp"
#include "driver/rules/rule_claims.hpp"
#include "driver/rules/rule_run.hpp"
#include "simulation/trial/trial.hpp"

namespace robochart::app {

/// Monitors the rules of a file that are about a controller. Stores a reference to the emission.
class RuleGuard final : public simulation::Guard {
public:
    /// `units` is the number of time units of the model in one cycle.
    RuleGuard(std::unique_ptr<driver::LoadedRules> loaded, const cpp_emit::DriveEmission& emission,
              std::uint32_t units);

    [[nodiscard]] Maker make_observer(Maker other) override;
    [[nodiscard]] std::string summary_lines() const override;
    /// Returns the number of monitored rules. A rule is monitored if the controller has the events of the rule.
    [[nodiscard]] std::size_t followed_count() const { return rules_.rules.size(); }
    /// True if a limit of the monitored rules is in seconds, and no time unit is declared.
    [[nodiscard]] bool counts_seconds() const { return driver::counts_seconds(rules_); }

private:
    class Watch;
    /// The events of the file and the measures that belong to an input or output of the controller.
    struct Linked {
        std::vector<std::size_t> events, measures;
    };
    [[nodiscard]] std::vector<Linked> link_ports(const std::vector<cpp_emit::Port>& ports);
    void leave_out();

    std::unique_ptr<driver::LoadedRules> loaded_;
    const cpp_emit::DriveEmission& emission_;
    std::uint32_t units_;
    sleec::CheckedRules rules_;  ///< the monitored rules of the file
    std::vector<Linked> inputs_, outputs_;
    std::vector<bool> has_;  ///< true for the events that the controller has
    std::vector<std::string> left_out_;
    std::mutex mutex_;
    std::map<std::size_t, std::uint64_t> open_;  ///< per rule: number of robots with a trigger that was not followed
    std::string given_up_;                       ///< why a robot was not followed to its end; "" if all were
    std::atomic<std::uint64_t> robots_ = 0;
};

/// The times of a scenario.
struct GuardedTimes {
    std::uint32_t units = 1;  ///< time units of the model in one cycle
    durations::Unit unit;     ///< the length of a time unit in the scenario
    std::string scenario;     ///< its path
};

/// Makes the guard for a rule file. Returns null, with the reason in `error`, if the file is wrong, if none of its
/// rules is about the controller, or if a second of the rules is not a second of the scenario. Findings about the file
/// are printed.
[[nodiscard]] std::unique_ptr<RuleGuard> make_rule_guard(const std::string& file,
                                                         const cpp_emit::DriveEmission& emission,
                                                         const GuardedTimes& times, const Options& options,
                                                         std::string& error);

}  // namespace robochart::app
