// SPDX-License-Identifier: Apache-2.0
// Writes a mapping that the user can start from: `emit cpp --target ros2 --mapping-draft` (docs/ros2.md, "A first
// mapping").
#pragma once

#include <string>

#include "cpp_emit/api/class_api.hpp"

namespace robochart::cpp_emit::ros2 {

/// Returns the text of a mapping with an item for each element of the component. If the types of an element have the
/// shape of a message of the table (messages.hpp), the element gets this message: a record {linear, angular} of {x, y,
/// z} gets geometry_msgs/Twist. Readings with common names get the message of their sensor: a sequence of reals called
/// `scan` gets sensor_msgs/LaserScan. Numbers and truth values get messages of std_msgs. Other elements become
/// comments. The generator accepts the text as the component's mapping.
[[nodiscard]] std::string mapping_draft(const Generation&, const ClassApi&);

}  // namespace robochart::cpp_emit::ros2
