// SPDX-License-Identifier: Apache-2.0
// Rules about constructs that RoboTool's encoding in PRISM does not support. They are rejected with their names,
// because a wrong number is worse than no number.
#pragma once

#include <span>

#include "base/diagnostics/diagnostic.hpp"

namespace robochart::prism_emit::rules {

extern const diagnostics::Rule no_module;               ///< RC-E01
extern const diagnostics::Rule unsupported_construct;   ///< RC-E02
extern const diagnostics::Rule unsupported_type;        ///< RC-E03
extern const diagnostics::Rule unsupported_expression;  ///< RC-E04
extern const diagnostics::Rule unsupported_event;       ///< RC-E05
extern const diagnostics::Rule unsupported_operation;   ///< RC-E06
extern const diagnostics::Rule bad_preferences;         ///< RC-E07
extern const diagnostics::Rule ignored_preferences;     ///< RC-E08

[[nodiscard]] std::span<const diagnostics::Rule* const> all();

}  // namespace robochart::prism_emit::rules
