// SPDX-License-Identifier: Apache-2.0
// Lists the machines of a component, each with the context in which it runs.
#pragma once

#include <string>
#include <vector>

#include "semantics/ir/ir.hpp"

namespace robochart::probability {

struct Seat {
    const ir::Module* module = nullptr;          ///< null if the machine is not in a module
    const ir::Controller* controller = nullptr;  ///< null if the machine is checked without a controller
    std::string part;                            ///< the name of the machine in the controller
    const ir::Machine* machine = nullptr;
    std::string path;       ///< the path in properties: "Module::controller_ref::machine_ref"
    std::string component;  ///< the name in the CSP semantics: the package and the path
};

/// Returns the machines of a module or controller, or the single machine.
[[nodiscard]] std::vector<Seat> seats_in(const ir::System&, const ir::ComponentRef&);

}  // namespace robochart::probability
