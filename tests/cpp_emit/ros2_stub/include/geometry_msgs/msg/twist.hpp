// SPDX-License-Identifier: Apache-2.0
// The parts of geometry_msgs/msg/Twist that generated nodes use, for tests.
#pragma once

#include "geometry_msgs/msg/vector3.hpp"

namespace geometry_msgs::msg {

struct Twist {
    geometry_msgs::msg::Vector3 linear{};
    geometry_msgs::msg::Vector3 angular{};
};

}  // namespace geometry_msgs::msg
