// SPDX-License-Identifier: Apache-2.0
// Checks the names and types of SLEEC files.
#pragma once

#include <optional>

#include "base/diagnostics/diagnostic.hpp"
#include "claims/sleec/checks/checked.hpp"

namespace robochart::sleec {

/// Resolves names and checks types. Limits become numbers of time units if `unit` is the length of a time unit, and
/// otherwise numbers of seconds. If there are errors, adds findings and returns no value.
[[nodiscard]] std::optional<CheckedRules> check_rules(const RuleFile& file, diagnostics::Diagnostics& diagnostics,
                                                      durations::Unit unit = {});

}  // namespace robochart::sleec
