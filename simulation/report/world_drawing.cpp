// SPDX-License-Identifier: Apache-2.0
#include "simulation/report/world_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/diagnostics/escape.hpp"

namespace robochart::simulation {

using diagnostics::xml_text;

View view_of(const Scenario& scenario, const std::vector<Frame>& frames) {
    const Arena& arena = scenario.world.arena;
    View view{-arena.width / 2, -arena.height / 2, arena.width, arena.height};
    if (arena.walled) return view;
    double across = arena.width / 2;
    double along = arena.height / 2;
    for (const Frame& frame : frames)
        for (const Pose& pose : frame.poses) {
            across = std::max(across, std::abs(pose.at.x) + 5);
            along = std::max(along, std::abs(pose.at.y) + 5);
        }
    return {-across, -along, 2 * across, 2 * along};
}

WorldDrawing::WorldDrawing(const Scenario& scenario, View view, double dot, std::string prefix)
    : scenario_(scenario),
      view_(view),
      dot_(dot),
      prefix_(std::move(prefix)),
      metres_(std::max(view.width, view.height) >= 1000) {}

std::string WorldDrawing::picture_head(const View& shown, const std::string& what) const {
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{0:g} {1:g} {2:g} {3:g}\" width=\"{4:.0f}\" "
        "height=\"{5:.0f}\" role=\"img\" font-family=\"DejaVu Sans, Verdana, sans-serif\">\n<title>{6}: {7}</title>\n"
        "<style>{8}</style>\n<rect class=\"sim-paper\" x=\"{0:g}\" y=\"{1:g}\" width=\"{2:g}\" height=\"{3:g}\"/>\n",
        shown.left, shown.top, shown.width, shown.height, shown.width / dot_, shown.height / dot_,
        xml_text(scenario_.name.text), what, picture_style());
}

std::string WorldDrawing::draw_floor() const {
    std::string out = fmt::format(
        "<rect class=\"sim-floor\" x=\"{:g}\" y=\"{:g}\" width=\"{:g}\" height=\"{:g}\" stroke-width=\"{:g}\"{}/>\n",
        view_.left, view_.top, view_.width, view_.height, length_of_dots(1.5),
        scenario_.world.arena.walled ? "" : fmt::format(" stroke-dasharray=\"{:g}\"", length_of_dots(4)));
    for (const Segment& wall : scenario_.world.arena.walls)
        out += fmt::format(
            "<line class=\"sim-axis\" x1=\"{:g}\" y1=\"{:g}\" x2=\"{:g}\" y2=\"{:g}\" stroke-width=\"{:g}\"/>\n",
            wall.from.x, -wall.from.y, wall.to.x, -wall.to.y, length_of_dots(3));
    return out;
}

std::string WorldDrawing::draw_obstacles(const Frame& frame) const {
    std::string out;
    for (std::size_t o = 0; o < scenario_.obstacles.size(); ++o) {
        const Obstacle& obstacle = scenario_.obstacles[o];
        if (!(frame.obstacles.empty() ? obstacle.there : frame.obstacles[o])) continue;
        std::string corners;
        for (const Vector corner : obstacle.corners) corners += fmt::format("{:g},{:g} ", corner.x, -corner.y);
        out += fmt::format(
            "<polygon class=\"sim-axis\" points=\"{}\" fill=\"none\" "
            "stroke-width=\"{:g}\"><title>{}</title></polygon>\n",
            corners, length_of_dots(3), xml_text(obstacle.name.text));
    }
    return out;
}

std::string WorldDrawing::draw_lights(const Frame& frame) const {
    std::string out;
    for (std::size_t l = 0; l < scenario_.lights.size(); ++l) {
        const LightNow light = light_at(scenario_, frame, l);
        out += fmt::format(
            "<circle cx=\"{:g}\" cy=\"{:g}\" r=\"6\" fill=\"#f5c400\" "
            "stroke=\"#8a6d00\"{}><title>{}</title></circle>\n",
            light.at.x, -light.at.y, light.on ? "" : " opacity=\".3\"", xml_text(scenario_.lights[l].name.text));
    }
    return out;
}

