// SPDX-License-Identifier: Apache-2.0
// The parts of my_msgs/msg/Lamp that generated nodes use, for tests.
#pragma once

#include <cstdint>

namespace my_msgs::msg {

struct Lamp {
    std::uint8_t colour{};
    bool on{};
};

}  // namespace my_msgs::msg
