// One trial: the robots of a scenario, each with its controller, from the start to the end or to the first controller
// that cannot go on.
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

/// Why a trial must stop.
struct Objection {
    std::string cause;  ///< "it wrote ..., which the model does not allow"
    std::string place;  ///< element of the model
};

/// Sees every cycle of every robot; for logs that are compared with the model. Called from the trial's thread.
class Trace {
public:
    virtual ~Trace() = default;
    virtual void cycle(std::size_t robot, std::uint64_t step, const rc_signal* inputs, const rc_actions& outputs,
                       rc_drive_result result) = 0;
    /// Asked after each cycle; null: go on.
    [[nodiscard]] virtual const Objection* objection() const { return nullptr; }
    /// Asked at the end of the trial: whether it saw all that its objections rest on. False: that it had none says
    /// less.
    [[nodiscard]] virtual bool decided() const { return true; }
};

/// Watches all trials of a run.
class Guard {
public:
    using Maker = std::function<std::unique_ptr<Trace>(std::uint32_t trial)>;
    virtual ~Guard() = default;
    /// Makes what watches a trial, and passes all on to what `other` makes, if it makes any.
    [[nodiscard]] virtual Maker beside(Maker other) = 0;
    /// How much was watched, in lines.
    [[nodiscard]] virtual std::string note() const = 0;
};

/// A controller that could not go on.
struct Stop {
    std::size_t robot = 0;
    double time = 0;
    std::string cause;         ///< "it did not end its cycle within its bound of steps"
    std::string place;         ///< element of the model
    bool environment = false;  ///< it is that of the environment, and of no robot

    /// "robot 3", "the environment".
    [[nodiscard]] std::string whose() const;
};

struct TrialResult {
    std::uint64_t steps = 0;  ///< control steps done
    bool complete = false;    ///< neither stopped nor interrupted: at its end, or all claims are known
    bool watched = true;      ///< by its trace, which saw all that it asks for; so too without one
    std::optional<Stop> stop;
    std::vector<double> statistics;  ///< of each band; NaN: never came about
    std::vector<Answer> answers;     ///< of each claim; a trial that stopped is one against it
    std::vector<Frame> frames;       ///< as Scenario::record, and at the times of pictures
    /// At the times of the states of a chain, what it tells apart: a value for each distinction.
    std::vector<std::vector<double>> samples;
};

struct TrialOptions {
    bool record = true;  ///< keep frames
    /// Claims whose answers are awaited: the trial ends when all of them are known. Null: it goes on to its end.
    const std::vector<bool>* awaited = nullptr;
    std::uint64_t seed = 1;  ///< of what the controllers draw
    Trace* trace = nullptr;  ///< not owned
    std::atomic<std::uint64_t>* steps_done = nullptr;
    const std::atomic<bool>* interrupted = nullptr;
};

/// A trial that runs some steps at a time. Refers to all it is given, but for the drives.
class Trial {
public:
    Trial(const Plan&, const Drives&, Stage&, const TrialOptions&);
    ~Trial();
    Trial(const Trial&) = delete;
    Trial& operator=(const Trial&) = delete;

    /// At most so many steps further; false at the trial's end.
    bool run(std::uint64_t steps);
    /// What came of it so far; once.
    [[nodiscard]] TrialResult result() &&;

private:
    class Cycles;
    std::unique_ptr<Cycles> cycles_;
};

/// The whole of it.
[[nodiscard]] TrialResult run_trial(const Plan&, const Drives&, Stage&, const TrialOptions&);

}  // namespace robochart::simulation
