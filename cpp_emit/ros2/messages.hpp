// The fields of common ROS 2 messages (the packages common_interfaces, builtin_interfaces, ackermann_msgs), so that
// mistakes in a mapping are found where it is written.
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
    message,  ///< another message: its fields are given one by one
    several,  ///< an array
    unknown,  ///< of a message that is not in the table
};

struct FieldType {
    FieldKind kind = FieldKind::unknown;
    std::string_view written;  ///< "float32", "geometry_msgs/Vector3", "" if it is not known
};

/// The message is in the table.
[[nodiscard]] bool known(const MessageName&);
/// Messages of its package in the table.
[[nodiscard]] std::vector<std::string> known_messages(std::string_view package);
/// Names of the fields of a message in the table; "geometry_msgs/Vector3".
[[nodiscard]] std::vector<std::string> fields_of(std::string_view message);

/// What a path of fields leads to; from a message that is not in the table on, all is unknown.
struct FoundField {
    FieldType type;
    std::size_t missing = 0;  ///< the first word that names no field; the path's length if all do
    std::string_view in;      ///< the message that should have it
};
[[nodiscard]] FoundField find_field(const MessageName&, const Path&);

/// "whole numbers (uint8)" for messages to people.
[[nodiscard]] std::string described(const FieldType&);
/// Whether a whole number is a value of the type: "300" is none of uint8.
[[nodiscard]] bool holds(const FieldType&, const std::string& whole);

}  // namespace robochart::cpp_emit::ros2
