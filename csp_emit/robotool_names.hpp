// SPDX-License-Identifier: Apache-2.0
// Finds names in CSP blocks that scripts of some version of RoboTool declare, but that this script does not declare.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "checker/cspm/syntax/syntax.hpp"
#include "csp_emit/base/component.hpp"

namespace robochart::csp_emit {

/// Reports names in the declarations of a file, such as `P::S::enteredV` or `S_e`, with their replacements (RC-C15).
/// These are names of older generators of RoboTool, and names inside a machine in RoboTool's scripts. `definitions`
/// contains the other declarations of the script.
void check_robotool_names(const Project&, const std::map<std::string, ComponentEmission>& components,
                          const std::vector<cspm::DeclPtr>& definitions, const std::vector<cspm::DeclPtr>& decls);

/// Returns the current name for the carrier of a basic type such as `nat`, or "" for other names.
[[nodiscard]] std::string name_of_carrier(const std::string& name);

}  // namespace robochart::csp_emit
