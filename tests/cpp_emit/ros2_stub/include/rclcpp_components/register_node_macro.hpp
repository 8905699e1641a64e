// SPDX-License-Identifier: Apache-2.0
// The registration of a component, for tests. It checks that the class meets the requirements of the real macro.
#pragma once

#include <type_traits>

#include "rclcpp/rclcpp.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"

#define RCLCPP_COMPONENTS_REGISTER_NODE(...)                                                                 \
    static_assert(std::is_base_of_v<rclcpp_lifecycle::LifecycleNode, __VA_ARGS__>, "a component is a node"); \
    static_assert(std::is_constructible_v<__VA_ARGS__, const rclcpp::NodeOptions&>, "from options");
