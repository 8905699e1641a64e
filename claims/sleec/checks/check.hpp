// SPDX-License-Identifier: Apache-2.0
// Checks the names and types of SLEEC files.
#pragma once

#include <optional>

#include "base/diagnostics/diagnostic.hpp"
#include "claims/sleec/checks/checked.hpp"

namespace robochart::sleec {

/// Resolves names and checks types. Limits become numbers of time units if `unit` is the length of one, and otherwise
/// numbers of seconds. No value, with findings, if there are errors.
[[nodiscard]] std::optional<CheckedRules> check_rules(const RuleFile& file, diagnostics::Diagnostics& diagnostics,
                                                      durations::Unit unit = {});

}  // namespace robochart::sleec
