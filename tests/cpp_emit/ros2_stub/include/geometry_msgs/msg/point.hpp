// SPDX-License-Identifier: Apache-2.0
// The parts of geometry_msgs/msg/Point that generated nodes use, for tests.
#pragma once

namespace geometry_msgs::msg {

struct Point {
    double x{};
    double y{};
    double z{};
};

}  // namespace geometry_msgs::msg
