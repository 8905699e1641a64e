// The constants of a machine and those of the places in which controllers run it.
#pragma once

#include <map>
#include <string>

#include "semantics/ir/ir.hpp"

namespace robochart::ir {

/// Of each constant of a part of a controller that nobody provides (`const_P_C_ref_c`) the machine's own
/// (`const_P_S_c`), whose value it has where nobody gives it one of its own: RoboTool binds the two in every claim
/// about a controller or a module.
[[nodiscard]] std::map<std::string, std::string> own_constants(const System&);

}  // namespace robochart::ir