std::string WorldDrawing::lower_axis() const {
    const double bottom = view_.top + view_.height;
    std::string out;
    for (const double x : axis_ticks(view_.left, view_.left + view_.width, view_.width / dot_ < 350 ? 4 : 7))
        out += fmt::format(
            "<path class=\"sim-axis\" stroke-width=\"{4:g}\" d=\"M{0:g} {1:g}v{2:g}\"/><text class=\"sim-soft\" "
            "x=\"{0:g}\" y=\"{3:g}\" font-size=\"{5:g}\" text-anchor=\"middle\">{6}</text>\n",
            x, bottom, length_of_dots(5), bottom + length_of_dots(18), length_of_dots(1), length_of_dots(12),
            number_text(metres_ ? x / 100 : x));
    return out + fmt::format(
                     "<text class=\"sim-soft\" x=\"{:g}\" y=\"{:g}\" font-size=\"{:g}\" "
                     "text-anchor=\"middle\">x [{}]</text>\n",
                     view_.left + view_.width / 2, bottom + length_of_dots(34), length_of_dots(12),
                     metres_ ? "m" : "cm");
}

std::string WorldDrawing::left_axis() const {
    std::string out;
    for (const double y : axis_ticks(-view_.top - view_.height, -view_.top, view_.height / dot_ < 350 ? 4 : 7))
        out += fmt::format(
            "<path class=\"sim-axis\" stroke-width=\"{4:g}\" d=\"M{0:g} {1:g}h{2:g}\"/><text class=\"sim-soft\" "
            "x=\"{3:g}\" y=\"{7:g}\" font-size=\"{5:g}\" text-anchor=\"end\">{6}</text>\n",
            view_.left, -y, -length_of_dots(5), view_.left - length_of_dots(8), length_of_dots(1), length_of_dots(12),
            number_text(metres_ ? y / 100 : y), -y + length_of_dots(4));
    return out + fmt::format(
                     "<text class=\"sim-soft\" transform=\"translate({:g} {:g}) rotate(-90)\" "
                     "font-size=\"{:g}\" text-anchor=\"middle\">y [{}]</text>\n",
                     view_.left - length_of_dots(42), view_.top + view_.height / 2, length_of_dots(12),
                     metres_ ? "m" : "cm");
}

std::string WorldDrawing::scale_bar(double right, double y) const {
    const std::vector<double> steps = axis_ticks(0, view_.width, 7);
    const double length = steps.size() > 1 ? steps[1] : view_.width;
    return fmt::format(
        "<path class=\"sim-axis\" stroke-width=\"{0:g}\" d=\"M{1:g} {2:g}v{3:g}M{1:g} {4:g}H{5:g}M{5:g} {2:g}v{3:g}\"/>"
        "<text class=\"sim-soft\" x=\"{6:g}\" y=\"{7:g}\" font-size=\"{8:g}\" text-anchor=\"end\">{9} {10}</text>\n",
        length_of_dots(1.5), right - length, y - length_of_dots(4), length_of_dots(8), y, right,
        right - length - length_of_dots(6), y + length_of_dots(4), length_of_dots(12),
        number_text(metres_ ? length / 100 : length), metres_ ? "m" : "cm");
}

Legend WorldDrawing::make_legend(const MachineStates& machine, double width) const {
    std::vector<LegendEntry> entries = state_entries(machine, drawn_radius(), prefix_);
    const std::vector<LegendEntry> more = object_entries();
    entries.insert(entries.end(), more.begin(), more.end());
    return {std::move(entries), width, dot_};
}

double WorldDrawing::drawn_radius() const {
    return std::max(scenario_.world.body.radius, length_of_dots(2));
}

double WorldDrawing::outline_width() const {
    return std::min(0.12, length_of_dots(1.5) / drawn_radius());
}

std::vector<LegendEntry> WorldDrawing::object_entries() const {
    std::vector<LegendEntry> entries;
    if (!scenario_.lights.empty())
        entries.push_back({"<circle r=\"6\" fill=\"#f5c400\" stroke=\"#8a6d00\"/>", "light"});
    if (!scenario_.world.arena.walls.empty() || !scenario_.obstacles.empty())
        entries.push_back({"<path class=\"sim-axis\" stroke-width=\"3\" d=\"M-6 0H6\"/>", "wall"});
    return entries;
}

std::string WorldDrawing::symbol_definitions(const MachineStates& machine) const {
    return robot_symbols(machine.states.size(), drawn_radius(), outline_width(), prefix_);
}

std::string WorldDrawing::transform_text(const Pose& pose) {
    return fmt::format("translate({:.1f} {:.1f}) rotate({:.0f})", pose.at.x, -pose.at.y,
                       -pose.heading * 180 / std::numbers::pi);
}

std::string WorldDrawing::draw_robot(const Pose& pose, std::size_t state) const {
    return fmt::format("<use href=\"#{}{}\" transform=\"{}\"/>\n", prefix_, state, transform_text(pose));
}

}  // namespace robochart::simulation
