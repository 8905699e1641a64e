// SPDX-License-Identifier: Apache-2.0
// Creates the entries in the System before bodies are lowered, so that references can be resolved.
#include "semantics/lower/components.hpp"

namespace robochart::ir {
namespace {

namespace ast = frontend;

std::string path_below(const std::string& path, const std::string& name) {
    return path.empty() ? name : path + "::" + name;
}

void add_machine(Lowering& lowering, const ast::Machine& source, const std::string& path) {
    Machine machine;
    machine.kind = source.kind == ast::DeclKind::operation ? MachineKind::operation : MachineKind::state_machine;
    machine.name = source.name;
    machine.package = lowering.package_of(source);
    machine.path = path_below(path, source.name);
    lowering.machines[&source] = MachineId{static_cast<std::uint32_t>(lowering.system.machines.size())};
    lowering.machine_sources.push_back(&source);
    lowering.system.machines.push_back(std::move(machine));
}

void add_controller(Lowering& lowering, const ast::Component& source, const std::string& path) {
    Controller controller;
    controller.name = source.name;
    controller.package = lowering.package_of(source);
    controller.path = path_below(path, source.name);
    for (const auto* part : source.order)
        if (part->kind == ast::DeclKind::state_machine || part->kind == ast::DeclKind::operation)
            add_machine(lowering, static_cast<const ast::Machine&>(*part), controller.path);
    lowering.controllers[&source] = ControllerId{static_cast<std::uint32_t>(lowering.system.controllers.size())};
    lowering.controller_sources.push_back(&source);
    lowering.system.controllers.push_back(std::move(controller));
}

void add_module(Lowering& lowering, const ast::Component& source) {
    for (const auto* part : source.order)
        if (part->kind == ast::DeclKind::controller)
            add_controller(lowering, static_cast<const ast::Component&>(*part), source.name);
    Module module;
    module.name = source.name;
    module.package = lowering.package_of(source);
    lowering.module_sources.push_back(&source);
    lowering.system.modules.push_back(std::move(module));
}

/// True for a component whose behaviour is written in RoboSim.
bool is_robosim(const ast::Declaration& declaration) {
    const auto* context = dynamic_cast<const ast::Context*>(&declaration);
    const bool component = declaration.kind == ast::DeclKind::state_machine ||
                           declaration.kind == ast::DeclKind::operation ||
                           declaration.kind == ast::DeclKind::controller || declaration.kind == ast::DeclKind::module;
    return component && context != nullptr && context->dialect == ast::Dialect::robosim;
}

}  // namespace

/// Registers all components. RoboChart's components come first, so that those of RoboSim can be removed
/// (remove_robosim).
void register_components(Lowering& lowering) {
    for (const bool robosim : {false, true})
        for (const auto* file : lowering.files)
            for (const auto& declaration : file->declarations) {
                if (is_robosim(*declaration) != robosim) continue;
                if (declaration->kind == ast::DeclKind::state_machine || declaration->kind == ast::DeclKind::operation)
                    add_machine(lowering, static_cast<const ast::Machine&>(*declaration), "");
                if (declaration->kind == ast::DeclKind::controller)
                    add_controller(lowering, static_cast<const ast::Component&>(*declaration), "");
                if (declaration->kind == ast::DeclKind::module)
                    add_module(lowering, static_cast<const ast::Component&>(*declaration));
            }
}

}  // namespace robochart::ir
