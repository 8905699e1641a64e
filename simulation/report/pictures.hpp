// SPDX-License-Identifier: Apache-2.0
// Writes pictures and tables of a trial as text: SVG, which browsers show without a library, and CSV for other tools.
#pragma once

#include <string>
#include <vector>

#include "simulation/report/world_drawing.hpp"
#include "simulation/trial/controller.hpp"
#include "simulation/trial/trial.hpp"

namespace robochart::simulation {

/// Returns the frame nearest to a time.
[[nodiscard]] const Frame& frame_at(const std::vector<Frame>&, double time);

/// Draws the trial at the scenario's picture times, side by side, as in the founding paper's figures.
[[nodiscard]] std::string snapshots_svg(const Scenario&, const std::vector<Frame>&, const Machines&);
/// Draws every robot's path, faint at the start and strong at the end, and the final positions.
[[nodiscard]] std::string trajectories_svg(const Scenario&, const std::vector<Frame>&);
/// Draws the trial as an animation (SMIL), `speed` times as fast as real time. For readers who prefer reduced motion,
/// it shows the end.
[[nodiscard]] std::string animation_svg(const Scenario&, const std::vector<Frame>&, const Machines&, double speed);

/// Returns the drawing of the world for an HTML page.
[[nodiscard]] WorldDrawing page_world(const Scenario&, const View&, const std::string& prefix);
/// Draws the last frame of a trial for an HTML page. A script of the page moves the robots. Each robot is a `use`
/// element of its state's symbol, with the class `sim-robot` and the attribute `data-robot`. Ids begin with `prefix`.
/// The page must contain the style rules.
[[nodiscard]] std::string world_svg(const Scenario&, const View&, const Frame& last, const Machines&,
                                    const std::string& prefix);

/// Writes a table `t,id,x,y,theta,state` with a header line, in seconds, centimetres and radians. If there are several
/// machines, each has a column whose name is `state:` followed by the machine's name.
[[nodiscard]] std::string positions_csv(const std::vector<Frame>&, const Machines&);

}  // namespace robochart::simulation
