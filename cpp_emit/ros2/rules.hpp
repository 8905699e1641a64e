// SPDX-License-Identifier: Apache-2.0
// Declares the rules about errors in a mapping to ROS 2 messages (docs/ros2.md).
#pragma once

#include "base/diagnostics/diagnostic.hpp"

namespace robochart::cpp_emit::ros2::rules {

using diagnostics::Rule;

#define RULE(name, code, severity, message) inline constexpr Rule name{code, diagnostics::Severity::severity, message};
#include "cpp_emit/ros2/rules.def"
#undef RULE

/// All rules of the table, in its order.
inline constexpr const Rule* all[] = {
#define RULE(name, code, severity, message) &name,
#include "cpp_emit/ros2/rules.def"
#undef RULE
};

}  // namespace robochart::cpp_emit::ros2::rules
