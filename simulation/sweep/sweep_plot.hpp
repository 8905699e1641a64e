// Plots of a sweep as SVG, in the style of the other pictures of a simulation.
#pragma once

#include <string>
#include <vector>

#include "simulation/sweep/sweep_report.hpp"

namespace robochart::simulation {

/// A picture and what it is called: "success", "times", "map".
struct SweepPlot {
    std::string name;
    std::string svg;
};

/// For each claim: the share of trials over the first variation, with bars for the joint and the pointwise interval and
/// a line for what is claimed; where it is about a time, how many trials it has not come for (Kaplan and Meier); with
/// two variations a map of them.
[[nodiscard]] std::vector<SweepPlot> sweep_plots(const Scenario&, const SweepResult&);

}  // namespace robochart::simulation
