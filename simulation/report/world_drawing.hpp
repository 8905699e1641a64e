// The world of a scenario as SVG: the arena with walls and lights, axes, a scale bar, robots. The unit is a centimetre,
// the y axis points down; sizes of letters and lines are multiples of a dot.
#pragma once

#include <string>
#include <vector>

#include "simulation/report/drawing.hpp"
#include "simulation/trial/trial.hpp"

namespace robochart::simulation {

/// What is seen: a rectangle in the units of the picture.
struct View {
    double left, top, width, height;
};

/// The arena, or all the robots' paths where it has no walls.
[[nodiscard]] View view_of(const Scenario&, const std::vector<Frame>&);

class WorldDrawing {
public:
    /// `dot`: its size in centimetres; `prefix`: of ids.
    WorldDrawing(const Scenario&, View, double dot, std::string prefix = "s");

    [[nodiscard]] const View& view() const { return view_; }
    [[nodiscard]] double dot() const { return dot_; }
    /// Of so many dots, in centimetres.
    [[nodiscard]] double dots(double count) const { return count * dot_; }

    /// The head of a picture that shows this rectangle, with title, style and background.
    [[nodiscard]] std::string head(const View& shown, const std::string& what) const;
    /// The arena with its walls.
    [[nodiscard]] std::string floor() const;
    /// Obstacles that come and go, as far as they are there then.
    [[nodiscard]] std::string obstacles(const Frame&) const;
    /// Lights where they are, faint if they are off.
    [[nodiscard]] std::string lights(const Frame&) const;
    [[nodiscard]] std::string lower_axis() const;
    [[nodiscard]] std::string left_axis() const;
    /// A bar of a round length, with its right end here.
    [[nodiscard]] std::string scale_bar(double right, double y) const;
    /// What the signs mean: states, lights and walls as far as there are.
    [[nodiscard]] Legend legend(const MachineStates&, double width) const;
    [[nodiscard]] std::string symbols(const MachineStates&) const;
    [[nodiscard]] std::string robot(const Pose&, std::size_t state) const;
    /// Of a robot as it is drawn: at least two dots, so that it is seen.
    [[nodiscard]] double radius() const;
    /// Of the outline of a robot, in radii.
    [[nodiscard]] double outline() const;
    /// Lights and walls as far as there are.
    [[nodiscard]] std::vector<LegendEntry> things() const;
    /// "translate(...) rotate(...)".
    [[nodiscard]] static std::string place(const Pose&);

private:
    const Scenario& scenario_;
    View view_;
    double dot_;
    std::string prefix_;
    bool metres_;  ///< axes are in metres
};

}  // namespace robochart::simulation
