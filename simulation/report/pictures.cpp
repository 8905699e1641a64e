// SPDX-License-Identifier: Apache-2.0
// Draws the pictures of a trial; see pictures.hpp.
#include "simulation/report/pictures.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "base/diagnostics/escape.hpp"

namespace robochart::simulation {

namespace {

/// Margins around the drawing, in dots.
constexpr double left_margin = 54, lower_margin = 46, margin = 12;

const MachineStates& first_machine(const Machines& machines) {
    static const MachineStates none;
    return machines.empty() ? none : machines.front();
}

/// Draws one world, with the legend above, axes and a scale bar. `inside` is drawn after the floor.
std::string frame_picture(const WorldDrawing& world, const Legend& legend, const std::string& head,
                          const std::string& surroundings, const std::string& inside) {
    const View& view = world.view();
    return head + legend.svg(view.left, view.top - world.length_of_dots(margin) - legend.height()) +
           world.draw_floor() + surroundings + world.lower_axis() + world.left_axis() +
           world.scale_bar(view.left + view.width, view.top + view.height + world.length_of_dots(30)) + inside +
           "</svg>\n";
}

/// Returns the view of a picture of one world, including its margins.
View view_with_margins(const WorldDrawing& world, double above) {
    const View& view = world.view();
    return {view.left - world.length_of_dots(left_margin), view.top - above - world.length_of_dots(2 * margin),
            view.width + world.length_of_dots(left_margin + 2 * margin),
            view.height + above + world.length_of_dots(lower_margin + 2 * margin)};
}

/// Writes key frames of values that change rarely. Repeated values are omitted.
std::string animate_changes(const char* attribute, const std::vector<std::string>& values,
                            const std::vector<std::string>& times, double seconds) {
    std::vector<std::string> changed_values, at;
    for (std::size_t i = 0; i < values.size(); ++i)
        if (changed_values.empty() || changed_values.back() != values[i]) {
            changed_values.push_back(values[i]);
            at.push_back(times[i]);
        }
    if (changed_values.size() < 2) return "";
    return fmt::format(
        "<animate attributeName=\"{}\" calcMode=\"discrete\" dur=\"{:g}s\" repeatCount=\"indefinite\" "
        "keyTimes=\"{}\" values=\"{}\"/>",
        attribute, seconds, fmt::join(at, ";"), fmt::join(changed_values, ";"));
}

std::string animate_transform(const char* type, const std::vector<std::string>& values,
                              const std::vector<std::string>& times, double seconds) {
    return fmt::format(
        "<animateTransform attributeName=\"transform\" type=\"{}\" dur=\"{:g}s\" "
        "repeatCount=\"indefinite\" keyTimes=\"{}\" values=\"{}\"/>",
        type, seconds, fmt::join(times, ";"), fmt::join(values, ";"));
}

/// Computes the key frames of an animation, about 240. The browser interpolates between them.
class Animation {
public:
    Animation(const std::vector<Frame>& frames, double speed) {
        const std::size_t every = std::max<std::size_t>(1, frames.size() / 240);
        for (std::size_t f = 0; f < frames.size(); f += every) keys_.push_back(&frames[f]);
        if (keys_.back() != &frames.back()) keys_.push_back(&frames.back());
        end_ = std::max(frames.back().time, 1e-9);
        seconds_ = end_ / speed;
        for (const Frame* key : keys_) times_.push_back(fmt::format("{:.4f}", key->time / end_));
    }

    [[nodiscard]] double end() const { return end_; }
    [[nodiscard]] double seconds() const { return seconds_; }

    [[nodiscard]] std::string animate_robot(std::size_t robot) const {
        std::vector<std::string> places, turns, symbols;
        double heading = keys_.front()->poses[robot].heading;
        for (const Frame* key : keys_) {
            const Pose& pose = key->poses[robot];
            // Turns in the shorter direction.
            heading += normal_angle(pose.heading - heading);
            places.push_back(fmt::format("{:.1f} {:.1f}", pose.at.x, -pose.at.y));
            turns.push_back(fmt::format("{:.0f}", -heading * 180 / std::numbers::pi));
            symbols.push_back(fmt::format("#s{}", key->robot_state(robot)));
        }
        return fmt::format("<g>{}<g>{}<use href=\"{}\">{}</use></g></g>\n",
                           animate_transform("translate", places, times_, seconds_),
                           animate_transform("rotate", turns, times_, seconds_), symbols.front(),
                           animate_changes("href", symbols, times_, seconds_));
    }

