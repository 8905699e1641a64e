// SPDX-License-Identifier: Apache-2.0
// Monitors for the controllers of a simulation (`simulate --monitor`).
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "app/command/options.hpp"
#include "app/verbs/simulate.hpp"
#include "conformance/monitor/cycle_cache.hpp"
#include "conformance/monitor/monitor.hpp"

namespace robochart::app {

/// This message is printed before the results of the trials if a guard could not follow all events that it checks.
inline constexpr const char* not_all_watched = "--monitor could not follow all that it asks for: not decided\n";

class Monitors final : public simulation::Guard {
public:
    Monitors(std::unique_ptr<conformance::MonitorBuild> build, const cpp_emit::DriveEmission& emission)
        : build_(std::move(build)), emission_(emission) {}
    [[nodiscard]] Maker make_observer(Maker other) override;
    [[nodiscard]] std::string summary_lines() const override;

private:
    class Watch;

    [[nodiscard]] std::unique_ptr<conformance::CycleCache> borrow_cache();
    void give_back(std::unique_ptr<conformance::CycleCache>);

    std::unique_ptr<conformance::MonitorBuild> build_;
    const cpp_emit::DriveEmission& emission_;
    std::mutex mutex_;
    std::vector<std::unique_ptr<conformance::CycleCache>>
        idle_;  ///< caches of finished trials, which later trials reuse
    std::atomic<std::uint64_t> robots_ = 0;
    /// Number of monitors that stopped because their robot left the finite instantiation.
    std::atomic<std::uint64_t> lost_ = 0;
};

/// Builds monitors for the robots of the first kind. If the model has no monitor, reports a diagnostic and returns
/// null.
[[nodiscard]] std::unique_ptr<Monitors> make_monitors(Simulation&, const Options&);
/// The guard that `--monitor` selects: the model's monitors, or those of a rule file. Null without the option. If the
/// guard cannot be built, reports a diagnostic and returns null.
[[nodiscard]] std::unique_ptr<simulation::Guard> make_guard(Simulation&, const Options&);

}  // namespace robochart::app
