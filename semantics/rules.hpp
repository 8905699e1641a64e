// SPDX-License-Identifier: Apache-2.0
// Lists the rules of this component: constructs that the IR cannot express, and mistakes in an instantiation.
#pragma once

#include "base/diagnostics/diagnostic.hpp"

namespace robochart::ir::rules {

using diagnostics::Rule;

#define RULE(name, code, severity, message) inline constexpr Rule name{code, diagnostics::Severity::severity, message};
#include "semantics/rules.def"
#undef RULE

/// All rules of the table, in its order.
inline constexpr const Rule* all[] = {
#define RULE(name, code, severity, message) &name,
#include "semantics/rules.def"
#undef RULE
};

}  // namespace robochart::ir::rules
