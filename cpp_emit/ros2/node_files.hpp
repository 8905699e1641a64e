// The text of a node of ROS 2: the class that keeps messages until the end of a cycle, and the lifecycle node around
// it.
#pragma once

#include <string>
#include <vector>

#include "cpp_emit/api/class_api.hpp"
#include "cpp_emit/ros2/node_plan.hpp"

namespace robochart::cpp_emit::ros2 {

/// A constant whose value the model leaves open: it has one in the generated code, and the node refuses another.
struct NodeConstant {
    std::string parameter;  ///< of ROS: "constants.SPEED"
    std::string path;       ///< in the model: "M::C::S::SPEED"
    ir::TypeId type;
    ir::Value value;
};
[[nodiscard]] std::vector<NodeConstant> node_constants(const Generation&);

[[nodiscard]] std::string messages_header(const Generation&, const Core&, const ClassApi&, const NodePlan&);
[[nodiscard]] std::string node_header(const Generation&, const Core&, const ClassApi&, const NodePlan&);
[[nodiscard]] std::string node_source(const Generation&, const Core&, const ClassApi&, const NodePlan&);
/// The lines of the parameter file that say which constants there are.
[[nodiscard]] std::string constant_lines(const Generation&, const Core&);

/// "::geometry_msgs::msg::Twist".
[[nodiscard]] std::string message_type(const MessageName&);

}  // namespace robochart::cpp_emit::ros2
