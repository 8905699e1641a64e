// SPDX-License-Identifier: Apache-2.0
// Joins RoboTool's script and this program's script to one.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "csp_emit/emit.hpp"

namespace robochart::csp_emit::testing {

/// Returns the names that the declarations define.
[[nodiscard]] std::set<std::string> names_of(const std::vector<cspm::DeclPtr>& decls);
/// Returns RoboTool's script followed by this program's components in a separate module `ours__`, with the definitions
/// that they need.
[[nodiscard]] cspm::Script join_scripts(const cspm::Script& theirs, const Emission& ours);

}  // namespace robochart::csp_emit::testing
