// SPDX-License-Identifier: Apache-2.0
// Declares two groups of rules. The first group is about errors in a log that are detected before the log is compared
// with the model (docs/traces.md). The second group is about models that cannot be run in control cycles, or that only
// some robots can run in control cycles (docs/conformance.md, "Why a model is not schedulable").
#pragma once

#include "base/diagnostics/diagnostic.hpp"

namespace robochart::conformance::rules {

using diagnostics::Rule;

#define RULE(name, code, severity, message) inline constexpr Rule name{code, diagnostics::Severity::severity, message};
#include "conformance/model/rules.def"
#undef RULE

/// All rules of the table, in its order.
inline constexpr const Rule* all[] = {
#define RULE(name, code, severity, message) &name,
#include "conformance/model/rules.def"
#undef RULE
};

}  // namespace robochart::conformance::rules
