// SPDX-License-Identifier: Apache-2.0
// Lists the fields of common ROS 2 messages (the packages common_interfaces, builtin_interfaces, ackermann_msgs), so
// that errors in a mapping are found before code is generated.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cpp_emit/ros2/mapping.hpp"

namespace robochart::cpp_emit::ros2 {

enum class FieldKind {
    truth,    ///< bool
    whole,    ///< int8 ... uint64, byte, char
    real,     ///< float32, float64
    text,     ///< string
    time,     ///< builtin_interfaces/Time
    message,  ///< another message, whose fields are assigned one by one
    several,  ///< an array
    unknown,  ///< belongs to a message that is not in the table
};

struct FieldType {
    FieldKind kind = FieldKind::unknown;
    std::string_view written;  ///< "float32", "geometry_msgs/Vector3"; "" if unknown
};

/// Returns whether the message is in the table.
[[nodiscard]] bool is_known(const MessageName&);
/// Returns the messages of this package in the table.
[[nodiscard]] std::vector<std::string> known_messages(std::string_view package);
/// Returns the names of the fields of a message in the table. `message` is a name such as "geometry_msgs/Vector3".
[[nodiscard]] std::vector<std::string> fields_of(std::string_view message);

/// A field that is not itself a message, with its path: "linear.x".
struct Leaf {
    std::string path;
    FieldType type;
};
/// Returns the messages in the table, such as "geometry_msgs/Vector3", without those of services and actions.
[[nodiscard]] std::vector<std::string> known_messages();
/// Returns the leaves of a message in the table, except those of its header. Recursion depth: the depth of messages.
[[nodiscard]] std::vector<Leaf> leaves_of(std::string_view message);

/// The field at the end of a path. Fields of a message that is not in the table are unknown.
struct FoundField {
    FieldType type;
    std::size_t missing = 0;  ///< index of the first word that names no field, or the path's length
    std::string_view in;      ///< the message that lacks this field
};
[[nodiscard]] FoundField find_field(const MessageName&, const Path&);

/// Returns the type of the items of an array.
[[nodiscard]] FieldType item_type(const FieldType&);

/// Describes a field type for messages to the user: "whole numbers (uint8)".
[[nodiscard]] std::string describe_field(const FieldType&);
/// Returns whether a whole number is a value of the type. For example, "300" is not a value of uint8.
[[nodiscard]] bool holds_number(const FieldType&, const std::string& whole);

}  // namespace robochart::cpp_emit::ros2
