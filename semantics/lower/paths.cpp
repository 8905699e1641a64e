// Walking component paths: Module::controller_ref::machine_ref::State.
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

/// RoboTool's process of an operation is called OP_name.
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

/// The components at package level: inline ones have a longer path than their name.
template <class Visitor>
void each_top_component(const Lowering& lowering, const Visitor& visit) {
    const System& system = lowering.system;
    for (std::uint32_t i = 0; i < system.modules.size(); ++i)
        visit(system.modules[i].name, [&] { return module_at(lowering, i); });
    for (std::uint32_t i = 0; i < system.controllers.size(); ++i)
        if (system.controllers[i].path == system.controllers[i].name)
            visit(system.controllers[i].name, [&] { return controller_at(lowering, i); });
    for (std::uint32_t i = 0; i < system.machines.size(); ++i)
        if (system.machines[i].path == system.machines[i].name)
            visit(system.machines[i].name, [&] { return machine_at(lowering, i); });
}

bool imported(const ast::File& file, const std::string& package, const std::string& name) {
    return std::any_of(file.imports.begin(), file.imports.end(), [&](const ast::Import& import) {
        return import.wildcard ? import.name.text() == package : import.name.text() == package + "::" + name;
    });
}

/// How near a component is when its name is written without package: 0 own package, 1 unnamed or imported, 2 elsewhere.
std::size_t distance(const ast::File& file, const std::string& package, const std::string& name) {
    if (package == file.package.text()) return 0;
    return package.empty() || imported(file, package, name) ? 1 : 2;
}

std::vector<std::string> split(const std::string& path) {
    std::vector<std::string> parts;
    for (std::size_t start = 0; start <= path.size();) {
        const std::size_t end = std::min(path.find("::", start), path.size());
        if (end > start) parts.push_back(path.substr(start, end - start));
        start = end + 2;
    }
    return parts;
}

bool starts_with(const std::vector<std::string>& name, const std::vector<std::string>& prefix) {
    return prefix.size() <= name.size() && std::equal(prefix.begin(), prefix.end(), name.begin());
}

std::optional<FoundComponent> find_in_packages(const Lowering& lowering, const ast::File& file,
                                               const std::vector<std::string>& name) {
    std::vector<std::pair<std::size_t, FoundComponent>> candidates;
    each_top_component(lowering, [&](const std::string& top, const auto& make) {
        FoundComponent found = make();
        const auto package = split(found.ref.package);
        if (name.front() == top) {
            found.used = 1;
            candidates.emplace_back(distance(file, found.ref.package, top), found);
        } else if (!package.empty() && starts_with(name, package) && name.size() > package.size() &&
                   name[package.size()] == top) {
            found.used = package.size() + 1;
            candidates.emplace_back(0, found);
        }
    });
    if (candidates.empty()) return std::nullopt;
    const auto nearer = [](const auto& a, const auto& b) { return a.first < b.first; };
    const auto best = std::min_element(candidates.begin(), candidates.end(), nearer);
    const auto same =
        std::count_if(candidates.begin(), candidates.end(), [&](const auto& c) { return c.first == best->first; });
    if (best->first == 2 && same > 1) return std::nullopt;
    return best->second;
}

/// The controller of a module under its name there.
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

/// A machine of a controller, or an operation it defines, by reference or operation name.
bool enter_part(const Lowering& lowering, FoundComponent& at, const std::string& name) {
    for (const auto& part : at.controller->machines)
        if (part.name == name) return enter_machine(lowering, at, part.machine, name, name), true;
    for (std::size_t i = 0; i < at.controller->definitions.size(); ++i) {
        const MachineId id = at.controller->definitions[i];
        const Machine& machine = lowering.system.machine(id);
        const std::string& reference = at.controller->definition_names[i];
        if (reference == name || machine.name == name || process_name(machine) == name)
            return enter_machine(lowering, at, id, reference, process_name(machine)), true;
    }
    return false;
}

bool enter(const Lowering& lowering, FoundComponent& at, const std::string& name) {
    if (at.ref.kind == ComponentKind::module) return enter_controller(lowering, at, name);
    if (at.ref.kind == ComponentKind::controller) return enter_part(lowering, at, name);
    return false;
}

}  // namespace

FoundComponent walk(const Lowering& lowering, FoundComponent from, const std::vector<std::string>& names) {
    std::size_t used = 0;
    while (used < names.size() && enter(lowering, from, names[used])) ++used;
    from.used = used;
    return from;
}

std::optional<FoundComponent> find_component(const Lowering& lowering, const ast::File& file,
                                             const ast::QualifiedName& name) {
    if (name.parts.empty()) return std::nullopt;
    const auto top = find_in_packages(lowering, file, name.parts);
    if (!top) return std::nullopt;
    const std::size_t used = top->used;
    const std::vector<std::string> rest(name.parts.begin() + static_cast<std::ptrdiff_t>(used), name.parts.end());
    FoundComponent found = walk(lowering, *top, rest);
    found.used += used;
    return found;
}

const Node* find_node(const Machine& machine, const std::vector<std::string>& names, std::size_t from) {
    std::string path;
    for (std::size_t i = from; i < names.size(); ++i) path += (path.empty() ? "" : "::") + names[i];
    const auto at =
        std::find_if(machine.nodes.begin(), machine.nodes.end(), [&](const Node& node) { return node.path == path; });
    return at == machine.nodes.end() ? nullptr : &*at;
}

std::vector<std::string> component_paths(const Lowering& lowering) {
    std::vector<std::string> paths;
    each_top_component(lowering, [&](const std::string& name, const auto&) { paths.push_back(name); });
    for (const auto& module : lowering.system.modules)
        for (const auto& part : module.controllers) paths.push_back(module.name + "::" + part.name);
    for (const auto& controller : lowering.system.controllers)
        for (const auto& part : controller.machines) paths.push_back(controller.path + "::" + part.name);
    return paths;
}

std::vector<FoundComponent> instances_of(const Lowering& lowering, const FoundComponent& above, MachineId machine) {
    std::vector<FoundComponent> found;
    if (above.ref.kind == ComponentKind::module) {
        for (const auto& part : above.module->controllers) {
            const auto inner = instances_of(lowering, walk(lowering, above, {part.name}), machine);
            found.insert(found.end(), inner.begin(), inner.end());
        }
    } else if (above.ref.kind == ComponentKind::controller) {
        for (const auto& part : above.controller->machines)
            if (part.machine == machine) found.push_back(walk(lowering, above, {part.name}));
    }
    return found;
}

}  // namespace robochart::ir
