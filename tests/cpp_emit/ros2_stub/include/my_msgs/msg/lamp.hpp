// my_msgs/msg/Lamp as far as generated nodes use it, for tests.
#pragma once

#include <cstdint>

namespace my_msgs::msg {

struct Lamp {
    std::uint8_t colour{};
    bool on{};
};

}  // namespace my_msgs::msg
