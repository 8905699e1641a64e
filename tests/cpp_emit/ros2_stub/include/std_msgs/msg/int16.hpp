// std_msgs/msg/Int16 as far as generated nodes use it, for tests.
#pragma once

#include <cstdint>

namespace std_msgs::msg {

struct Int16 {
    std::int16_t data{};
};

}  // namespace std_msgs::msg
