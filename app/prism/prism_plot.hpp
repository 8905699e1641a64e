// The answers of an experiment as a picture.
#pragma once

#include <string>

#include "app/report/prism_report.hpp"

namespace robochart::app {

/// Numbers over the constant that takes most values: a line for each property and each set of the other constants. ""
/// if no constant takes several numbers as values, or no property has a number as answer.
[[nodiscard]] std::string prism_plot(const PrismReport& report);

}  // namespace robochart::app
