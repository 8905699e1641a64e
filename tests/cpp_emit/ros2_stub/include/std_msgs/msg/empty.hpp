// std_msgs/msg/Empty as far as generated nodes use it, for tests.
#pragma once

namespace std_msgs::msg {

struct Empty {};

}  // namespace std_msgs::msg
