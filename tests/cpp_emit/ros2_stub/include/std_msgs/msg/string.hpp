// std_msgs/msg/String as far as generated nodes use it, for tests.
#pragma once

#include <string>

namespace std_msgs::msg {

struct String {
    std::string data{};
};

}  // namespace std_msgs::msg
