// SPDX-License-Identifier: Apache-2.0
// The parts of rcl_interfaces/msg/ParameterDescriptor that generated nodes use, for tests.
#pragma once

#include <string>
#include <vector>

namespace rcl_interfaces::msg {

struct FloatingPointRange {
    double from_value{};
    double to_value{};
    double step{};
};

struct ParameterDescriptor {
    std::string name{};
    std::string description{};
    bool read_only{};
    bool dynamic_typing{};
    std::vector<FloatingPointRange> floating_point_range{};
};

}  // namespace rcl_interfaces::msg
