// SPDX-License-Identifier: Apache-2.0
// Runs one trial: the robots of a scenario, each with its controller, from the start to the end or until a controller
// cannot continue.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "simulation/scenario/plan.hpp"
#include "simulation/trial/controller.hpp"
#include "simulation/trial/measures.hpp"
#include "simulation/trial/stage.hpp"

namespace robochart::simulation {

/// The reason why a trial must stop.
struct Objection {
    std::string cause;  ///< "it wrote ..., which the model does not allow"
    std::string place;  ///< element of the model
};

/// Observes every cycle of every robot, for example to write logs. Called from the trial's thread.
class Trace {
public:
    virtual ~Trace() = default;
    virtual void observe_cycle(std::size_t robot, std::uint64_t step, const rc_signal* inputs,
                               const rc_actions& outputs, rc_drive_result result) = 0;
    /// Returns the reason to stop after the last cycle; null: continue.
    [[nodiscard]] virtual const Objection* current_objection() const { return nullptr; }
    /// Called at the end of the trial. True if the observer saw everything relevant for objections. If the result is
    /// false, the absence of an objection proves nothing.
    [[nodiscard]] virtual bool is_conclusive() const { return true; }
    /// Returns the fraction of robots whose runs have satisfied the claim of a measure so far. Only the observer that
    /// follows claims knows it.
    [[nodiscard]] virtual double kept_share(std::size_t measure) const;
};

/// Observes all trials of a run.
class Guard {
public:
    using Maker = std::function<std::unique_ptr<Trace>(std::uint32_t trial)>;
    virtual ~Guard() = default;
    /// Makes the observer of a trial, which passes everything on to the observer made by `other`, if any.
    [[nodiscard]] virtual Maker make_observer(Maker other) = 0;
    /// Returns lines of text that tell how much was observed.
    [[nodiscard]] virtual std::string summary_lines() const = 0;
};

/// A controller that could not continue, and the cause.
struct Stop {
    std::size_t robot = 0;
    double time = 0;
    std::string cause;         ///< "it did not end its cycle within its bound of steps"
    std::string place;         ///< element of the model
    bool environment = false;  ///< true for the controller of the environment

    /// Returns a text such as "robot 3" or "the environment".
    [[nodiscard]] std::string owner_text() const;
};

struct TrialResult {
    std::uint64_t steps = 0;  ///< executed control steps
    /// True if the trial was neither stopped nor interrupted: it reached its end, or all answers are known.
    bool complete = false;
    bool watched = true;  ///< the trace observed everything it needs, or there is no trace
    std::optional<Stop> stop;
    std::vector<double> statistics;  ///< the statistic of each band; NaN: never reached
    std::vector<Answer> answers;     ///< the answer to each claim; in a stopped trial, claims fail
    std::vector<Frame> frames;       ///< one for every Scenario::record seconds, and for the times of pictures
    /// The values that a chain distinguishes, at the times of its states. Each sample has one value per distinction.
    std::vector<std::vector<double>> samples;
};

struct TrialOptions {
    bool record = true;  ///< store frames
    /// The claims whose answers are awaited. The trial ends when all these answers are known. If null, the trial runs
    /// to its end.
    const std::vector<bool>* awaited = nullptr;
    std::uint64_t seed = 1;  ///< the seed of random choices of the controllers
    Trace* trace = nullptr;  ///< not owned
    std::atomic<std::uint64_t>* steps_done = nullptr;
    const std::atomic<bool>* interrupted = nullptr;
};

/// A trial that can be run in portions of steps. Stores references to its arguments, except the drives.
class Trial {
public:
    Trial(const Plan&, const Drives&, Stage&, const TrialOptions&);
    ~Trial();
    Trial(const Trial&) = delete;
    Trial& operator=(const Trial&) = delete;

    /// Runs at most this number of further steps. Returns false if the trial has ended.
    bool run(std::uint64_t steps);
    /// Returns the result so far. May be called only once.
    [[nodiscard]] TrialResult result() &&;

private:
    class Cycles;
    std::unique_ptr<Cycles> cycles_;
};

/// Runs a whole trial.
[[nodiscard]] TrialResult run_trial(const Plan&, const Drives&, Stage&, const TrialOptions&);

}  // namespace robochart::simulation
