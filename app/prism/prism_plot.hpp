// SPDX-License-Identifier: Apache-2.0
// Plots the answers of an experiment.
#pragma once

#include <string>

#include "app/report/prism_report.hpp"

namespace robochart::app {

/// Plots numbers against the constant with the most values: one line for each property and each combination of the
/// other constants. "" if no constant has several numeric values, or no property has a numeric answer.
[[nodiscard]] std::string prism_plot(const PrismReport& report);

}  // namespace robochart::app
