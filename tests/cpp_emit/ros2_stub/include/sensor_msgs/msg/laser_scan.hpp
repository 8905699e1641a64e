// SPDX-License-Identifier: Apache-2.0
// The parts of sensor_msgs/msg/LaserScan that generated nodes use, for tests.
#pragma once

#include <vector>

#include "std_msgs/msg/header.hpp"

namespace sensor_msgs::msg {

struct LaserScan {
    std_msgs::msg::Header header{};
    float angle_min{};
    float angle_max{};
    std::vector<float> ranges{};
};

}  // namespace sensor_msgs::msg
