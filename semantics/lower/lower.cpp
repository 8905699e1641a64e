// SPDX-License-Identifier: Apache-2.0
// Lowers first types and the entries of components, then bodies, and then assertions, which refer to everything.
#include "semantics/lower/lower.hpp"

#include <algorithm>

#include "semantics/ir/query.hpp"
#include "semantics/lower/components.hpp"
#include "semantics/lower/machines.hpp"
#include "semantics/lower/properties.hpp"
#include "semantics/lower/types.hpp"
#include "semantics/rules.hpp"

namespace robochart::ir {
namespace {

namespace ast = frontend;

void sort_files(Lowering& lowering) {
    for (const auto& file : lowering.model.files)
        if (file) lowering.files.push_back(file.get());
    const auto path = [&](const ast::File* file) -> std::string_view {
        return file->source == diagnostics::SourceId::none ? std::string_view{} : lowering.sources.path(file->source);
    };
    std::ranges::stable_sort(lowering.files, [&](const ast::File* a, const ast::File* b) { return path(a) < path(b); });
    for (const auto* file : lowering.files)
        for (const auto& declaration : file->declarations) lowering.home[declaration.get()] = file;
}

void lower_declared_types(Lowering& lowering) {
    for (const auto* file : lowering.files)
        for (const auto& declaration : file->declarations) {
            const bool type = declaration->kind == ast::DeclKind::enumeration ||
                              declaration->kind == ast::DeclKind::record_type ||
                              (declaration->kind == ast::DeclKind::primitive_type && file->package.text() != "core");
            if (!type) continue;
            const auto& source = static_cast<const ast::TypeDeclaration&>(*declaration);
            (void)lower_declared_type(lowering, source, source.span);
        }
}

void lower_components(Lowering& lowering) {
    for (std::uint32_t i = 0; i < lowering.machine_sources.size(); ++i)
        lower_machine(lowering, *lowering.machine_sources[i], MachineId{i});
    for (std::uint32_t i = 0; i < lowering.controller_sources.size(); ++i)
        lower_controller(lowering, *lowering.controller_sources[i], ControllerId{i});
    for (std::size_t i = 0; i < lowering.module_sources.size(); ++i)
        lower_module(lowering, *lowering.module_sources[i], i);
}

}  // namespace

System lower(const ast::Model& model, const diagnostics::SourceManager& sources,
             diagnostics::Diagnostics& diagnostics) {
    Lowering lowering{model, sources, diagnostics};
    sort_files(lowering);
    intern_core_types(lowering);
    lower_declared_types(lowering);
    register_components(lowering);
    lower_components(lowering);
    check_calls(lowering);
    lower_properties(lowering);
    return std::move(lowering.system);
}

void leave_out_robosim(System& system, diagnostics::Diagnostics& diagnostics, bool elsewhere) {
    const std::vector<ComponentRef> robosim = robosim_components(system);
    if (robosim.empty()) return;
    const ComponentRef& first = robosim.front();
    diagnostics::Span place;
    if (first.kind == ComponentKind::module)
        place = system.modules[first.definition].origin.span;
    else if (first.kind == ComponentKind::controller)
        place = system.controllers[first.definition].origin.span;
    else
        place = system.machines[first.definition].origin.span;
    std::string what = "`" + first.path + "`";
    if (robosim.size() > 1) what += " (and " + std::to_string(robosim.size() - 1) + " more)";
    remove_robosim(system);
    const bool only = !elsewhere && system.machines.empty() && system.controllers.empty() && system.modules.empty();
    diagnostics.report(only ? rules::robosim_only : rules::robosim_passed_over, place, {what, "this command"});
}

}  // namespace robochart::ir
