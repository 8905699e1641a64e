// A time of a trial in dots, for films.
#pragma once

#include <vector>

#include "simulation/trial/trial.hpp"

namespace robochart::simulation {

/// A frame in dots: three bytes each, rows from the top.
struct Raster {
    std::size_t width = 0;
    std::size_t height = 0;
    std::vector<unsigned char> dots;
};
/// `states`: how many the first machine of a controller has.
[[nodiscard]] Raster rasterise(const Scenario&, const Frame&, std::size_t states, std::size_t width);

}  // namespace robochart::simulation
