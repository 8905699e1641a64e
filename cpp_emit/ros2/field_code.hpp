// SPDX-License-Identifier: Apache-2.0
// Writes code that fills the fields of a message. Private to this component.
#pragma once

#include <string>

#include "cpp_emit/expressions/code_writer.hpp"
#include "cpp_emit/ros2/node_plan.hpp"

namespace robochart::cpp_emit::ros2 {

/// Writes code that fills those fields of `message` that can always be filled. Returns a condition that fills the other
/// fields and is true if all values fit; "" if there are none. `now` is the time of the cycle.
[[nodiscard]] std::string fill_message(CodeWriter&, const Outgoing&, const std::string& message,
                                       const std::string& now);

}  // namespace robochart::cpp_emit::ros2
