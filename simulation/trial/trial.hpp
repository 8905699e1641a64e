// SPDX-License-Identifier: Apache-2.0
// One trial: the robots of a scenario, each with its controller, from the start to the end or until a controller cannot
// continue.
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
    /// Called after each cycle; null: continue.
    [[nodiscard]] virtual const Objection* current_objection() const { return nullptr; }
    /// Called at the end of the trial. True if everything relevant for objections was observed. If the result is false,
    /// the absence of an objection is not conclusive.
    [[nodiscard]] virtual bool is_conclusive() const { return true; }
    /// The share of robots that have kept the claim of a measure so far; only the observer that follows claims knows
    /// it.
    [[nodiscard]] virtual double kept_share(std::size_t measure) const;
};

/// Observes all trials of a run.
class Guard {
public:
    using Maker = std::function<std::unique_ptr<Trace>(std::uint32_t trial)>;
    virtual ~Guard() = default;
    /// Makes the observer of a trial, which passes everything on to the observer made by `other`, if any.
    [[nodiscard]] virtual Maker make_observer(Maker other) = 0;
    /// Lines of text about the extent of the observation.
    [[nodiscard]] virtual std::string summary_lines() const = 0;
};

/// A controller that could not continue.
struct Stop {
    std::size_t robot = 0;
    double time = 0;
    std::string cause;         ///< "it did not end its cycle within its bound of steps"
    std::string place;         ///< element of the model
    bool environment = false;  ///< the controller of the environment, not of a robot

    /// "robot 3", "the environment".
    [[nodiscard]] std::string owner_text() const;
};

struct TrialResult {
    std::uint64_t steps = 0;  ///< executed control steps
    /// The trial was neither stopped nor interrupted; it reached its end, or all answers are known.
    bool complete = false;
    bool watched = true;  ///< the trace observed everything it needs, or there is no trace
    std::optional<Stop> stop;
    std::vector<double> statistics;  ///< the statistic of each band; NaN: never reached
    std::vector<Answer> answers;     ///< the answer to each claim; a stopped trial counts against the claim
    std::vector<Frame> frames;       ///< every Scenario::record, and at the times of pictures
    /// The values that a chain distinguishes, at the times of its states: one value per distinction.
    std::vector<std::vector<double>> samples;
};

struct TrialOptions {
    bool record = true;  ///< store frames
    /// The claims whose answers are awaited. The trial ends when all these answers are known. Null: the trial runs to
    /// its end.
    const std::vector<bool>* awaited = nullptr;
    std::uint64_t seed = 1;  ///< the seed of random choices of the controllers
    Trace* trace = nullptr;  ///< not owned
    std::atomic<std::uint64_t>* steps_done = nullptr;
    const std::atomic<bool>* interrupted = nullptr;
};

/// A trial that can be run in portions of steps. Refers to its arguments, except the drives.
class Trial {
public:
    Trial(const Plan&, const Drives&, Stage&, const TrialOptions&);
    ~Trial();
    Trial(const Trial&) = delete;
    Trial& operator=(const Trial&) = delete;

    /// Runs at most this number of further steps; returns false at the trial's end.
    bool run(std::uint64_t steps);
    /// The result so far; may be called once.
    [[nodiscard]] TrialResult result() &&;

private:
    class Cycles;
    std::unique_ptr<Cycles> cycles_;
};

/// Runs a whole trial.
[[nodiscard]] TrialResult run_trial(const Plan&, const Drives&, Stage&, const TrialOptions&);

}  // namespace robochart::simulation
