// SPDX-License-Identifier: Apache-2.0
// Plots numeric answers against a constant that varies.
#pragma once

#include <string>

#include "app/report/prism_report.hpp"
#include "app/report/report.hpp"

namespace robochart::app {

/// Plots numbers against the constant with the most values, as SVG. The plot has one line for each property and each
/// combination of the other constants. Returns "" if no constant has several numeric values, or if no property has a
/// numeric answer.
[[nodiscard]] std::string value_plot(const PrismReport& report);
/// Returns the same plot for a probabilistic assertion. If all schedulers are considered, it has lines for the least
/// and the greatest value.
[[nodiscard]] std::string value_plot(const std::string& title, const driver::ProbabilityReport& report);

}  // namespace robochart::app
