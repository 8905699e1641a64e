// SPDX-License-Identifier: Apache-2.0
// Lists the findings of the type checker for CSPM.
#pragma once

#include "base/diagnostics/diagnostic.hpp"

namespace robochart::cspm::types::rules {

using diagnostics::Rule;

#define RULE(name, code, severity, message) inline constexpr Rule name{code, diagnostics::Severity::severity, message};
#include "checker/cspm/types/rules.def"
#undef RULE

/// All rules of the table, in its order.
inline constexpr const Rule* all[] = {
#define RULE(name, code, severity, message) &name,
#include "checker/cspm/types/rules.def"
#undef RULE
};

}  // namespace robochart::cspm::types::rules
