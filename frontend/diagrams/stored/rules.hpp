// SPDX-License-Identifier: Apache-2.0
// Findings about diagrams that RoboTool stores (docs/diagrams.md).
#pragma once

#include <span>

#include "base/diagnostics/diagnostic.hpp"

namespace robochart::diagrams::rules {

extern const diagnostics::Rule unreadable_diagrams;  ///< RC-D01
extern const diagnostics::Rule other_diagram;        ///< RC-D02
extern const diagnostics::Rule incomplete_diagram;   ///< RC-D03

/// All rules, for `explain` and for tests.
[[nodiscard]] std::span<const diagnostics::Rule* const> rule_list();

}  // namespace robochart::diagrams::rules
