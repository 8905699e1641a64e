// SPDX-License-Identifier: Apache-2.0
// Declares the rules for constructs that RoboTool's encoding in PRISM does not support. Such constructs are rejected by
// name, because a wrong number is worse than no number.
#pragma once

#include "base/diagnostics/diagnostic.hpp"

namespace robochart::prism_emit::rules {

using diagnostics::Rule;

#define RULE(name, code, severity, message) inline constexpr Rule name{code, diagnostics::Severity::severity, message};
#include "prism/emit/rules.def"
#undef RULE

/// All rules of the table, in its order.
inline constexpr const Rule* all[] = {
#define RULE(name, code, severity, message) &name,
#include "prism/emit/rules.def"
#undef RULE
};

}  // namespace robochart::prism_emit::rules
