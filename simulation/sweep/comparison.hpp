// A sweep beside a table of earlier trials: do its estimates disagree?
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "simulation/sweep/sweep_report.hpp"
#include "statistics/two_samples.hpp"

namespace robochart::simulation {

/// A row of a table: an estimate at a point.
struct TableRow {
    Point point;
    std::size_t claim = 0;
    statistics::Sample sample;
};

/// Reads a table with a heading: comma-separated, with a column for each variation, `trials` and `successes`, and, with
/// several claims, `claim`: the number of one, from 1, or its text. Other columns are ignored, so `sweep.csv` is such a
/// table. Nothing where it is none; `error` says why.
[[nodiscard]] std::optional<std::vector<TableRow>> read_table(std::string_view text, const Scenario&,
                                                              std::string& error);

/// An estimate here and there.
struct Compared {
    Point point;
    std::size_t claim = 0;
    statistics::Sample here, there;
    double chance = 1;    ///< of Fisher's exact test
    double adjusted = 1;  ///< by Holm, for all points of the claim together
};

/// The estimates that both have, tested for each claim at all its points jointly.
[[nodiscard]] std::vector<Compared> compare(const Scenario&, const SweepResult&, const std::vector<TableRow>&);
/// Differs at the joint confidence of its claim.
[[nodiscard]] bool rejected(const Scenario&, const Compared&);
/// A table of them.
[[nodiscard]] std::string comparison_text(const Scenario&, const std::vector<Compared>&);
/// A list of objects: `values`, `claim`, `here` and `there` (successes, trials), `chance`, `adjusted`, `differs`.
[[nodiscard]] diagnostics::Json comparison_json(const Scenario&, const std::vector<Compared>&);
/// "2 of 22 estimates differ", "none of 22 estimates differs".
[[nodiscard]] std::string comparison_summary(const Scenario&, const std::vector<Compared>&);

}  // namespace robochart::simulation
