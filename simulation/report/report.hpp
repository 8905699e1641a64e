// SPDX-License-Identifier: Apache-2.0
// Writes the result of a simulation as text and JSON.
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics/json.hpp"
#include "simulation/report/run.hpp"

namespace robochart::simulation {

/// Returns a text such as "64.3 s", "97.5 %", "13.9 cm" or "never".
[[nodiscard]] std::string value_text(const Scenario&, const Band&, double value);
/// Returns one line per band: the verdict, the band as written, the value.
[[nodiscard]] std::string bands_text(const Scenario&, const RunResult&);
/// Returns a text such as "7 of 7 bands hold" or "1 of 2 claims holds, 1 is open".
[[nodiscard]] std::string summary_text(const RunResult&);
/// Describes the run itself: trials, simulated seconds, speed.
[[nodiscard]] std::string run_text(const Scenario&, const RunResult&);
/// Returns the guard's result, with `complete` and `notes`; null without a guard. `complete` tells whether everything
/// was observed.
[[nodiscard]] diagnostics::Json guard_json(const Guard*, bool complete);
/// Writes the result in the schema "robochart-verify/simulation/1" (docs/cli.md). For `guard`, see guard_json.
[[nodiscard]] std::string result_json(const Scenario&, const RunResult&, diagnostics::Json guard,
                                      const std::vector<std::string>& files, int exit);

}  // namespace robochart::simulation
