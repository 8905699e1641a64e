// SPDX-License-Identifier: Apache-2.0
// Declares the rules about the settings, and about the files that the settings name.
#pragma once

#include "base/diagnostics/diagnostic.hpp"

namespace robochart::driver::rules {

using diagnostics::Rule;

#define RULE(name, code, severity, message) inline constexpr Rule name{code, diagnostics::Severity::severity, message};
#include "driver/settings/rules.def"
#undef RULE

/// All rules of the table, in its order.
inline constexpr const Rule* all[] = {
#define RULE(name, code, severity, message) &name,
#include "driver/settings/rules.def"
#undef RULE
};

}  // namespace robochart::driver::rules
