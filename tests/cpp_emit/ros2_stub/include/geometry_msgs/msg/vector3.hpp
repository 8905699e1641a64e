// geometry_msgs/msg/Vector3 as far as generated nodes use it, for tests.
#pragma once

namespace geometry_msgs::msg {

struct Vector3 {
    double x{};
    double y{};
    double z{};
};

}  // namespace geometry_msgs::msg
