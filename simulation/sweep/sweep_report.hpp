// What a sweep has found, as text, tables and JSON.
#pragma once

#include <string>
#include <vector>

#include "diagnostics/json.hpp"
#include "simulation/sweep/sweep.hpp"

namespace robochart::simulation {

/// A whole sweep.
struct SweepResult {
    std::vector<PointResult> points;  ///< all of them, those not looked at without claims
    bool interrupted = false;
    bool watched = true;      ///< RunResult::watched of all points
    std::size_t earlier = 0;  ///< points that an earlier run had decided
    double seconds = 0;
    double cpu_seconds = 0;

    /// Robots times control steps until answers were known; and if every trial had gone on to its end.
    [[nodiscard]] std::uint64_t robot_steps(const Scenario&) const;
    [[nodiscard]] std::uint64_t whole_robot_steps(const Scenario&) const;
};

/// "proved", "refuted", "open", "estimated", "not looked at".
[[nodiscard]] std::string point_word(const PointResult&, std::size_t claim);
/// How long it took in half of the trials: "506.3 s", "never", "" where the claim is not about a time.
[[nodiscard]] std::string median_text(const Claim&, const ClaimResult&);
/// Of each claim a table of the points, the sets proved, refuted and open, and the least value.
[[nodiscard]] std::string sweep_text(const Scenario&, const SweepResult&);
/// "the least robots is 4", a line for each claim, estimates apart, and each value of the second variation.
[[nodiscard]] std::vector<std::string> least_lines(const Scenario&, const SweepResult&);
/// A row for each point and claim.
[[nodiscard]] std::string sweep_csv(const Scenario&, const SweepResult&);
/// A row for each trial.
[[nodiscard]] std::string sweep_trials_csv(const Scenario&, const SweepResult&);
/// Schema "robochart-verify/sweep/1" (docs/cli.md).
/// `comparison`: with earlier trials; `guard`: report/report.hpp, guard_json, of the last controller.
[[nodiscard]] std::string sweep_json(const Scenario&, const SweepResult&, diagnostics::Json comparison,
                                     diagnostics::Json guard, const std::vector<std::string>& files, int exit);

}  // namespace robochart::simulation
