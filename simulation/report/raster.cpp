// SPDX-License-Identifier: Apache-2.0
#include "simulation/report/raster.hpp"

#include <algorithm>
#include <cstdlib>

#include "simulation/report/drawing.hpp"
#include "simulation/report/world_drawing.hpp"

namespace robochart::simulation {

Raster rasterise_frame(const Scenario& scenario, const Frame& frame, std::size_t states, std::size_t width) {
    const View view = view_of(scenario, {frame});
    const double scale = static_cast<double>(width) / view.width;
    // Video codecs require even sizes.
    const auto height = std::max<std::size_t>(2, static_cast<std::size_t>(view.height * scale) / 2 * 2);
    Raster raster{width, height, std::vector<unsigned char>(3 * width * height, 255)};
    const auto disk = [&](Vector at, double radius, const char* hex) {
        const auto rgb = static_cast<std::uint32_t>(std::strtoul(hex + 1, nullptr, 16));
        const double x = (at.x - view.left) * scale;
        const double y = (-at.y - view.top) * scale;
        const double r = radius * scale;
        const auto row = [](double v, std::size_t most) {
            return static_cast<std::size_t>(std::clamp(v, 0.0, static_cast<double>(most)));
        };
        for (std::size_t j = row(y - r, height); j < row(y + r + 1, height); ++j)
            for (std::size_t i = row(x - r, width); i < row(x + r + 1, width); ++i) {
                const double dx = static_cast<double>(i) + 0.5 - x;
                const double dy = static_cast<double>(j) + 0.5 - y;
                if (dx * dx + dy * dy > r * r) continue;
                for (std::size_t k = 0; k < 3; ++k)
                    raster.dots[3 * (j * width + i) + k] = static_cast<unsigned char>(rgb >> (16 - 8 * k) & 255U);
            }
    };
    for (std::size_t light = 0; light < scenario.lights.size(); ++light) {
        const LightNow now = light_at(scenario, frame, light);
        if (now.on) disk(now.at, 6, "#f5c400");
    }
    for (std::size_t r = 0; r < frame.poses.size(); ++r)
        disk(frame.poses[r].at, scenario.world.body.radius, state_colour(frame.robot_state(r), states));
    return raster;
}

}  // namespace robochart::simulation
