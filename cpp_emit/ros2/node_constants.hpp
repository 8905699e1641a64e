// SPDX-License-Identifier: Apache-2.0
// Lists the parameters of a node for constants whose values come from options of the generator and not from the model.
#pragma once

#include <string>
#include <vector>

#include "cpp_emit/files/open_constants.hpp"

namespace robochart::cpp_emit::ros2 {

/// A constant without a value in the model. The generated code contains a value, and the node rejects any other value.
struct NodeConstant : OpenConstant {
    std::string parameter;  ///< name of the ROS parameter: "constants.SPEED"
};
[[nodiscard]] std::vector<NodeConstant> node_constants(const Generation&);
/// Returns whether a name in a mapping denotes the constant with this path. The name may be the path, or the last part
/// of the path.
[[nodiscard]] bool names_constant(const std::string& name, const std::string& path);

}  // namespace robochart::cpp_emit::ros2
