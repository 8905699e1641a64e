// SPDX-License-Identifier: Apache-2.0
// nav2_msgs/action/NavigateToPose, for tests.
#pragma once

#include <cstdint>
#include <string>

#include "geometry_msgs/msg/pose_stamped.hpp"

namespace nav2_msgs::action {

struct NavigateToPose {
    struct Goal {
        geometry_msgs::msg::PoseStamped pose{};
        std::string behavior_tree{};
    };
    struct Result {
        std::uint16_t error_code{};
    };
    struct Feedback {
        geometry_msgs::msg::PoseStamped current_pose{};
        std::int16_t number_of_recoveries{};
        float distance_remaining{};
    };
};

}  // namespace nav2_msgs::action
