// SPDX-License-Identifier: Apache-2.0
// Answers to probabilistic assertions as text and JSON: a value or truth value for each combination of constants.
#pragma once

#include <string>

#include "app/report/report.hpp"
#include "base/diagnostics/json.hpp"

namespace robochart::app {

/// Lines indented by `indent`: the model, then the values; constants that do not vary are omitted.
[[nodiscard]] std::string probability_text(const driver::ProbabilityReport&, const std::string& indent);
[[nodiscard]] diagnostics::Json probability_json(const driver::ProbabilityReport&);
/// "0.5"; "least 0.25, greatest 0.5"; "false, for example in the state x=1".
[[nodiscard]] std::string row_text(const probability::Row&);
/// The steps of a row's path, one per line; "" if it has none.
[[nodiscard]] std::string path_text(const probability::Row&, const std::string& indent);
/// The constants of a row that take several values.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> varying_constants(const driver::ProbabilityReport&,
                                                                                 const probability::Row&);
/// The model that was used, and how bounds on steps are counted in it.
[[nodiscard]] std::string reading_of(const driver::ProbabilityReport&);

}  // namespace robochart::app
