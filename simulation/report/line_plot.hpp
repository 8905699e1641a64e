// SPDX-License-Identifier: Apache-2.0
// Draws line plots as SVG: computed or estimated values against a parameter, with intervals as bars.
#pragma once

#include <string>
#include <vector>

namespace robochart::simulation {

struct PlotPoint {
    double x = 0, y = 0;
    double low = 0, high = 0;  ///< an interval around y; no interval if both are y
};

struct PlotLine {
    std::string name;
    std::vector<PlotPoint> points;  ///< ascending x; finite numbers only
};

/// Draws the lines over an axis that is labelled with the parameter. The vertical axis includes 0.
[[nodiscard]] std::string line_plot_svg(const std::string& title, const std::string& parameter,
                                        const std::vector<PlotLine>& lines);

}  // namespace robochart::simulation
