// SPDX-License-Identifier: Apache-2.0
// Charts as SVG: the median of the trials, the middle half and the range as bands, and the values that the scenario
// accepts.
#pragma once

#include <string>

#include "simulation/report/series.hpp"

namespace robochart::simulation {

/// Options for writing a chart.
struct PlotOptions {
    bool trials = false;  ///< also a hidden line per trial, with the class `sim-trial` and `data-trial`
    bool now = false;     ///< also a line for the current time, with the class `sim-now`
};

/// The plotted area in every plot, in the units of its view box.
struct PlotArea {
    double left = 62, top = 0, width = 440, height = 180;
};

/// A group for a chart with its upper left corner at the origin, and its height.
struct Plot {
    std::string svg;
    double width = 520;
    double height = 0;
    PlotArea area;
};
[[nodiscard]] Plot draw_plot(const Chart&, const std::vector<double>& times, const PlotOptions& = {});

/// All charts of a run below each other, as a picture.
[[nodiscard]] std::string plots_svg(const Scenario&, const Charts&);

}  // namespace robochart::simulation
