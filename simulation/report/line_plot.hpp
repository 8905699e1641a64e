// Lines over a parameter as SVG: what was computed or estimated for each of its values, with intervals as bars.
#pragma once

#include <string>
#include <vector>

namespace robochart::simulation {

struct PlotPoint {
    double x = 0, y = 0;
    double low = 0, high = 0;  ///< an interval around y; equal to it: none
};

struct PlotLine {
    std::string name;
    std::vector<PlotPoint> points;  ///< by ascending x; only finite numbers
};

struct LinePlot {
    std::string title;
    std::string parameter;  ///< the name of the horizontal axis
    std::vector<PlotLine> lines;
};

[[nodiscard]] std::string line_plot_svg(const LinePlot& plot);

}  // namespace robochart::simulation
