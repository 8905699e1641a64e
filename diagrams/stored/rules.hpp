// What is said of diagrams that RoboTool keeps (docs/diagrams.md).
#pragma once

#include <span>

#include "diagnostics/diagnostic.hpp"

namespace robochart::diagrams::rules {

extern const diagnostics::Rule unreadable_diagrams;  ///< RC-D01
extern const diagnostics::Rule other_diagram;        ///< RC-D02
extern const diagnostics::Rule incomplete_diagram;   ///< RC-D03

/// Every rule, for `explain` and for the tests.
[[nodiscard]] std::span<const diagnostics::Rule* const> all();

}  // namespace robochart::diagrams::rules
