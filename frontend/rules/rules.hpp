// SPDX-License-Identifier: Apache-2.0
// Lists the rules about the resolved model: names, well-formedness and types (language reference 2). Rules that are
// published have their published codes; the codes of this project begin with RC-. Two rows may share a code if they
// report the same rule in different circumstances.
#pragma once

#include "base/diagnostics/diagnostic.hpp"

namespace robochart::frontend::rules {

using diagnostics::Rule;

#define RULE(name, code, severity, message) inline constexpr Rule name{code, diagnostics::Severity::severity, message};
#include "frontend/rules/rules.def"
#undef RULE

/// All rules of the table, in its order.
inline constexpr const Rule* all[] = {
#define RULE(name, code, severity, message) &name,
#include "frontend/rules/rules.def"
#undef RULE
};

}  // namespace robochart::frontend::rules
