// SPDX-License-Identifier: Apache-2.0
// The parts of sensor_msgs/msg/Range that generated nodes use, for tests.
#pragma once

#include <cstdint>

#include "std_msgs/msg/header.hpp"

namespace sensor_msgs::msg {

struct Range {
    std_msgs::msg::Header header{};
    std::uint8_t radiation_type{};
    float field_of_view{};
    float min_range{};
    float max_range{};
    float range{};
};

}  // namespace sensor_msgs::msg
