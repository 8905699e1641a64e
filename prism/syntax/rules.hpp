// SPDX-License-Identifier: Apache-2.0
// Declares the diagnostics of the PRISM reader.
#pragma once

#include "base/diagnostics/diagnostic.hpp"

namespace robochart::prism::rules {

using diagnostics::Rule;

#define RULE(name, code, severity, message) inline constexpr Rule name{code, diagnostics::Severity::severity, message};
#include "prism/syntax/rules.def"
#undef RULE

/// All rules of the table, in its order.
inline constexpr const Rule* syntax[] = {
#define RULE(name, code, severity, message) &name,
#include "prism/syntax/rules.def"
#undef RULE
};

}  // namespace robochart::prism::rules