    /// True if a light moves or is switched during the trial.
    [[nodiscard]] bool moves_lights() const {
        const auto differs = [&](const Frame* key) {
            for (std::size_t l = 0; l < key->lights.size(); ++l)
                if (key->lights[l].on != keys_.front()->lights[l].on ||
                    key->lights[l].at != keys_.front()->lights[l].at)
                    return true;
            return false;
        };
        return std::ranges::any_of(keys_, differs);
    }

    [[nodiscard]] std::string animate_light(std::size_t light) const {
        std::vector<std::string> places, opacities;
        for (const Frame* key : keys_) {
            const LightNow& now = key->lights[light];
            places.push_back(fmt::format("{:.1f} {:.1f}", now.at.x, -now.at.y));
            opacities.push_back(now.on ? "1" : ".3");
        }
        return fmt::format("<g>{}<circle r=\"6\" fill=\"#f5c400\" stroke=\"#8a6d00\" opacity=\"{}\">{}</circle></g>\n",
                           animate_transform("translate", places, times_, seconds_), opacities.front(),
                           animate_changes("opacity", opacities, times_, seconds_));
    }

private:
    std::vector<const Frame*> keys_;
    std::vector<std::string> times_;
    double end_ = 1;
    double seconds_ = 1;
};

/// Draws the progress of the animation: a mark that moves along a time axis.
std::string time_axis(const WorldDrawing& world, const Animation& animation, double y) {
    const View& view = world.view();
    const auto x = [&](double time) { return view.left + view.width * time / animation.end(); };
    std::string out = fmt::format("<path class=\"sim-axis\" stroke-width=\"{:g}\" d=\"M{:g} {:g}h{:g}\"/>\n",
                                  world.length_of_dots(1), view.left, y, view.width);
    for (const double time : axis_ticks(0, animation.end(), 9))
        out += fmt::format(
            "<path class=\"sim-axis\" stroke-width=\"{4:g}\" d=\"M{0:g} {1:g}v{2:g}\"/><text "
            "class=\"sim-soft\" x=\"{0:g}\" y=\"{3:g}\" font-size=\"{5:g}\" "
            "text-anchor=\"middle\">{6}</text>\n",
            x(time), y, world.length_of_dots(5), y + world.length_of_dots(18), world.length_of_dots(1),
            world.length_of_dots(12), number_text(time));
    out += fmt::format(
        "<text class=\"sim-soft\" x=\"{:g}\" y=\"{:g}\" font-size=\"{:g}\" "
        "text-anchor=\"middle\">time [s]</text>\n",
        view.left + view.width / 2, y + world.length_of_dots(34), world.length_of_dots(12));
    return out + fmt::format(
                     "<circle class=\"sim-mark\" cx=\"{0:g}\" cy=\"{1:g}\" r=\"{2:g}\"><animate "
                     "attributeName=\"cx\" dur=\"{3:g}s\" repeatCount=\"indefinite\" from=\"{0:g}\" "
                     "to=\"{4:g}\"/></circle>\n",
                     view.left, y, world.length_of_dots(5), animation.seconds(), view.left + view.width);
}

std::string draw_robots(const WorldDrawing& world, const Frame& frame) {
    std::string out;
    for (std::size_t r = 0; r < frame.poses.size(); ++r) out += world.draw_robot(frame.poses[r], frame.robot_state(r));
    return out;
}

}  // namespace

const Frame& frame_at(const std::vector<Frame>& frames, double time) {
    return *std::ranges::min_element(
        frames, [&](const Frame& a, const Frame& b) { return std::abs(a.time - time) < std::abs(b.time - time); });
}

std::string snapshots_svg(const Scenario& scenario, const std::vector<Frame>& frames, const Machines& machines) {
    std::vector<double> times = scenario.pictures;
    if (times.empty()) times = {0, scenario.duration};
    std::vector<Frame> shown;
    for (const double time : times) shown.push_back(frame_at(frames, time));
    const View view = view_of(scenario, shown);
    const WorldDrawing world(scenario, view, view.width / 250);
    const double gap = world.length_of_dots(36);
    const double step = view.width + gap;
    const double width = static_cast<double>(shown.size()) * step - gap;
    const Legend legend = world.make_legend(first_machine(machines), width);
    const double caption = world.length_of_dots(22);
    const double above = legend.height() + caption;
    std::string out = world.picture_head(
        {view.left - world.length_of_dots(left_margin), view.top - above - world.length_of_dots(margin),
         width + world.length_of_dots(left_margin + 2 * margin),
         view.height + above + world.length_of_dots(lower_margin + 3 * margin)},
        "snapshots of the first trial");
    out +=
        world.symbol_definitions(first_machine(machines)) + legend.svg(view.left, view.top - above) + world.left_axis();
    for (std::size_t i = 0; i < shown.size(); ++i)
        out += fmt::format(
            "<g transform=\"translate({:g} 0)\">\n<text class=\"sim-text\" x=\"{:g}\" y=\"{:g}\" "
            "font-size=\"{:g}\" text-anchor=\"middle\">{:g} s</text>\n{}{}{}</g>\n",
            static_cast<double>(i) * step, view.left + view.width / 2, view.top - world.length_of_dots(7),
            world.length_of_dots(14), shown[i].time,
            world.draw_floor() + world.draw_obstacles(shown[i]) + world.draw_lights(shown[i]), world.lower_axis(),
            draw_robots(world, shown[i]));
    return out + world.scale_bar(view.left + width, view.top + view.height + world.length_of_dots(48)) + "</svg>\n";
}

std::string trajectories_svg(const Scenario& scenario, const std::vector<Frame>& frames) {
    const View view = view_of(scenario, frames);
    const WorldDrawing world(scenario, view, view.width / 600);
    const auto path = [](std::size_t begin, std::size_t end, const std::function<std::string(std::size_t)>& point) {
        std::string points;
        for (std::size_t f = begin; f <= end; ++f) points += point(f);
        return points;
    };
    std::vector<LegendEntry> entries{
        {"<path d=\"M-7 0H0\" stroke=\"#0072b2\" stroke-width=\"2\" opacity=\".3\"/><path d=\"M0 0H7\" "
         "stroke=\"#0072b2\" stroke-width=\"2\" opacity=\".8\"/>",
         fmt::format("path, faint at 0 s, strong at {} s", number_text(frames.back().time))},
        {"<circle class=\"sim-body\" r=\"6\" fill=\"#0072b2\"/>", "robot at the end"}};
    const std::vector<LegendEntry> things = world.object_entries();
    entries.insert(entries.end(), things.begin(), things.end());
    const Legend legend(std::move(entries), view.width, world.dot());
    constexpr std::size_t pieces = 8;
    std::string inside;
    for (std::size_t r = 0; r < frames.front().poses.size(); ++r)
        for (std::size_t piece = 0; piece < pieces; ++piece) {
            const std::size_t begin = frames.size() * piece / pieces;
            const std::size_t end = std::min(frames.size() * (piece + 1) / pieces, frames.size() - 1);
            inside += fmt::format(
                "<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{:g}\" opacity=\"{:.2f}\"/>\n",
                path(begin, end,
                     [&](std::size_t f) {
                         return fmt::format("{:.1f},{:.1f} ", frames[f].poses[r].at.x, -frames[f].poses[r].at.y);
                     }),
                series_colour(r), world.length_of_dots(1.6), 0.3 + 0.6 * static_cast<double>(piece) / pieces);
        }
    const double radius = world.drawn_radius();
    for (std::size_t r = 0; r < frames.back().poses.size(); ++r)
        inside += fmt::format(
            "<g transform=\"{0}\"><circle class=\"sim-body\" r=\"{1:g}\" fill=\"{2}\" "
            "stroke-width=\"{3:g}\"/><path class=\"sim-one\" stroke-width=\"{3:g}\" d=\"M0 0H{1:g}\"/></g>\n",
            WorldDrawing::transform_text(frames.back().poses[r]), radius, series_colour(r),
            world.outline_width() * radius);
    return frame_picture(
        world, legend,
        world.picture_head(view_with_margins(world, legend.height()), "paths of the robots in the first trial"),
        world.draw_obstacles(frames.back()) + world.draw_lights(frames.back()), inside);
}

std::string animation_svg(const Scenario& scenario, const std::vector<Frame>& frames, const Machines& machines,
                          double speed) {
    const Animation animation(frames, speed);
    const View view = view_of(scenario, frames);
    const WorldDrawing world(scenario, view, view.width / 600);
    const Legend legend = world.make_legend(first_machine(machines), view.width);
    View shown = view_with_margins(world, legend.height());
    shown.height += world.length_of_dots(40);
    std::string inside = world.symbol_definitions(first_machine(machines));
    inside +=
        "<style>.still{display:none}@media (prefers-reduced-motion:reduce){.moving{display:none}"
        ".still{display:inline}}</style>\n<g class=\"still\">\n" +
        (animation.moves_lights() ? world.draw_lights(frames.back()) : "") + draw_robots(world, frames.back()) +
        "</g>\n<g class=\"moving\">\n";
    for (std::size_t r = 0; r < frames.front().poses.size(); ++r) inside += animation.animate_robot(r);
    if (animation.moves_lights())
        for (std::size_t light = 0; light < scenario.lights.size(); ++light) inside += animation.animate_light(light);
    inside += time_axis(world, animation, view.top + view.height + world.length_of_dots(lower_margin + 4)) + "</g>\n";
    return frame_picture(
        world, legend, world.picture_head(shown, fmt::format("the first trial, {:g} times as fast", speed)),
        world.draw_obstacles(frames.back()) + (animation.moves_lights() ? "" : world.draw_lights(frames.back())),
        inside);
}

WorldDrawing page_world(const Scenario& scenario, const View& view, const std::string& prefix) {
    return {scenario, view, view.width / 600, prefix};
}

std::string world_svg(const Scenario& scenario, const View& view, const Frame& last, const Machines& machines,
                      const std::string& prefix) {
    const WorldDrawing world = page_world(scenario, view, prefix);
    const View shown = view_with_margins(world, 0);
    std::string out = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"{:g} {:g} {:g} {:g}\" role=\"img\" "
        "font-family=\"DejaVu Sans, Verdana, sans-serif\">\n<title>the robots at the time shown</title>\n",
        shown.left, shown.top, shown.width, shown.height);
    out += world.symbol_definitions(first_machine(machines)) + world.draw_floor() + world.draw_obstacles(last) +
           world.draw_lights(last) + world.lower_axis() + world.left_axis() +
           world.scale_bar(view.left + view.width, view.top + view.height + world.length_of_dots(30));
    out += fmt::format(
        "<path class=\"sim-links\" stroke-width=\"{0:g}\"/><path class=\"sim-trail\" stroke-width=\"{0:g}\"/>\n",
        world.length_of_dots(1.5));
    for (std::size_t r = 0; r < last.poses.size(); ++r)
        out += fmt::format("<use class=\"sim-robot\" data-robot=\"{}\" href=\"#{}{}\" transform=\"{}\"/>\n", r, prefix,
                           last.robot_state(r), WorldDrawing::transform_text(last.poses[r]));
    return out + fmt::format("<circle class=\"sim-chosen\" r=\"{:g}\" stroke-width=\"{:g}\"/>\n</svg>\n",
                             world.drawn_radius() + world.length_of_dots(5), world.length_of_dots(2.5));
}

std::string positions_csv(const std::vector<Frame>& frames, const Machines& machines) {
    std::string out = "t,id,x,y,theta";
    for (const MachineStates& machine : machines)
        out += machines.size() == 1 ? std::string(",state") : ",state:" + machine.name;
    out += "\n";
    for (const Frame& frame : frames)
        for (std::size_t r = 0; r < frame.poses.size(); ++r) {
            const Pose& pose = frame.poses[r];
            out += fmt::format("{:.3f},{},{:.4f},{:.4f},{:.5f}", frame.time, r, pose.at.x, pose.at.y, pose.heading);
            for (std::size_t m = 0; m < machines.size(); ++m)
                out += "," + machines[m].state_name(frame.robot_state(r, m));
            out += "\n";
        }
    return out;
}

}  // namespace robochart::simulation
