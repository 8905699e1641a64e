// geometry_msgs/msg/PoseStamped as far as generated nodes use it, for tests.
#pragma once

#include "geometry_msgs/msg/pose.hpp"
#include "std_msgs/msg/header.hpp"

namespace geometry_msgs::msg {

struct PoseStamped {
    std_msgs::msg::Header header{};
    geometry_msgs::msg::Pose pose{};
};

}  // namespace geometry_msgs::msg
