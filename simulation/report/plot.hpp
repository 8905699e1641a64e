// SPDX-License-Identifier: Apache-2.0
// Charts as SVG: the median of the trials, the middle half and the range as bands, and the values that the scenario
// accepts.
#pragma once

#include <string>

#include "simulation/report/chart_frame.hpp"
#include "simulation/report/series.hpp"

namespace robochart::simulation {

/// Draws a chart over times in s. With `trial_lines`, it also has a line per trial, with the class `sim-trial` and
/// `data-trial`, the index of the trial; the page shows one of them.
[[nodiscard]] ChartFrame draw_plot(const Chart&, const std::vector<double>& times, bool trial_lines);

/// All charts of a run below each other, as a picture.
[[nodiscard]] std::string plots_svg(const Scenario&, const Charts&);

}  // namespace robochart::simulation
