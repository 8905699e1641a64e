// std_msgs/msg/Empty, for tests.
#pragma once

namespace std_msgs::msg {

struct Empty {};

}  // namespace std_msgs::msg
