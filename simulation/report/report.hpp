// SPDX-License-Identifier: Apache-2.0
// The result of a simulation as text and JSON.
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics/json.hpp"
#include "simulation/report/run.hpp"

namespace robochart::simulation {

/// "64.3 s", "97.5 %", "13.9 cm", "never".
[[nodiscard]] std::string value_text(const Scenario&, const Band&, double value);
/// One line per band: verdict, the band as written, the value.
[[nodiscard]] std::string bands_text(const Scenario&, const RunResult&);
/// "7 of 7 bands hold", "1 of 2 claims holds, 1 is open".
[[nodiscard]] std::string summary_text(const RunResult&);
/// The run itself: trials, seconds simulated, speed.
[[nodiscard]] std::string run_text(const Scenario&, const RunResult&);
/// The guard's result for JSON: `complete`, `notes`; null without a guard. `complete`: everything was observed.
[[nodiscard]] diagnostics::Json guard_json(const Guard*, bool complete);
/// Schema "robochart-verify/simulation/1" (docs/cli.md). `guard`: see guard_json.
[[nodiscard]] std::string result_json(const Scenario&, const RunResult&, diagnostics::Json guard,
                                      const std::vector<std::string>& files, int exit);

}  // namespace robochart::simulation
