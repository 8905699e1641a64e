// SPDX-License-Identifier: Apache-2.0
// Emits controllers (semantics 3.9): machines in parallel, each in its own module inside the controller's module.
#pragma once

#include <set>
#include <string>

#include "csp_emit/compose/composition.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::csp_emit {

struct ControllerContext {
    const Project* project = nullptr;
    const ir::Controller* controller = nullptr;
    std::string name;  ///< name of the CSPM module
    std::string path;  ///< qualified CSPM name
    NameManager names;
    const ir::Module* module = nullptr;  ///< the module that contains the controller; null if it is checked alone
    const std::set<std::string>* given = nullptr;  ///< constants that CSP blocks define; null if none
};

[[nodiscard]] ComponentEmission emit_controller(const ControllerContext&, Emitted&);
/// Returns the operations whose calls leave the controller, without duplicates, in order of declaration.
[[nodiscard]] std::vector<ir::OperationSignature> leaving_calls(const ir::System&, const ir::Controller&);

}  // namespace robochart::csp_emit
