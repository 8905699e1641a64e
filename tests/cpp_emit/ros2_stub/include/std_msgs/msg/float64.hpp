// std_msgs/msg/Float64 as far as generated nodes use it, for tests.
#pragma once

namespace std_msgs::msg {

struct Float64 {
    double data{};
};

}  // namespace std_msgs::msg
