// SPDX-License-Identifier: Apache-2.0
// Describes a conflict in terms of the rules. For each rule it states the clause with its line, the time of its
// trigger, and its demand.
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics/source.hpp"
#include "claims/sleec/analysis/conflicts.hpp"
#include "claims/sleec/analysis/properties.hpp"

namespace robochart::sleec {

/// Returns the values of the measures in a rule: "near, level = 3".
[[nodiscard]] std::string values_text(const CheckedRules& rules, std::size_t rule, const Valuation& values);
/// Returns "asks for Stop up to second 10". The window of the demand is counted from the second `began`.
[[nodiscard]] std::string demand_text(const CheckedRules& rules, const Demand& demand, std::int64_t began);
/// Returns "R begins at second 3 with Go, near: it asks for Stop up to second 5 (rules.sleec:7)".
[[nodiscard]] std::string side_text(const Side& side, const CheckedRules& rules,
                                    const diagnostics::SourceManager& sources);
/// Describes the first events of a history: "Go at second 0 with near, load = high". The values of the measures in the
/// property's conditions are added to an occurrence of the property.
[[nodiscard]] std::vector<std::string> history_lines(const std::vector<Happening>& history,
                                                     const CheckedProperty& property, const CheckedRules& rules);
/// Explains a conflict in at most eight lines.
[[nodiscard]] std::vector<std::string> explain_conflict(const Conflict& conflict, const CheckedRules& rules,
                                                        const diagnostics::SourceManager& sources);

}  // namespace robochart::sleec
