// SPDX-License-Identifier: Apache-2.0
// Draws the world of a scenario as SVG: the arena with walls and lights, axes, a scale bar, robots. The unit is a
// centimetre, and the y axis points down. Sizes of letters and lines are multiples of a dot.
#pragma once

#include <string>
#include <vector>

#include "simulation/report/drawing.hpp"
#include "simulation/trial/trial.hpp"

namespace robochart::simulation {

/// The visible rectangle, in the units of the picture.
struct View {
    double left, top, width, height;
};

/// Returns the view of the arena or, if it has no walls, the bounding box of all robots' paths.
[[nodiscard]] View view_of(const Scenario&, const std::vector<Frame>&);

class WorldDrawing {
public:
    /// `dot` is the size of a dot in centimetres. All ids begin with `prefix`.
    WorldDrawing(const Scenario&, View, double dot, std::string prefix = "s");

    [[nodiscard]] const View& view() const { return view_; }
    [[nodiscard]] double dot() const { return dot_; }
    /// Returns the length of `count` dots, in centimetres.
    [[nodiscard]] double length_of_dots(double count) const { return count * dot_; }

    /// Returns the head of a picture of this rectangle, with title, style and background.
    [[nodiscard]] std::string picture_head(const View& shown, const std::string& what) const;
    /// Draws the arena with its walls.
    [[nodiscard]] std::string draw_floor() const;
    /// Draws the named obstacles that are present in this frame.
    [[nodiscard]] std::string draw_obstacles(const Frame&) const;
    /// Draws the lights at their positions; faint if they are off.
    [[nodiscard]] std::string draw_lights(const Frame&) const;
    [[nodiscard]] std::string lower_axis() const;
    [[nodiscard]] std::string left_axis() const;
    /// Draws a scale bar of a round length, with its right end at this point.
    [[nodiscard]] std::string scale_bar(double right, double y) const;
    /// Returns the legend: entries for states, and for lights and walls if there are any.
    [[nodiscard]] Legend make_legend(const MachineStates&, double width) const;
    [[nodiscard]] std::string symbol_definitions(const MachineStates&) const;
    [[nodiscard]] std::string draw_robot(const Pose&, std::size_t state) const;
    /// Returns the radius of a robot in the drawing: at least two dots, so that the robot is visible.
    [[nodiscard]] double drawn_radius() const;
    /// Returns the width of a robot's outline, in radii.
    [[nodiscard]] double outline_width() const;
    /// Returns legend entries for lights and walls, if there are any.
    [[nodiscard]] std::vector<LegendEntry> object_entries() const;
    /// Returns "translate(...) rotate(...)" for a pose.
    [[nodiscard]] static std::string transform_text(const Pose&);

private:
    const Scenario& scenario_;
    View view_;
    double dot_;
    std::string prefix_;
    bool metres_;  ///< true if the axes are in metres
};

}  // namespace robochart::simulation
