// SPDX-License-Identifier: Apache-2.0
// The parts of std_msgs/msg/Int64 that generated nodes use, for tests.
#pragma once

#include <cstdint>

namespace std_msgs::msg {

struct Int64 {
    std::int64_t data{};
};

}  // namespace std_msgs::msg
