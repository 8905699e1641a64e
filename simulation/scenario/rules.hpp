// SPDX-License-Identifier: Apache-2.0
// Declares the rules about mistakes in scenarios, and the reasons for stopping a simulation.
#pragma once

#include "base/diagnostics/diagnostic.hpp"

namespace robochart::simulation::rules {

using diagnostics::Rule;

#define RULE(name, code, severity, message) inline constexpr Rule name{code, diagnostics::Severity::severity, message};
#include "simulation/scenario/rules.def"
#undef RULE

/// All rules of the table, in its order.
inline constexpr const Rule* all[] = {
#define RULE(name, code, severity, message) &name,
#include "simulation/scenario/rules.def"
#undef RULE
};

}  // namespace robochart::simulation::rules
