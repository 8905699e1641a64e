// SPDX-License-Identifier: Apache-2.0
// Writes a ROS 2 node: the class that sends the controller's outputs as messages, and the lifecycle node that uses it.
#pragma once

#include <string>
#include <vector>

#include "cpp_emit/api/class_api.hpp"
#include "cpp_emit/ros2/node_plan.hpp"

namespace robochart::cpp_emit::ros2 {

[[nodiscard]] std::string messages_header(const Generation&, const Core&, const ClassApi&, const NodePlan&);
[[nodiscard]] std::string node_header(const Generation&, const Core&, const ClassApi&, const NodePlan&);
[[nodiscard]] std::string node_source(const Generation&, const Core&, const ClassApi&, const NodePlan&);
/// Returns the usual length of a control cycle in seconds, such as "0.1".
[[nodiscard]] std::string cycle_seconds(const Options&);
/// Returns a text such as "2 time units of the model (200 ms)".
[[nodiscard]] std::string cycle_text(const Options&);
/// Returns the lines of the parameter file that list these constants.
[[nodiscard]] std::string constant_lines(const Generation&, const Core&);

/// Returns the C++ type of a message: "::geometry_msgs::msg::Twist".
[[nodiscard]] std::string message_type(const MessageName&);
/// Returns the folder of the headers of messages, services or actions: "msg", "srv", "action".
[[nodiscard]] const char* interface_folder(Transport);
/// Returns the C++ type of the message, service or action of a topic: "::std_srvs::srv::Trigger".
[[nodiscard]] std::string interface_type(const Topic&);
/// Returns the C++ type of the data that the node sends on a topic, or to a service or an action.
[[nodiscard]] std::string sent_type(const Topic&);
/// Returns the C++ type of the data that the node receives on a topic, or from a service or an action. Rejections and
/// acceptances carry no data.
[[nodiscard]] std::string received_type(const Topic&, Reply);

}  // namespace robochart::cpp_emit::ros2
