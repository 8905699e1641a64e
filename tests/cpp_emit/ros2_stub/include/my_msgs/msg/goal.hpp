// SPDX-License-Identifier: Apache-2.0
// A user-defined message, for tests.
#pragma once

#include <cstdint>

namespace my_msgs::msg {

struct Goal {
    float x{};
    std::uint8_t kind{};
    std::int32_t count{};
};

}  // namespace my_msgs::msg
