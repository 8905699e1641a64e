// Pictures and tables of a trial, as text: SVG needs no library and is shown by browsers. CSV for other tools.
#pragma once

#include <string>
#include <vector>

#include "simulation/trial/trial.hpp"

namespace robochart::simulation {

/// The frame nearest to a time.
[[nodiscard]] const Frame& frame_at(const std::vector<Frame>&, double time);

/// The trial at the scenario's picture times side by side, as in the founding paper's figures.
[[nodiscard]] std::string snapshots_svg(const Scenario&, const std::vector<Frame>&);
/// Every robot's path, pale at the start and dark at the end, and where the robots came to.
[[nodiscard]] std::string trajectories_svg(const Scenario&, const std::vector<Frame>&);
/// The trial as an animation (SMIL), `speed` times as fast as in the world; robots are coloured by the state of their
/// controller.
[[nodiscard]] std::string animation_svg(const Scenario&, const std::vector<Frame>&,
                                        const std::vector<std::string>& states, double speed);
/// `t,id,x,y,theta,state` with a head line; seconds, centimetres, radians.
[[nodiscard]] std::string positions_csv(const std::vector<Frame>&, const std::vector<std::string>& states);

/// A frame in dots: three bytes each, rows from the top.
struct Raster {
    std::size_t width = 0;
    std::size_t height = 0;
    std::vector<unsigned char> dots;
};
[[nodiscard]] Raster rasterise(const Scenario&, const Frame&, std::size_t width);

}  // namespace robochart::simulation
