// SPDX-License-Identifier: Apache-2.0
// Lists the rules of this component: constructs without a CSP semantics, and errors in CSP blocks.
#pragma once

#include "base/diagnostics/diagnostic.hpp"

namespace robochart::csp_emit::rules {

using diagnostics::Rule;

#define RULE(name, code, severity, message) inline constexpr Rule name{code, diagnostics::Severity::severity, message};
#include "csp_emit/base/rules.def"
#undef RULE

/// All rules of the table, in its order.
inline constexpr const Rule* all[] = {
#define RULE(name, code, severity, message) &name,
#include "csp_emit/base/rules.def"
#undef RULE
};

}  // namespace robochart::csp_emit::rules
