// Code that fills the fields of a message. Private to this component.
#pragma once

#include <string>

#include "cpp_emit/expressions/code_writer.hpp"
#include "cpp_emit/ros2/node_plan.hpp"

namespace robochart::cpp_emit::ros2 {

/// Writes what fills the message of this name where it cannot fail; the condition that fills the rest and says whether
/// all values fit, "" if nothing is left. `now` is the time of the cycle.
[[nodiscard]] std::string fill_message(CodeWriter&, const Outgoing&, const std::string& message,
                                       const std::string& now);

}  // namespace robochart::cpp_emit::ros2
