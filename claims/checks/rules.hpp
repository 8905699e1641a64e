// SPDX-License-Identifier: Apache-2.0
// Declares the findings about names, values and durations in claims.
#pragma once

#include "base/diagnostics/diagnostic.hpp"

namespace robochart::claims::rules {

using diagnostics::Rule;

#define RULE(name, code, severity, message) inline constexpr Rule name{code, diagnostics::Severity::severity, message};
#include "claims/checks/rules.def"
#undef RULE

/// All rules of the table, in its order.
inline constexpr const Rule* checks[] = {
#define RULE(name, code, severity, message) &name,
#include "claims/checks/rules.def"
#undef RULE
};

}  // namespace robochart::claims::rules
