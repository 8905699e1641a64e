// SPDX-License-Identifier: Apache-2.0
// Compares the estimates of a sweep with a table of earlier trials.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/statistics/two_samples.hpp"
#include "simulation/sweep/sweep_report.hpp"

namespace robochart::simulation {

/// A row of a table of earlier trials: an estimate at a point.
struct TableRow {
    Point point;
    std::size_t claim = 0;
    statistics::Sample sample;
};

/// Reads a comma-separated table with a header line. The table needs a column for each variation, and the columns
/// `trials` and `successes`. If there are several claims, it also needs `claim`: the number of a claim, from 1, or its
/// text. Other columns are ignored, so `sweep.csv` is a valid table. If the table is not valid, returns no value, and
/// `error` contains the reason.
[[nodiscard]] std::optional<std::vector<TableRow>> read_table(std::string_view text, const Scenario&,
                                                              std::string& error);

/// An estimate at a point, from the sweep and from the table.
struct Compared {
    Point point;
    std::size_t claim = 0;
    statistics::Sample here, there;
    double chance = 1;    ///< p-value of Fisher's exact test
    double adjusted = 1;  ///< the same after Holm's adjustment, jointly for all points of the claim
};

/// Compares the estimates of the sweep with those of the table. Each claim is tested jointly at all its points.
[[nodiscard]] std::vector<Compared> compare_tables(const Scenario&, const SweepResult&, const std::vector<TableRow>&);
/// True if the estimates differ at the joint confidence of the claim.
[[nodiscard]] bool is_rejected(const Scenario&, const Compared&);
/// Returns the comparisons as a table.
[[nodiscard]] std::string comparison_text(const Scenario&, const std::vector<Compared>&);
/// Returns a list of objects with `values`, `claim`, `here` and `there` (successes, trials), `chance`, `adjusted`,
/// `differs`.
[[nodiscard]] diagnostics::Json comparison_json(const Scenario&, const std::vector<Compared>&);
/// Returns a text such as "2 of 22 estimates differ" or "none of 22 estimates differs".
[[nodiscard]] std::string comparison_summary(const Scenario&, const std::vector<Compared>&);

}  // namespace robochart::simulation
