// Answers to probabilistic assertions as text and JSON: a value or a truth for each combination of constants.
#pragma once

#include <string>

#include "app/report/report.hpp"
#include "diagnostics/json.hpp"

namespace robochart::app {

/// Lines, each behind `indent`: what it was decided on, then the values; constants that do not vary are left out.
[[nodiscard]] std::string probability_text(const ProbabilityReport&, const std::string& indent);
[[nodiscard]] diagnostics::Json probability_json(const ProbabilityReport&);
/// "0.5"; "least 0.25, greatest 0.5"; "false, for example in the state x=1".
[[nodiscard]] std::string row_text(const probability::Row&);
/// The steps of a row's path, a line for each; "" where it has none.
[[nodiscard]] std::string path_text(const probability::Row&, const std::string& indent);
/// Those constants of a row that take several values.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> varying(const ProbabilityReport&,
                                                                       const probability::Row&);
/// Which model was asked, and how bounds on steps count in it.
[[nodiscard]] std::string reading_of(const ProbabilityReport&);

}  // namespace robochart::app
