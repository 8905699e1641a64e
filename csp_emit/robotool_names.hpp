// Names in CSP blocks that RoboTool has or had and this script has not.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "checker/cspm/syntax/syntax.hpp"
#include "csp_emit/base/component.hpp"

namespace robochart::csp_emit {

/// Reports names of components of the model, such as `P::S::enteredV`, with what is there instead (RC-C15): those of
/// older generators of RoboTool, and those of what is inside a machine in its scripts.
void check_robotool_names(const Project&, const std::map<std::string, ComponentEmission>& components,
                          const std::vector<cspm::DeclPtr>& decls);

}  // namespace robochart::csp_emit
