// SPDX-License-Identifier: Apache-2.0
// Draws the world at one time of a trial as pixels, for videos.
#pragma once

#include <vector>

#include "simulation/trial/trial.hpp"

namespace robochart::simulation {

/// The pixels of a frame: three bytes each, with the rows from the top.
struct Raster {
    std::size_t width = 0;
    std::size_t height = 0;
    std::vector<unsigned char> dots;
};
/// Draws a frame. `states` is the number of states of a controller's first machine.
[[nodiscard]] Raster rasterise_frame(const Scenario&, const Frame&, std::size_t states, std::size_t width);

}  // namespace robochart::simulation
