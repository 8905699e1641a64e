// SPDX-License-Identifier: Apache-2.0
// Draws plots of a sweep as SVG, in the style of the other pictures of a simulation.
#pragma once

#include <string>
#include <vector>

#include "simulation/sweep/sweep_report.hpp"

namespace robochart::simulation {

/// A plot, named "success", "times" or "map".
struct SweepPlot {
    std::string name;
    std::string svg;
};

/// Draws the plots for each claim. One shows the fraction of trials against the first variation, with bars for the
/// joint and the pointwise interval and a line for the claimed value. For claims about a time, another plot shows the
/// fraction of trials without success over time (Kaplan and Meier). With two variations, there is also a map of the
/// points.
[[nodiscard]] std::vector<SweepPlot> sweep_plots(const Scenario&, const SweepResult&);

}  // namespace robochart::simulation
