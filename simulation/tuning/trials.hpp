// Trials of tuning on the threads that are there, and what each of them costs.
#pragma once

#include <functional>
#include <vector>

#include "simulation/scenario/plan.hpp"
#include "simulation/trial/controller.hpp"
#include "simulation/trial/formulas.hpp"

namespace robochart::simulation {

/// One trial to be run; refers to all it is given.
struct TuningTrial {
    const Plan* plan = nullptr;
    const Drives* drives = nullptr;
    std::uint64_t seed = 0;
};

/// The seed of tuning trial `number`. Those of a search (its `search` at most 10^9) are none of another's, and none of
/// the first 2^32 of the scenario itself, on which claims are judged.
[[nodiscard]] std::uint64_t tuning_seed(const Scenario&, std::uint64_t search, std::uint64_t number);

/// What a trial costs: for each claim the seconds until its property was known to be as it is claimed, or ten times the
/// scenario's duration where it is not (the penalty of PAR10, as in Hutter, Hoos, Leyton-Brown, Stützle, "ParamILS",
/// JAIR 36, 2009). A trial that a controller stops before has the penalty.
[[nodiscard]] double trial_cost(const Scenario&, const std::vector<Answer>&);

/// Runs them, each until its answers are known, and returns their costs in their order. `threads`: 0: one a core.
/// `interrupted`: asked a few times a second; may throw, when all threads have ended.
[[nodiscard]] std::vector<double> trial_costs(const std::vector<TuningTrial>&, unsigned threads,
                                              const std::function<void()>& interrupted);

}  // namespace robochart::simulation
