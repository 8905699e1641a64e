// SPDX-License-Identifier: Apache-2.0
// Runs trials of tuning on several threads, and computes their costs.
#pragma once

#include <functional>
#include <vector>

#include "simulation/scenario/plan.hpp"
#include "simulation/trial/controller.hpp"
#include "simulation/trial/formulas.hpp"

namespace robochart::simulation {

/// A trial to run: its plan, its controllers and its seed.
struct TuningTrial {
    const Plan* plan = nullptr;
    const Drives* drives = nullptr;
    std::uint64_t seed = 0;
};

/// Returns the seed of tuning trial `number`. The seeds of a search (`search` is at most 10^9) differ from those of
/// other searches. They also differ from the scenario's own first 2^32 seeds, on which claims are decided.
[[nodiscard]] std::uint64_t tuning_seed(const Scenario&, std::uint64_t search, std::uint64_t number);

/// Returns the cost of a trial. For each claim, the cost is the time in seconds until its property was known to have
/// the claimed value. If the property does not have this value, the cost is ten times the scenario's duration (the
/// penalty of PAR10, as in Hutter, Hoos, Leyton-Brown, Stützle, "ParamILS", JAIR 36, 2009). If a controller stops the
/// trial before, the cost is this penalty too.
[[nodiscard]] double trial_cost(const Scenario&, const std::vector<Answer>&);

/// Runs each trial until its answers are known, and returns the costs in order. With `threads` 0, uses one thread per
/// core. `interrupted` is called a few times per second. It may throw; the exception takes effect when all threads have
/// ended.
[[nodiscard]] std::vector<double> trial_costs(const std::vector<TuningTrial>&, unsigned threads,
                                              const std::function<void()>& interrupted);

}  // namespace robochart::simulation
