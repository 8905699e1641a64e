// What ROS 2 accepts as names of packages, messages, fields and topics, and how it derives names of files from them.
#pragma once

#include <set>
#include <string>
#include <string_view>

namespace robochart::cpp_emit::ros2 {

/// Why the text is no name of its kind; "" if it is one.
[[nodiscard]] std::string wrong_package(std::string_view name);
[[nodiscard]] std::string wrong_message(std::string_view name);
[[nodiscard]] std::string wrong_field(std::string_view name);
/// `cmd_vel`, `/robot/cmd_vel`, `~/state`; without substitutions.
[[nodiscard]] std::string wrong_topic(std::string_view name);

/// A name of the model as one part of a topic: without doubled underscores or one at the end.
[[nodiscard]] std::string topic_part(std::string_view name);
/// "battery_state" of BatteryState, as in <sensor_msgs/msg/battery_state.hpp>.
[[nodiscard]] std::string header_of_message(std::string_view type);
/// A component's name as the name of a ROS package (REP 144) that is none of those.
[[nodiscard]] std::string package_name(std::string_view component, const std::set<std::string>& others);

}  // namespace robochart::cpp_emit::ros2
