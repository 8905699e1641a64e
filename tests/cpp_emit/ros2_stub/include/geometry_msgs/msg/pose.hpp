// SPDX-License-Identifier: Apache-2.0
// The parts of geometry_msgs/msg/Pose that generated nodes use, for tests.
#pragma once

#include "geometry_msgs/msg/point.hpp"
#include "geometry_msgs/msg/quaternion.hpp"

namespace geometry_msgs::msg {

struct Pose {
    geometry_msgs::msg::Point position{};
    geometry_msgs::msg::Quaternion orientation{};
};

}  // namespace geometry_msgs::msg
