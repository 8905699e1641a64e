// SPDX-License-Identifier: Apache-2.0
// The results of a sweep as text, tables and JSON.
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics/json.hpp"
#include "simulation/sweep/sweep.hpp"

namespace robochart::simulation {

/// The results of a whole sweep.
struct SweepResult {
    std::vector<PointResult> points;  ///< all points; those not computed have no claims
    bool interrupted = false;
    bool watched = true;      ///< RunResult::watched of all points
    std::size_t earlier = 0;  ///< number of points that an earlier run had decided
    double seconds = 0;
    double cpu_seconds = 0;

    /// The number of robots times the number of control steps until the answers were known. The second function returns
    /// this number as if every trial had run to its end.
    [[nodiscard]] std::uint64_t robot_steps(const Scenario&) const;
    [[nodiscard]] std::uint64_t whole_robot_steps(const Scenario&) const;
};

/// "proved", "refuted", "open", "estimated", "not looked at".
[[nodiscard]] std::string point_word(const PointResult&, std::size_t claim);
/// The median time to success: "506.3 s", "never"; "" if the claim is not about a time.
[[nodiscard]] std::string median_text(const Claim&, const ClaimResult&);
/// For each claim a table of the points, the sets of proved, refuted and open points, and the least value.
[[nodiscard]] std::string sweep_text(const Scenario&, const SweepResult&);
/// "the least robots is 4": one line for each claim (except estimates) and each value of the second variation.
[[nodiscard]] std::vector<std::string> least_lines(const Scenario&, const SweepResult&);
/// One row for each point and claim.
[[nodiscard]] std::string sweep_csv(const Scenario&, const SweepResult&);
/// One row for each trial.
[[nodiscard]] std::string sweep_trials_csv(const Scenario&, const SweepResult&);
/// {"robots": 4, "noise": 0.05}: the values of the variations at a point.
[[nodiscard]] diagnostics::Json values_json(const Scenario&, const Point&);
/// Schema "robochart-verify/sweep/1" (docs/cli.md). `comparison` contains the comparison with earlier trials, and
/// `guard` is guard_json (report/report.hpp) of the last controller.
[[nodiscard]] std::string sweep_json(const Scenario&, const SweepResult&, diagnostics::Json comparison,
                                     diagnostics::Json guard, const std::vector<std::string>& files, int exit);

}  // namespace robochart::simulation
