#include "conformance/safe_model.hpp"

#include "csp_emit/safe_names.hpp"

namespace robochart::conformance {

namespace {

std::string path_of(const ir::System& system, const ir::ComponentRef& ref) {
    switch (ref.kind) {
        case ir::ComponentKind::module:
            return ref.definition < system.modules.size() ? system.modules[ref.definition].name : ref.path;
        case ir::ComponentKind::controller:
            return ref.definition < system.controllers.size() ? system.controllers[ref.definition].path : ref.path;
        case ir::ComponentKind::machine:
            return ref.definition < system.machines.size() ? system.machines[ref.definition].path : ref.path;
        case ir::ComponentKind::operation:
        case ir::ComponentKind::process:
            break;
    }
    return ref.path;
}

}  // namespace

SafeModel safe_model(const ir::System& system, const ir::Instantiation& instantiation,
                     const ir::ComponentRef& component, diagnostics::Diagnostics& diagnostics) {
    csp_emit::SafeNames safe = csp_emit::safe_names(system, instantiation, diagnostics);
    SafeModel model{safe.changed ? std::move(safe.system) : system,
                    safe.changed ? std::move(safe.instantiation) : instantiation, component};
    if (safe.changed) model.component.path = path_of(model.system, component);
    model.system.csp_blocks.clear();
    model.system.properties.clear();
    return model;
}

}  // namespace robochart::conformance
