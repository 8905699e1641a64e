// SPDX-License-Identifier: Apache-2.0
// Lists the findings about diagrams that RoboTool stores (docs/diagrams.md).
#pragma once

#include "base/diagnostics/diagnostic.hpp"

namespace robochart::diagrams::rules {

using diagnostics::Rule;

#define RULE(name, code, severity, message) inline constexpr Rule name{code, diagnostics::Severity::severity, message};
#include "frontend/diagrams/stored/rules.def"
#undef RULE

/// All rules of the table, in its order.
inline constexpr const Rule* all[] = {
#define RULE(name, code, severity, message) &name,
#include "frontend/diagrams/stored/rules.def"
#undef RULE
};

}  // namespace robochart::diagrams::rules
