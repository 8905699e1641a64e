// SPDX-License-Identifier: Apache-2.0
#include "conformance/model/renamed_model.hpp"

#include "csp_emit/passes/safe_names.hpp"

namespace robochart::conformance {

namespace {

/// Returns the same component under its new names in the system.
ir::ComponentRef rename_component(const ir::System& system, ir::ComponentRef ref) {
    const auto take = [&](const auto& components, const auto& path) {
        if (ref.definition >= components.size()) return;
        ref.package = components[ref.definition].package;
        ref.path = path(components[ref.definition]);
    };
    const auto path = [](const auto& component) { return component.path; };
    if (ref.kind == ir::ComponentKind::module)
        take(system.modules, [](const ir::Module& module) { return module.name; });
    if (ref.kind == ir::ComponentKind::controller) take(system.controllers, path);
    if (ref.kind == ir::ComponentKind::machine) take(system.machines, path);
    return ref;
}

}  // namespace

RenamedSystem renamed_system(const ir::System& system, const ir::Instantiation& instantiation,
                             diagnostics::Diagnostics& diagnostics) {
    csp_emit::SafeNames safe = csp_emit::safe_names(system, instantiation, diagnostics);
    RenamedSystem model{safe.changed ? std::move(safe.system) : system,
                        safe.changed ? std::move(safe.instantiation) : instantiation, safe.changed};
    model.system.csp_blocks.clear();
    model.system.properties.clear();
    return model;
}

ir::ComponentRef renamed_component(const RenamedSystem& model, const ir::ComponentRef& component) {
    return model.changed ? rename_component(model.system, component) : component;
}

RenamedModel renamed_model(const ir::System& system, const ir::Instantiation& instantiation,
                           const ir::ComponentRef& component, diagnostics::Diagnostics& diagnostics) {
    RenamedSystem model = renamed_system(system, instantiation, diagnostics);
    ir::ComponentRef inside = renamed_component(model, component);
    return {std::move(model.system), std::move(model.instantiation), std::move(inside)};
}

}  // namespace robochart::conformance
