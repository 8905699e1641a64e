// std_msgs/msg/UInt8 as far as generated nodes use it, for tests.
#pragma once

#include <cstdint>

namespace std_msgs::msg {

struct UInt8 {
    std::uint8_t data{};
};

}  // namespace std_msgs::msg
