// std_msgs/msg/Float32 as far as generated nodes use it, for tests.
#pragma once

namespace std_msgs::msg {

struct Float32 {
    float data{};
};

}  // namespace std_msgs::msg
