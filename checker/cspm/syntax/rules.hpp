// SPDX-License-Identifier: Apache-2.0
// Lists the diagnostics of the CSPM reader.
#pragma once

#include "base/diagnostics/diagnostic.hpp"

namespace robochart::cspm::rules {

using diagnostics::Rule;

#define RULE(name, code, severity, message) inline constexpr Rule name{code, diagnostics::Severity::severity, message};
#include "checker/cspm/syntax/rules.def"
#undef RULE

/// All rules of the table, in its order.
inline constexpr const Rule* all[] = {
#define RULE(name, code, severity, message) &name,
#include "checker/cspm/syntax/rules.def"
#undef RULE
};

}  // namespace robochart::cspm::rules
