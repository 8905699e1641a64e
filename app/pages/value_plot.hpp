// SPDX-License-Identifier: Apache-2.0
// Plots the values of a probabilistic assertion against the constant that varies.
#pragma once

#include <string>

#include "app/report/report.hpp"

namespace robochart::app {

/// An SVG with a line, or with a band between the least and the greatest values. It is "" unless exactly one constant
/// varies and every row has a number.
[[nodiscard]] std::string value_plot(const driver::ProbabilityReport&);

}  // namespace robochart::app
