// SPDX-License-Identifier: Apache-2.0
// Prints answers to probabilistic assertions as text and JSON: a number or truth value for each combination of
// constants.
#pragma once

#include <string>

#include "app/report/report.hpp"
#include "base/diagnostics/json.hpp"

namespace robochart::app {

/// Returns a line about the model, followed by lines with the values, all indented by `indent`. Constants that do not
/// vary are omitted.
[[nodiscard]] std::string probability_text(const driver::ProbabilityReport&, const std::string& indent);
[[nodiscard]] diagnostics::Json probability_json(const driver::ProbabilityReport&);
/// Returns the row as text: "0.5"; "least 0.25, greatest 0.5"; "false, for example in the state x=1".
[[nodiscard]] std::string row_text(const probability::Row&);
/// Returns the steps of a row's path, one per line; "" if the row has no path.
[[nodiscard]] std::string path_text(const probability::Row&, const std::string& indent);
/// Returns the constants of a row that take several values.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> varying_constants(const driver::ProbabilityReport&,
                                                                                 const probability::Row&);
/// Returns a sentence about the model that was used and the meaning of step bounds in this model.
[[nodiscard]] std::string reading_of(const driver::ProbabilityReport&);

}  // namespace robochart::app
