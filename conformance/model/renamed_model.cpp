#include "conformance/model/renamed_model.hpp"

#include "csp_emit/passes/safe_names.hpp"

namespace robochart::conformance {

namespace {

/// The same component under the names that it has in the system.
ir::ComponentRef renamed(const ir::System& system, ir::ComponentRef ref) {
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

RenamedModel renamed_model(const ir::System& system, const ir::Instantiation& instantiation,
                           const ir::ComponentRef& component, diagnostics::Diagnostics& diagnostics) {
    csp_emit::SafeNames safe = csp_emit::safe_names(system, instantiation, diagnostics);
    RenamedModel model{safe.changed ? std::move(safe.system) : system,
                       safe.changed ? std::move(safe.instantiation) : instantiation, component};
    if (safe.changed) model.component = renamed(model.system, component);
    model.system.csp_blocks.clear();
    model.system.properties.clear();
    return model;
}

}  // namespace robochart::conformance
