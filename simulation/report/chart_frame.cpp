// SPDX-License-Identifier: Apache-2.0
// See chart_frame.hpp.
#include "simulation/report/chart_frame.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "base/diagnostics/escape.hpp"

namespace robochart::simulation {
namespace {

using diagnostics::xml_text;

double share_of_axis(const Axis& axis, double value) {
    return (value - axis.low) / (axis.high - axis.low);
}

}  // namespace

Axis number_axis(std::string label, double low, double high, std::size_t most_ticks) {
    Axis axis{std::move(label), low, high > low ? high : low + 1, {}};
    for (const double value : axis_ticks(axis.low, axis.high, most_ticks))
        axis.ticks.push_back({value, number_text(value)});
    return axis;
}

ChartFrame::ChartFrame(std::string title, std::vector<LegendEntry> entries, Axis horizontal, Axis vertical,
                       double width, double height)
    : title_(std::move(title)), horizontal_(std::move(horizontal)), vertical_(std::move(vertical)) {
    constexpr double margin = 12, legend_top = 30, letter = 0.62;  // letter: its width divided by the font size
    const Legend legend(std::move(entries), width, 1);
    area_ = {62, legend_top + legend.height() + 14, width, height};
    const double fitting_size = (this->width() - 2 * margin) / (letter * static_cast<double>(title_.size() + 1));
    content_ =
        fmt::format("<text class=\"sim-text\" x=\"{}\" y=\"20\" font-size=\"{:.3g}\" font-weight=\"bold\">{}</text>\n",
                    margin, std::min(14.0, fitting_size), xml_text(title_));
    content_ += legend.svg(area_.left, legend_top);
    draw_axes();
}

void ChartFrame::draw_axes() {
    const double bottom = area_.top + area_.height;
    const double right = area_.left + area_.width;
    for (const Axis::Tick& tick : vertical_.ticks)
        content_ += fmt::format(
            "<path class=\"sim-grid\" d=\"M{:g} {:.1f}H{:g}\"/><text class=\"sim-soft\" x=\"{:g}\" y=\"{:.1f}\" "
            "text-anchor=\"end\">{}</text>\n",
            area_.left, y(tick.value), right, area_.left - 6, y(tick.value) + 4, xml_text(tick.text));
    for (const Axis::Tick& tick : horizontal_.ticks)
        content_ += fmt::format(
            "<path class=\"sim-axis\" d=\"M{0:.1f} {1:g}v5\"/><text class=\"sim-soft\" x=\"{0:.1f}\" y=\"{2:g}\" "
            "text-anchor=\"middle\">{3}</text>\n",
            x(tick.value), bottom, bottom + 18, xml_text(tick.text));
    content_ += fmt::format(
        "<path class=\"sim-axis\" d=\"M{0:g} {1:g}V{2:g}H{3:g}\"/>\n<text class=\"sim-soft\" x=\"{4:g}\" y=\"{5:g}\" "
        "text-anchor=\"middle\">{6}</text>\n",
        area_.left, area_.top, bottom, right, area_.left + area_.width / 2, bottom + 38, xml_text(horizontal_.label));
    if (vertical_.label.empty()) return;
    content_ += fmt::format(
        "<text class=\"sim-soft\" transform=\"translate(14 {:g}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n",
        area_.top + area_.height / 2, xml_text(vertical_.label));
}

double ChartFrame::x(double value) const {
    return area_.left + area_.width * share_of_axis(horizontal_, value);
}

double ChartFrame::y(double value) const {
    return area_.top + area_.height * (1 - std::clamp(share_of_axis(vertical_, value), 0.0, 1.0));
}

std::string ChartFrame::point(double x_value, double y_value) const {
    return fmt::format("{:.1f},{:.1f} ", x(x_value), y(y_value));
}

double ChartFrame::width() const {
    return area_.left + area_.width + 28;
}

double ChartFrame::height() const {
    return area_.top + area_.height + 48;
}

std::string ChartFrame::svg() const {
    return charts_svg(title_, {*this});
}

std::string charts_svg(const std::string& title, const std::vector<ChartFrame>& charts) {
    double width = 1;  // converters refuse pictures of size 0
    double height = 1;
    std::string groups;
    for (const ChartFrame& chart : charts) {
        groups += fmt::format("<g transform=\"translate(0 {:g})\">\n{}</g>\n", height, chart.content());
        width = std::max(width, chart.width());
        height += chart.height();
    }
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:g} {1:g}\" width=\"{0:g}\" height=\"{1:g}\" "
        "role=\"img\" font-family=\"DejaVu Sans, Verdana, sans-serif\" font-size=\"12\">\n<title>{2}</title>\n"
        "<style>{3}</style>\n<rect class=\"sim-paper\" width=\"{0:g}\" height=\"{1:g}\"/>\n{4}</svg>\n",
        width, height, xml_text(title), picture_style(), groups);
}

std::string line_style(std::size_t number) {
    constexpr std::array<const char*, 3> dashes = {"none", "7 3", "2 2.5"};
    return fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"2\" stroke-dasharray=\"{}\"", series_colour(number),
                       dashes.at(number % dashes.size()));
}

LegendEntry line_entry(std::size_t number, std::string text) {
    return {fmt::format("<path d=\"M-7 0H7\" {}/>", line_style(number)), std::move(text)};
}

LegendEntry area_entry(std::size_t number, double opacity, std::string text) {
    return {fmt::format("<rect x=\"-7\" y=\"-5\" width=\"14\" height=\"10\" fill=\"{}\" fill-opacity=\"{:g}\"/>",
                        series_colour(number), opacity),
            std::move(text)};
}

}  // namespace robochart::simulation
