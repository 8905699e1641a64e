// SPDX-License-Identifier: Apache-2.0
// The parts of geometry_msgs/msg/Quaternion that generated nodes use, for tests.
#pragma once

namespace geometry_msgs::msg {

struct Quaternion {
    double x{};
    double y{};
    double z{};
    double w{};
};

}  // namespace geometry_msgs::msg
