// std_msgs/msg/Float64MultiArray as far as generated nodes use it, for tests.
#pragma once

#include <vector>

namespace std_msgs::msg {

struct Float64MultiArray {
    std::vector<double> data{};
};

}  // namespace std_msgs::msg
