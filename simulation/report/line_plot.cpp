// SPDX-License-Identifier: Apache-2.0
#include "simulation/report/line_plot.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "simulation/report/chart_frame.hpp"

namespace robochart::simulation {
namespace {

ChartFrame frame_of_lines(const std::string& title, const std::string& parameter, const std::vector<PlotLine>& lines) {
    std::vector<LegendEntry> legend;
    std::vector<double> xs;
    double low = 0;
    double high = 0;
    for (const PlotLine& line : lines) {
        legend.push_back(line_entry(legend.size(), line.name));
        for (const PlotPoint& point : line.points) {
            xs.push_back(point.x);
            low = std::min(low, point.low);
            high = std::max(high, point.high);
        }
    }
    if (xs.empty()) xs.push_back(0);
    const auto [left, right] = std::ranges::minmax(xs);
    return {title, std::move(legend), number_axis(parameter, left, right, 8), number_axis("", low, high, 6)};
}

}  // namespace

std::string line_plot_svg(const std::string& title, const std::string& parameter, const std::vector<PlotLine>& lines) {
    ChartFrame frame = frame_of_lines(title, parameter, lines);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        std::string points;
        for (const PlotPoint& point : lines[i].points) {
            points += frame.point(point.x, point.y);
            frame.add(fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.5\" fill=\"{}\"/>\n", frame.x(point.x),
                                  frame.y(point.y), series_colour(i)));
            if (point.low < point.high)
                frame.add(fmt::format("<path d=\"M{:.1f} {:.1f}V{:.1f}\" stroke=\"{}\"/>\n", frame.x(point.x),
                                      frame.y(point.low), frame.y(point.high), series_colour(i)));
        }
        frame.add(fmt::format("<polyline points=\"{}\" {}/>\n", points, line_style(i)));
    }
    return frame.svg();
}

}  // namespace robochart::simulation
