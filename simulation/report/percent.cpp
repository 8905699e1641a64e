// SPDX-License-Identifier: Apache-2.0
// See percent.hpp.
#include "simulation/report/percent.hpp"

#include <fmt/format.h>

#include <cmath>

namespace robochart::simulation {

std::string percent_text(double probability) {
    return fmt::format("{:.6g} %", 100 * probability + 0.0);  // -0 becomes 0
}

std::string percent_below(double probability) {
    return fmt::format("{:.6g} %", std::floor(probability * 1e5) / 1e3);
}

std::string percent_above(double probability) {
    return fmt::format("{:.6g} %", std::ceil(probability * 1e5) / 1e3);
}

}  // namespace robochart::simulation
