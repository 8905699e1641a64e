// SPDX-License-Identifier: Apache-2.0
// Declares the rules for constructs that the C++ generator rejects by name. A rejected component gets no code rather
// than wrong code.
#pragma once

#include "base/diagnostics/diagnostic.hpp"

namespace robochart::cpp_emit::rules {

using diagnostics::Rule;

#define RULE(name, code, severity, message) inline constexpr Rule name{code, diagnostics::Severity::severity, message};
#include "cpp_emit/plan/rules.def"
#undef RULE

/// All rules of the table, in its order.
inline constexpr const Rule* all[] = {
#define RULE(name, code, severity, message) &name,
#include "cpp_emit/plan/rules.def"
#undef RULE
};

}  // namespace robochart::cpp_emit::rules
