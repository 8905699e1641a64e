// Controllers (semantics 3.9): machines side by side, each in a module of its own inside the controller's.
#pragma once

#include <set>
#include <string>

#include "csp_emit/compose/composition.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::csp_emit {

struct ControllerContext {
    const Project* project = nullptr;
    const ir::Controller* controller = nullptr;
    std::string name;  ///< of the CSPM module
    std::string path;  ///< qualified CSPM name
    NameManager names;
    const ir::Module* module = nullptr;  ///< the module that the controller runs in; null: it is checked alone
    const std::set<std::string>* given = nullptr;  ///< constants that count by blocks; null: none
};

[[nodiscard]] ComponentEmission emit_controller(const ControllerContext&, Emitted&);
/// Operations whose calls leave the controller, each once, in order of declaration.
[[nodiscard]] std::vector<ir::OperationSignature> leaving_calls(const ir::System&, const ir::Controller&);

}  // namespace robochart::csp_emit
