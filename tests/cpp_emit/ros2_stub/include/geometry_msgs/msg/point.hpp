// geometry_msgs/msg/Point as far as generated nodes use it, for tests.
#pragma once

namespace geometry_msgs::msg {

struct Point {
    double x{};
    double y{};
    double z{};
};

}  // namespace geometry_msgs::msg
