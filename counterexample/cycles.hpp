// SPDX-License-Identifier: Apache-2.0
// A run of a RoboSim component cycle by cycle: what it reads, what it writes, and the states at the end of the cycle
// (docs/robosim.md).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "counterexample/run.hpp"

namespace robochart::runs {

/// A cycle of a run.
struct RunCycle {
    std::int64_t time = 0;             ///< time units before it
    std::vector<std::string> inputs;   ///< what the registers contain, without empty ones: "pressed", "x = 3"
    std::vector<std::string> outputs;  ///< in their order: "lit(true)"
    std::vector<std::string> states;   ///< of the machines after the last step before time passes
};

/// The cycles of a run; none if no step of the run reads a register or ends an execution.
[[nodiscard]] std::vector<RunCycle> cycles_of(const Run&);

/// "in {pressed}  out <lit(true)>  in On".
[[nodiscard]] std::string text_of(const RunCycle&);

}  // namespace robochart::runs
