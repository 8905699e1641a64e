// std_msgs/msg/Bool as far as generated nodes use it, for tests.
#pragma once

namespace std_msgs::msg {

struct Bool {
    bool data{};
};

}  // namespace std_msgs::msg
