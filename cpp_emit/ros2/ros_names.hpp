// SPDX-License-Identifier: Apache-2.0
// Checks names of packages, messages, fields and topics in ROS 2, and derives file names from them as ROS 2 does.
#pragma once

#include <set>
#include <string>
#include <string_view>

namespace robochart::cpp_emit::ros2 {

/// These functions return the reason why the text is not a valid name of its kind; "" if it is valid.
[[nodiscard]] std::string wrong_package(std::string_view name);
[[nodiscard]] std::string wrong_message(std::string_view name);
[[nodiscard]] std::string wrong_field(std::string_view name);
[[nodiscard]] std::string wrong_parameter(std::string_view name);
/// Accepts topics such as `cmd_vel`, `/robot/cmd_vel`, `~/state`, without substitutions.
[[nodiscard]] std::string wrong_topic(std::string_view name);

/// The style of names of nodes, topics and files.
enum class NameStyle {
    snake,  ///< small letters and underscores, as in ROS: "call_help"
    model,  ///< as in the model: "callHelp"
};

/// Returns a name of the model as one part of a topic, without doubled or trailing underscores.
[[nodiscard]] std::string topic_part(std::string_view name, NameStyle);
/// Returns the name of a message's header: "battery_state" for BatteryState, as in <sensor_msgs/msg/battery_state.hpp>.
[[nodiscard]] std::string header_of_message(std::string_view type);
/// Returns the name of a ROS package for a component (REP 144), which differs from those in `others`.
[[nodiscard]] std::string package_name(std::string_view component, const std::set<std::string>& others);

}  // namespace robochart::cpp_emit::ros2
