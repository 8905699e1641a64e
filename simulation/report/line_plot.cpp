// SPDX-License-Identifier: Apache-2.0
#include "simulation/report/line_plot.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/diagnostics/escape.hpp"
#include "simulation/report/drawing.hpp"

namespace robochart::simulation {
namespace {

using diagnostics::xml_text;

/// The ends of an axis.
struct Span {
    double low = 0, high = 1;

    void include(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
    [[nodiscard]] double share(double value) const { return (value - low) / (high - low); }
};

class LinePlotter {
public:
    explicit LinePlotter(const LinePlot& plot) : plot_(plot), legend_(legend_entries(), width, 1) {
        top_ = 34 + legend_.height() + 12;
        bool first = true;
        for (const PlotLine& line : plot.lines)
            for (const PlotPoint& point : line.points) {
                if (first) {
                    x_ = {point.x, point.x};
                    y_ = {std::min(0.0, point.low), point.high};
                }
                first = false;
                x_.include(point.x);
                y_.include(point.low);
                y_.include(point.high);
            }
        if (!(x_.high > x_.low)) x_ = {x_.low - 1, x_.high + 1};
        if (!(y_.high > y_.low)) y_.high = y_.low + 1;
    }

    std::string operator()() {
        draw_axes();
        for (std::size_t i = 0; i < plot_.lines.size(); ++i) draw_line(i);
        const double total = top_ + height + 54;
        return fmt::format(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 520 {0:g}\" width=\"520\" height=\"{0:g}\" "
            "role=\"img\" font-family=\"DejaVu Sans, Verdana, sans-serif\" font-size=\"12\">\n<title>{1}</title>\n"
            "<style>{2}</style>\n<rect class=\"sim-paper\" width=\"520\" height=\"{0:g}\"/>\n"
            "<text class=\"sim-text\" x=\"{3:g}\" y=\"22\" font-size=\"14\" font-weight=\"bold\">{1}</text>\n{4}{5}"
            "</svg>\n",
            total, xml_text(plot_.title), picture_style(), left, legend_.svg(left, 34), out_);
    }

private:
    static constexpr double left = 62, width = 440, height = 240;

    [[nodiscard]] std::vector<LegendEntry> legend_entries() const {
        std::vector<LegendEntry> list;
        for (std::size_t i = 0; i < plot_.lines.size(); ++i)
            list.push_back({fmt::format("<path d=\"M-7 0H7\" stroke=\"{}\" stroke-width=\"2\"/>", series_colour(i)),
                            plot_.lines[i].name});
        return list;
    }

    [[nodiscard]] double x(double value) const { return left + width * x_.share(value); }
    [[nodiscard]] double y(double value) const { return top_ + height * (1 - y_.share(value)); }

    void draw_axes() {
        const double bottom = top_ + height;
        for (const double value : axis_ticks(y_.low, y_.high, 6))
            out_ += fmt::format(
                "<path class=\"sim-grid\" d=\"M{:g} {:.1f}H{:g}\"/><text class=\"sim-soft\" x=\"{:g}\" y=\"{:.1f}\" "
                "text-anchor=\"end\">{}</text>\n",
                left, y(value), left + width, left - 6, y(value) + 4, number_text(value));
        for (const double value : axis_ticks(x_.low, x_.high, 8))
            out_ += fmt::format(
                "<path class=\"sim-axis\" d=\"M{0:.1f} {1:g}v5\"/><text class=\"sim-soft\" x=\"{0:.1f}\" y=\"{2:g}\" "
                "text-anchor=\"middle\">{3}</text>\n",
                x(value), bottom, bottom + 18, number_text(value));
        out_ += fmt::format(
            "<path class=\"sim-axis\" d=\"M{0:g} {1:g}V{2:g}H{3:g}\"/>\n<text class=\"sim-soft\" x=\"{4:g}\" "
            "y=\"{5:g}\" text-anchor=\"middle\">{6}</text>\n",
            left, top_, bottom, left + width, left + width / 2, bottom + 38, xml_text(plot_.parameter));
    }

    /// Points with their intervals, connected by lines.
    void draw_line(std::size_t number) {
        std::string joined;
        for (const PlotPoint& point : plot_.lines[number].points) {
            joined += fmt::format("{}{:.1f},{:.1f}", joined.empty() ? "" : " ", x(point.x), y(point.y));
            out_ += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.5\" fill=\"{}\"/>\n", x(point.x), y(point.y),
                                series_colour(number));
            if (point.low < point.high)
                out_ += fmt::format("<path d=\"M{0:.1f} {1:.1f}V{2:.1f}\" stroke=\"{3}\"/>\n", x(point.x), y(point.low),
                                    y(point.high), series_colour(number));
        }
        out_ += fmt::format("<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.5\"/>\n", joined,
                            series_colour(number));
    }

    const LinePlot& plot_;
    Legend legend_;
    double top_ = 0;
    Span x_, y_;
    std::string out_;
};

}  // namespace

std::string line_plot_svg(const LinePlot& plot) {
    return LinePlotter(plot)();
}

}  // namespace robochart::simulation
