// rcl_interfaces/msg/ParameterDescriptor as far as generated nodes use it, for tests.
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
    std::vector<FloatingPointRange> floating_point_range{};
};

}  // namespace rcl_interfaces::msg
