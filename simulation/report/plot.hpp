// SPDX-License-Identifier: Apache-2.0
// Draws charts as SVG: the median of the trials, bands for the middle half and the range, and the values that the
// scenario accepts.
#pragma once

#include <string>

#include "simulation/report/chart_frame.hpp"
#include "simulation/report/series.hpp"

namespace robochart::simulation {

/// Draws a chart over times in s. With `trial_lines`, it also has a line per trial, with the class `sim-trial` and the
/// index of the trial in `data-trial`. The page shows one of these lines.
[[nodiscard]] ChartFrame draw_plot(const Chart&, const std::vector<double>& times, bool trial_lines);

/// Draws all charts of a run below each other in one picture.
[[nodiscard]] std::string plots_svg(const Scenario&, const Charts&);

}  // namespace robochart::simulation
