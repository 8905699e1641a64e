// A conflict in the words of the rules: which rule, with which clause and line, began when and asks for what.
#pragma once

#include <string>
#include <vector>

#include "diagnostics/source.hpp"
#include "sleec/analysis/conflicts.hpp"
#include "sleec/analysis/properties.hpp"

namespace robochart::sleec {

/// "near, level = 3": the values of the measures that a rule names.
[[nodiscard]] std::string values_text(const CheckedRules& rules, std::size_t rule, const Valuation& values);
/// "asks for Stop up to second 10", of a window that begins at that second.
[[nodiscard]] std::string demand_text(const CheckedRules& rules, const Demand& demand, std::int64_t began);
/// "R begins at second 3 with Go, near: it asks for Stop up to second 5 (rules.sleec:7)".
[[nodiscard]] std::string side_text(const Side& side, const CheckedRules& rules,
                                    const diagnostics::SourceManager& sources);
/// "Go at second 0 with near, load = high": what comes in a history, the first few. Values are shown where the property
/// is about the occurrence, of the measures in its conditions.
[[nodiscard]] std::vector<std::string> history_lines(const std::vector<Happening>& history,
                                                     const CheckedProperty& property, const CheckedRules& rules);
/// At most eight lines.
[[nodiscard]] std::vector<std::string> explain(const Conflict& conflict, const CheckedRules& rules,
                                               const diagnostics::SourceManager& sources);

}  // namespace robochart::sleec
