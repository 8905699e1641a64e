// Names in CSP blocks that RoboTool has or had and this script has not.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "checker/cspm/syntax/syntax.hpp"
#include "csp_emit/base/component.hpp"

namespace robochart::csp_emit {

/// Reports names in the declarations of a file, such as `P::S::enteredV` or `S_e`, with what is there instead (RC-C15):
/// those of older generators of RoboTool, and those of what is inside a machine in its scripts. `definitions`: what
/// else the script declares.
void check_robotool_names(const Project&, const std::map<std::string, ComponentEmission>& components,
                          const std::vector<cspm::DeclPtr>& definitions, const std::vector<cspm::DeclPtr>& decls);

/// What the carrier of a basic type, such as `nat`, is called in scripts of today; "" for another name.
[[nodiscard]] std::string name_of_carrier(const std::string& name);

}  // namespace robochart::csp_emit
