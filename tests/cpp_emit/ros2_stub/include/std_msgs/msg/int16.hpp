// SPDX-License-Identifier: Apache-2.0
// The parts of std_msgs/msg/Int16 that generated nodes use, for tests.
#pragma once

#include <cstdint>

namespace std_msgs::msg {

struct Int16 {
    std::int16_t data{};
};

}  // namespace std_msgs::msg
