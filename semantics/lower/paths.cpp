// SPDX-License-Identifier: Apache-2.0
// Follows component paths: Module::controller_ref::machine_ref::State.
#include "semantics/lower/paths.hpp"

#include <algorithm>

namespace robochart::ir {
namespace {

namespace ast = frontend;

FoundComponent module_at(const Lowering& lowering, std::uint32_t index) {
    const Module& module = lowering.system.modules[index];
    FoundComponent found;
    found.ref = {ComponentKind::module, module.name, module.package, index};
    found.module = &module;
    return found;
}

FoundComponent controller_at(const Lowering& lowering, std::uint32_t index) {
    const Controller& controller = lowering.system.controllers[index];
    FoundComponent found;
    found.ref = {ComponentKind::controller, controller.name, controller.package, index};
    found.controller = &controller;
    return found;
}

/// Returns the name of the machine's process. RoboTool names the process of an operation OP_name.
std::string process_name(const Machine& machine) {
    return machine.kind == MachineKind::operation ? "OP_" + machine.name : machine.name;
}

ComponentKind kind_of(const Machine& machine) {
    return machine.kind == MachineKind::operation ? ComponentKind::operation : ComponentKind::machine;
}

FoundComponent machine_at(const Lowering& lowering, std::uint32_t index) {
    const Machine& machine = lowering.system.machines[index];
    FoundComponent found;
    found.ref = {kind_of(machine), process_name(machine), machine.package, index};
    found.machine = &machine;
    return found;
}

template <class Source>
std::optional<std::uint32_t> index_of(const std::vector<const Source*>& sources, const ast::Declaration* declaration) {
    const auto at = std::ranges::find(sources, declaration);
    if (at == sources.end()) return std::nullopt;
    return static_cast<std::uint32_t>(at - sources.begin());
}

std::optional<FoundComponent> top_at(const Lowering& lowering, const ast::Declaration* top) {
    if (const auto module = index_of(lowering.module_sources, top)) return module_at(lowering, *module);
    if (const auto controller = index_of(lowering.controller_sources, top)) return controller_at(lowering, *controller);
    if (const auto machine = index_of(lowering.machine_sources, top)) return machine_at(lowering, *machine);
    return std::nullopt;
}

/// Goes to the controller with this name in the module.
bool enter_controller(const Lowering& lowering, FoundComponent& at, const std::string& name) {
    for (const auto& part : at.module->controllers) {
        if (part.name != name) continue;
        at.controller = &lowering.system.controller(part.controller);
        at.ref.kind = ComponentKind::controller;
        at.ref.path += "::" + name;
        at.ref.definition = part.controller.index;
        return true;
    }
    return false;
}

void enter_machine(const Lowering& lowering, FoundComponent& at, MachineId id, const std::string& part,
                   const std::string& process) {
    at.machine = &lowering.system.machine(id);
    at.part = part;
    at.ref.kind = kind_of(*at.machine);
    at.ref.path += "::" + process;
    at.ref.definition = id.index;
}

/// Goes to the machine or defined operation in the controller with this name of the reference or operation.
bool enter_part(const Lowering& lowering, FoundComponent& at, const std::string& name) {
    for (const auto& part : at.controller->machines) {
        if (part.name != name) continue;
        enter_machine(lowering, at, part.machine, name, name);
        return true;
    }
    for (std::size_t i = 0; i < at.controller->definitions.size(); ++i) {
        const MachineId id = at.controller->definitions[i];
        const Machine& machine = lowering.system.machine(id);
        const std::string& reference = at.controller->definition_names[i];
        if (reference != name && machine.name != name && process_name(machine) != name) continue;
        enter_machine(lowering, at, id, reference, process_name(machine));
        return true;
    }
    return false;
}

bool enter_component(const Lowering& lowering, FoundComponent& at, const std::string& name) {
    if (at.ref.kind == ComponentKind::module) return enter_controller(lowering, at, name);
    if (at.ref.kind == ComponentKind::controller) return enter_part(lowering, at, name);
    return false;
}

}  // namespace

std::optional<FoundComponent> component_at(const Lowering& lowering, const ast::ComponentPath& path) {
    if (path.steps.empty()) return std::nullopt;
    auto found = top_at(lowering, path.steps.front());
    for (std::size_t i = 1; found && i < path.steps.size(); ++i)
        if (!enter_component(lowering, *found, path.steps[i]->name)) return std::nullopt;
    return found;
}

}  // namespace robochart::ir
