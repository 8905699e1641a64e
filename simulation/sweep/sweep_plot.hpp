// SPDX-License-Identifier: Apache-2.0
// Plots of a sweep as SVG, in the style of the other pictures of a simulation.
#pragma once

#include <string>
#include <vector>

#include "simulation/sweep/sweep_report.hpp"

namespace robochart::simulation {

/// A picture and its name: "success", "times", "map".
struct SweepPlot {
    std::string name;
    std::string svg;
};

/// The plots for each claim: the fraction of trials against the first variation, with bars for the joint and the
/// pointwise interval and a line for the claimed value. For claims about a time, also the fraction of trials without
/// success over time (Kaplan and Meier). With two variations, also a map of the points.
[[nodiscard]] std::vector<SweepPlot> sweep_plots(const Scenario&, const SweepResult&);

}  // namespace robochart::simulation
