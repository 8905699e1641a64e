// SPDX-License-Identifier: Apache-2.0
// The parts of std_msgs/msg/UInt8 that generated nodes use, for tests.
#pragma once

#include <cstdint>

namespace std_msgs::msg {

struct UInt8 {
    std::uint8_t data{};
};

}  // namespace std_msgs::msg
