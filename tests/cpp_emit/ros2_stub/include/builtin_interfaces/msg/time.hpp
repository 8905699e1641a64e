// SPDX-License-Identifier: Apache-2.0
// The parts of builtin_interfaces/msg/Time that generated nodes use, for tests.
#pragma once

#include <cstdint>

namespace builtin_interfaces::msg {

struct Time {
    std::int32_t sec{};
    std::uint32_t nanosec{};
};

}  // namespace builtin_interfaces::msg
