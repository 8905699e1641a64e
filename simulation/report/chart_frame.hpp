// SPDX-License-Identifier: Apache-2.0
// Draws what all charts have in common: the title, the legend, the axes with their scales and ticks, and the style of
// lines and areas. Each chart adds its own marks.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "simulation/report/drawing.hpp"

namespace robochart::simulation {

/// An axis of a chart. Its texts are escaped when the chart is drawn.
struct Axis {
    struct Tick {
        double value = 0;
        std::string text;
    };
    std::string label;  ///< "" for a vertical axis without a label
    double low = 0;     ///< the value at its left or lower end
    double high = 1;    ///< the value at its other end; greater than `low`
    std::vector<Tick> ticks;
};
/// Makes an axis with at most `most_ticks` round numbers. It ends at `low` + 1 if `high` is not greater than `low`.
[[nodiscard]] Axis number_axis(std::string label, double low, double high, std::size_t most_ticks);

/// The rectangle between the axes of a chart, in pixels from the upper left corner of the chart.
struct PlotArea {
    double left = 0, top = 0, width = 0, height = 0;
};

/// A chart, which consists of the frame and the marks that were added on top of it.
class ChartFrame {
public:
    /// The width and height are those of the area between the axes, in pixels.
    ChartFrame(std::string title, std::vector<LegendEntry> legend, Axis horizontal, Axis vertical, double width = 550,
               double height = 260);

    /// Returns the position of a value, in pixels. Vertically, values beyond the ends of the axis are drawn at its
    /// ends.
    [[nodiscard]] double x(double value) const;
    [[nodiscard]] double y(double value) const;
    /// Returns "X,Y " for a point of a line or polygon.
    [[nodiscard]] std::string point(double x_value, double y_value) const;
    /// Adds SVG elements.
    void add(const std::string& marks) { content_ += marks; }

    [[nodiscard]] const PlotArea& area() const { return area_; }
    /// Returns the size with title, legend and labels, in pixels.
    [[nodiscard]] double width() const;
    [[nodiscard]] double height() const;
    /// Returns the elements of the chart, for a picture that contains picture_style().
    [[nodiscard]] const std::string& content() const { return content_; }
    /// Returns the chart as a complete picture.
    [[nodiscard]] std::string svg() const;

private:
    void draw_axes();

    std::string title_;
    Axis horizontal_, vertical_;
    PlotArea area_;
    std::string content_;
};

/// Draws the charts below each other in one picture.
[[nodiscard]] std::string charts_svg(const std::string& title, const std::vector<ChartFrame>& charts);

/// Returns the attributes of the line with this number: its colour, width and dashes.
[[nodiscard]] std::string line_style(std::size_t number);
/// Returns the legend entry of the line with this number.
[[nodiscard]] LegendEntry line_entry(std::size_t number, std::string text);
/// Returns the legend entry of an area, in the colour of the line with this number.
[[nodiscard]] LegendEntry area_entry(std::size_t number, double opacity, std::string text);

}  // namespace robochart::simulation
