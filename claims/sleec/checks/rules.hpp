// SPDX-License-Identifier: Apache-2.0
// Declares the diagnostics about names and types of SLEEC rules.
#pragma once

#include "base/diagnostics/diagnostic.hpp"

namespace robochart::sleec::rules {

using diagnostics::Rule;

#define RULE(name, code, severity, message) inline constexpr Rule name{code, diagnostics::Severity::severity, message};
#include "claims/sleec/checks/rules.def"
#undef RULE

/// All rules of the table, in its order.
inline constexpr const Rule* checks[] = {
#define RULE(name, code, severity, message) &name,
#include "claims/sleec/checks/rules.def"
#undef RULE
};

}  // namespace robochart::sleec::rules
