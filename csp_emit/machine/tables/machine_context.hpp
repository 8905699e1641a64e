// A machine in the place where it runs: what its emission starts from.
#pragma once

#include <map>
#include <string>

#include "csp_emit/base/names.hpp"
#include "csp_emit/base/project.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::csp_emit {

/// A machine in the place where it runs.
struct MachineContext {
    const Project* project = nullptr;
    const ir::Machine* machine = nullptr;
    std::string name;                                  ///< of the CSPM module
    std::string path;                                  ///< qualified CSPM name, "P::C::stm_ref0"
    std::map<std::string, ir::MachineId> definitions;  ///< operations defined in this context
    NameManager names;                                 ///< everything that parameters and functions must not be called
    /// A clock whose first reset matters: the machine remembers whether it has been, and offers `unset__` where a guard
    /// reads it before that, `reset__` wherever it has been.
    std::string watched = {};
};

}  // namespace robochart::csp_emit
