// The machines inside a component, in the places where they run.
#pragma once

#include <string>
#include <vector>

#include "semantics/ir/ir.hpp"

namespace robochart::probability {

struct Seat {
    const ir::Module* module = nullptr;          ///< null: not in a module
    const ir::Controller* controller = nullptr;  ///< null: the machine is looked at on its own
    std::string part;                            ///< its name in the controller
    const ir::Machine* machine = nullptr;
    std::string path;       ///< in properties: "Module::controller_ref::machine_ref"
    std::string component;  ///< in the CSP semantics: the same behind the package
};

/// Of a module, a controller or a machine.
[[nodiscard]] std::vector<Seat> seats_in(const ir::System&, const ir::ComponentRef&);

}  // namespace robochart::probability
