// A plot of the values of a probabilistic assertion over the constant that varies.
#pragma once

#include <string>

#include "app/report/report.hpp"

namespace robochart::app {

/// SVG: a line, or a band between the least and the greatest values. "" where it is not one constant that varies, or
/// not every row has a number.
[[nodiscard]] std::string value_plot(const ProbabilityReport&);

}  // namespace robochart::app
