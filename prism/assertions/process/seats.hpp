// SPDX-License-Identifier: Apache-2.0
// The machines inside a component, in the contexts in which they run.
#pragma once

#include <string>
#include <vector>

#include "semantics/ir/ir.hpp"

namespace robochart::probability {

struct Seat {
    const ir::Module* module = nullptr;          ///< null: not in a module
    const ir::Controller* controller = nullptr;  ///< null: the machine by itself
    std::string part;                            ///< the name of the machine in the controller
    const ir::Machine* machine = nullptr;
    std::string path;       ///< the path in properties: "Module::controller_ref::machine_ref"
    std::string component;  ///< the name in the CSP semantics: the package and the path
};

/// The machines of a module or controller, or a single machine.
[[nodiscard]] std::vector<Seat> seats_in(const ir::System&, const ir::ComponentRef&);

}  // namespace robochart::probability
