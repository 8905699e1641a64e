// SPDX-License-Identifier: Apache-2.0
#include "driver/model/places.hpp"

namespace robochart::driver {

diagnostics::Span declared_at(const ir::System& system, const ir::ComponentRef& component) {
    switch (component.kind) {
        case ir::ComponentKind::module:
            return system.modules[component.definition].origin.span;
        case ir::ComponentKind::controller:
            return system.controllers[component.definition].origin.span;
        case ir::ComponentKind::machine:
            return system.machines[component.definition].origin.span;
        case ir::ComponentKind::simulation:
            return system.simulations[component.definition].origin.span;
        case ir::ComponentKind::operation:
        case ir::ComponentKind::process:
            break;
    }
    return {};
}

diagnostics::Span model_place(const Project& project) {
    if (!project.model || project.model->files.empty()) return {};
    return {project.model->files.front()->source, 0, 0};
}

}  // namespace robochart::driver
