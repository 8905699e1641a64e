// SPDX-License-Identifier: Apache-2.0
// The parts of geometry_msgs/msg/PoseStamped that generated nodes use, for tests.
#pragma once

#include "geometry_msgs/msg/pose.hpp"
#include "std_msgs/msg/header.hpp"

namespace geometry_msgs::msg {

struct PoseStamped {
    std_msgs::msg::Header header{};
    geometry_msgs::msg::Pose pose{};
};

}  // namespace geometry_msgs::msg
