// SPDX-License-Identifier: Apache-2.0
// Shows a run of a RoboSim component cycle by cycle: what it reads, what it writes, and the states at the end of each
// cycle (docs/robosim.md).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "counterexample/run.hpp"

namespace robochart::runs {

/// What a component does in one cycle of a run.
struct RunCycle {
    std::int64_t time = 0;             ///< number of time units before the cycle
    std::vector<std::string> inputs;   ///< the contents of the registers, without empty registers: "pressed", "x = 3"
    std::vector<std::string> outputs;  ///< in the order in which they are written: "lit(true)"
    std::vector<std::string> states;   ///< states of the machines after the last step before time passes
};

/// Returns the cycles of a run. Returns none if no step of the run reads a register or ends an execution.
[[nodiscard]] std::vector<RunCycle> cycles_of(const Run&);

/// Returns a text such as "in {pressed}  out <lit(true)>  in On".
[[nodiscard]] std::string text_of(const RunCycle&);

}  // namespace robochart::runs
