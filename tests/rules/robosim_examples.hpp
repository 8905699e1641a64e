// SPDX-License-Identifier: Apache-2.0
// Provides examples of RoboSim for rows of rules that no page shows.
#pragma once

#include <vector>

#include "base/rule_pages/rule_pages.hpp"

namespace robochart::testing {

/// Returns the blocks of each example, with the expected findings in comments, as on the pages.
[[nodiscard]] std::vector<std::vector<diagnostics::Block>> robosim_examples();

}  // namespace robochart::testing
