// geometry_msgs/msg/Quaternion as far as generated nodes use it, for tests.
#pragma once

namespace geometry_msgs::msg {

struct Quaternion {
    double x{};
    double y{};
    double z{};
    double w{};
};

}  // namespace geometry_msgs::msg
