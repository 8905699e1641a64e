// SPDX-License-Identifier: Apache-2.0
// Writes the results of a sweep as text, tables and JSON.
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

    /// Returns the number of robots times the number of control steps until the answers were known. The second function
    /// returns the number as it would be if every trial had run to its end.
    [[nodiscard]] std::uint64_t robot_steps(const Scenario&) const;
    [[nodiscard]] std::uint64_t whole_robot_steps(const Scenario&) const;
};

/// Returns "proved", "refuted", "open", "estimated" or "not looked at".
[[nodiscard]] std::string point_word(const PointResult&, std::size_t claim);
/// Returns the median time to success, "506.3 s" or "never"; "" if the claim is not about a time.
[[nodiscard]] std::string median_text(const Claim&, const ClaimResult&);
/// Returns, for each claim, a table of the points, the sets of proved, refuted and open points, and the least value.
[[nodiscard]] std::string sweep_text(const Scenario&, const SweepResult&);
/// Returns lines such as "the least robots is 4": one for each claim (except estimates) and each value of the second
/// variation.
[[nodiscard]] std::vector<std::string> least_lines(const Scenario&, const SweepResult&);
/// Returns a table with one row for each point and claim.
[[nodiscard]] std::string sweep_csv(const Scenario&, const SweepResult&);
/// Returns a table with one row for each trial.
[[nodiscard]] std::string sweep_trials_csv(const Scenario&, const SweepResult&);
/// Returns the values of the variations at a point: {"robots": 4, "noise": 0.05}.
[[nodiscard]] diagnostics::Json values_json(const Scenario&, const Point&);
/// Writes the results in the schema "robochart-verify/sweep/1" (docs/cli.md). `comparison` is the comparison with
/// earlier trials, and `guard` is the result of guard_json (report/report.hpp) for the last controller.
[[nodiscard]] std::string sweep_json(const Scenario&, const SweepResult&, diagnostics::Json comparison,
                                     diagnostics::Json guard, const std::vector<std::string>& files, int exit);

}  // namespace robochart::simulation
