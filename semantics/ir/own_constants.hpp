// SPDX-License-Identifier: Apache-2.0
// Relates the constants of a machine to the constants of the controllers that run this machine.
#pragma once

#include <map>
#include <string>

#include "semantics/ir/ir.hpp"

namespace robochart::ir {

/// Maps each constant that a machine has in a controller and that nothing provides (`const_P_C_ref_c`) to the machine's
/// own constant (`const_P_S_c`). The controller's constant has the value of the machine's constant, unless an option
/// gives it another value. The reason is that RoboTool binds both constants in every assertion about a controller or a
/// module.
[[nodiscard]] std::map<std::string, std::string> own_constants(const System&);

}  // namespace robochart::ir
