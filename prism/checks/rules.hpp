// SPDX-License-Identifier: Apache-2.0
// Declares the static rules for PRISM models and properties.
#pragma once

#include "base/diagnostics/diagnostic.hpp"

namespace robochart::prism::rules {

using diagnostics::Rule;

#define RULE(name, code, severity, message) inline constexpr Rule name{code, diagnostics::Severity::severity, message};
#include "prism/checks/rules.def"
#undef RULE

/// All rules of the table, in its order.
inline constexpr const Rule* checks[] = {
#define RULE(name, code, severity, message) &name,
#include "prism/checks/rules.def"
#undef RULE
};

}  // namespace robochart::prism::rules
