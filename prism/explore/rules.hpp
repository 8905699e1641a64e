// SPDX-License-Identifier: Apache-2.0
// Declares the errors that the evaluation of constants, states and rewards of a PRISM model reports.
#pragma once

#include "base/diagnostics/diagnostic.hpp"

namespace robochart::prism::rules {

using diagnostics::Rule;

#define RULE(name, code, severity, message) inline constexpr Rule name{code, diagnostics::Severity::severity, message};
#include "prism/explore/rules.def"
#undef RULE

/// All rules of the table, in its order.
inline constexpr const Rule* explore[] = {
#define RULE(name, code, severity, message) &name,
#include "prism/explore/rules.def"
#undef RULE
};

}  // namespace robochart::prism::rules
