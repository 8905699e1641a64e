// SPDX-License-Identifier: Apache-2.0
// Errors in a mapping to ROS 2 messages (docs/ros2.md).
#pragma once

#include <span>

#include "base/diagnostics/diagnostic.hpp"

namespace robochart::cpp_emit::ros2::rules {

extern const diagnostics::Rule syntax;         ///< RC-R01
extern const diagnostics::Rule unknown_name;   ///< RC-R02
extern const diagnostics::Rule said_twice;     ///< RC-R03
extern const diagnostics::Rule wrong_name;     ///< RC-R04
extern const diagnostics::Rule unknown_field;  ///< RC-R05
extern const diagnostics::Rule wrong_type;     ///< RC-R06
extern const diagnostics::Rule incomplete;     ///< RC-R07
extern const diagnostics::Rule not_sent;       ///< RC-R08
extern const diagnostics::Rule shared_topic;   ///< RC-R09
extern const diagnostics::Rule not_mapped;     ///< RC-R10
extern const diagnostics::Rule not_checked;    ///< RC-R11
extern const diagnostics::Rule not_asked;      ///< RC-R12

/// Every rule, for `explain` and for the tests.
[[nodiscard]] std::span<const diagnostics::Rule* const> all();

}  // namespace robochart::cpp_emit::ros2::rules
