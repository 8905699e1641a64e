// SPDX-License-Identifier: Apache-2.0
// Follows duties along the runs of simulated robots: claims (claim_duties.hpp) and rules in SLEEC (rule_duties.hpp). An
// input counts when it is raised.
#pragma once

#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "cpp_emit/simulator_api.hpp"
#include "simulation/trial/trial.hpp"

namespace robochart::app {

/// A duty that a robot has broken.
struct BrokenDuty {
    std::size_t number = 0;  ///< of the duty
    std::string reasons;     ///< at most three sentences about the event that broke it
    std::string cause;       ///< why the trial is stopped; "": it is not
    std::string place;
};

/// Follows the duties of one robot.
class Follower {
public:
    Follower() = default;
    Follower(const Follower&) = delete;
    Follower& operator=(const Follower&) = delete;
    virtual ~Follower() = default;
    /// Follows one cycle of the robot's controller. Returns the duties that this cycle breaks; each is returned once.
    [[nodiscard]] virtual std::vector<BrokenDuty> observe_cycle(const rc_signal* inputs, const rc_actions& outputs,
                                                                rc_drive_result result) = 0;
    /// False if the run does not show whether the robot obeys its duties.
    [[nodiscard]] virtual bool is_conclusive() const = 0;
    /// Stores what the report says about the robot. Called at the end of a trial, for one robot at a time.
    virtual void end() = 0;
};

/// The duties of the robots of a scenario, and what the trials have shown about them.
class Duties {
public:
    Duties() = default;
    Duties(const Duties&) = delete;
    Duties& operator=(const Duties&) = delete;
    virtual ~Duties() = default;
    /// Called by several trials at the same time, so it changes nothing.
    [[nodiscard]] virtual std::unique_ptr<Follower> make_follower(std::size_t robot) = 0;
    /// Called for one robot at a time.
    virtual void note_broken(std::uint32_t /*trial*/, std::size_t /*robot*/, const BrokenDuty& /*broken*/) {}
    /// The share of the robots that obey the duty of a measure; no value if no duty belongs to the measure. `broken`
    /// maps the number of a duty to the number of robots that have broken it.
    [[nodiscard]] virtual std::optional<double> kept_share(std::size_t /*measure*/,
                                                           const std::map<std::size_t, std::size_t>& /*broken*/) const {
        return std::nullopt;
    }
    /// Lines of text about the trials, in which `robots` robots were followed.
    [[nodiscard]] virtual std::string summary_lines(std::uint64_t robots) const = 0;
};

class FollowGuard final : public simulation::Guard {
public:
    explicit FollowGuard(std::unique_ptr<Duties> duties) : duties_(std::move(duties)) {}

    [[nodiscard]] Maker make_observer(Maker other) override;
    [[nodiscard]] std::string summary_lines() const override { return duties_->summary_lines(robots_.load()); }

private:
    class Watch;

    std::unique_ptr<Duties> duties_;
    std::mutex mutex_;  ///< for all changes of the duties
    std::atomic<std::uint64_t> robots_ = 0;
};

/// The text of a value that a port carries, as in logs.
[[nodiscard]] std::string carried_text(const cpp_emit::Port& port, std::size_t argument, rc_value value);
/// The texts of all values that a port carries.
[[nodiscard]] std::vector<std::string> carried_texts(const cpp_emit::Port& port, const rc_value* values);

}  // namespace robochart::app
