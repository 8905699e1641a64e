// SPDX-License-Identifier: Apache-2.0
// Answers questions about a System.
#include "semantics/ir/query.hpp"

#include <algorithm>
#include <set>

#include "semantics/ir/visit.hpp"

namespace robochart::ir {
namespace {

const Constant* find_constant(const std::vector<Constant>& constants, const std::string& name) {
    const auto it = std::ranges::find_if(constants, [&](const Constant& c) { return c.name == name; });
    return it == constants.end() ? nullptr : &*it;
}

bool parameters_match(const Machine& operation, const OperationSignature& signature) {
    std::vector<TypeId> types;
    for (const auto& variable : operation.variables)
        if (variable.scope == VariableScope::parameter) types.push_back(variable.type);
    return types == signature.parameters;
}

/// Collects NamedConstants without duplicate names.
class ConstantList {
public:
    void add(const std::string& package, const std::string& path, const Constant& constant) {
        const std::string name = constant_name(package, path, constant.name);
        if (!names_.insert(name).second) return;
        const std::string prefix = package.empty() ? "" : package + "::";
        constants_.push_back({name, prefix + path + "::" + constant.name, constant.type, constant.value != nullptr});
    }
    void add_all(const std::string& package, const std::string& path, const std::vector<Constant>& constants) {
        for (const auto& constant : constants) add(package, path, constant);
    }
    /// Adds the constants of a component, except those that another component provides.
    void add_part(const System& system, const Controller& controller, const std::string& part, const Machine& machine) {
        for (std::uint32_t i = 0; i < machine.constants.size(); ++i) {
            const auto source = constant_source(system, nullptr, &controller, part, machine, ConstantId{i});
            if (source.constant == &machine.constants[i])
                add(controller.package, controller.path + "::" + part, machine.constants[i]);
        }
    }
    std::vector<NamedConstant> take_constants() { return std::move(constants_); }

private:
    std::set<std::string> names_;
    std::vector<NamedConstant> constants_;
};

}  // namespace

std::string text_of(const Machine& machine, const Transition& transition) {
    return transition.name + ": " + machine.nodes[transition.source.index].path + " -> " +
           machine.nodes[transition.target.index].path;
}

std::string qualified_name(const ComponentRef& ref) {
    return ref.package.empty() ? ref.path : ref.package + "::" + ref.path;
}

MachineId definition_in(const System& system, const Controller& controller, const OperationSignature& signature) {
    for (const auto id : controller.definitions) {
        const Machine& machine = system.machine(id);
        if (machine.name == signature.name && parameters_match(machine, signature)) return id;
    }
    return {};
}

std::vector<OperationId> called_operations(const Machine& machine) {
    std::set<OperationId> called;
    visit_statements(machine, [&](const Stmt& stmt) {
        if (stmt.kind == StmtKind::call) called.insert(stmt.operation);
    });
    return {called.begin(), called.end()};
}

std::string constant_name(const std::string& package, const std::string& path, const std::string& constant) {
    std::string name = package.empty() ? path : package + "::" + path;
    for (std::size_t at = name.find("::"); at != std::string::npos; at = name.find("::", at)) name.replace(at, 2, "_");
    if (constant == cycle_length) {
        const std::size_t last = path.rfind("::");
        return "cycle_" + name + "_" + (last == std::string::npos ? path : path.substr(last + 2));
    }
    return "const_" + name + "_" + constant;
}

bool is_cycle_name(const std::string& name) {
    return name.starts_with("cycle_");
}

namespace {

/// A machine or operation definition of a controller.
struct Part {
    const std::string* name;
    const Machine* machine;
};

std::vector<Part> parts_of(const System& system, const Controller& controller) {
    std::vector<Part> parts;
    for (const auto& part : controller.machines) parts.push_back({&part.name, &system.machine(part.machine)});
    for (std::size_t i = 0; i < controller.definitions.size(); ++i)
        parts.push_back({&controller.definition_names.at(i), &system.machine(controller.definitions[i])});
    return parts;
}

bool can_call(const System& system, const Controller& controller, const Machine& caller, const Machine& operation) {
    const auto called = called_operations(caller);
    return std::ranges::any_of(called, [&](OperationId id) {
        const MachineId definition = definition_in(system, controller, caller.operations[id.index]);
        return definition.is_valid() && &system.machine(definition) == &operation;
    });
}

/// Follows a required constant to its providers. `calls_left` ends the search if an operation calls itself. (Lowering
/// rejects such operations.)
class ConstantSearch {
public:
    ConstantSearch(const System& system, const Module* module, const Controller& controller)
        : system_(system), module_(module), controller_(controller) {}

    void search_machine(const std::string& part, const Machine& machine, const Constant& constant,
                        std::size_t calls_left) {
        if (constant.required && machine.kind == MachineKind::operation && calls_left > 0 &&
            search_callers(machine, constant, calls_left - 1))
            return;
        if (constant.required)
            if (const Constant* provided = find_constant(controller_.constants, constant.name)) {
                const auto place = static_cast<std::uint32_t>(provided - controller_.constants.data());
                return add(constant_source(module_, controller_, ConstantId{place}));
            }
        add({constant_name(controller_.package, controller_.path + "::" + part, constant.name), &constant});
    }
    std::vector<ConstantSource> take_sources() { return std::move(found_); }

private:
    bool search_callers(const Machine& operation, const Constant& constant, std::size_t calls_left) {
        bool provided = false;
        for (const auto& part : parts_of(system_, controller_)) {
            const Constant* same = find_constant(part.machine->constants, constant.name);
            if (same == nullptr || !can_call(system_, controller_, *part.machine, operation)) continue;
            provided = true;
            search_machine(*part.name, *part.machine, *same, calls_left);
        }
        return provided;
    }
    void add(const ConstantSource& source) {
        const auto same = [&](const ConstantSource& known) { return known.name == source.name; };
        if (std::ranges::none_of(found_, same)) found_.push_back(source);
    }

    const System& system_;
    const Module* module_;
    const Controller& controller_;
    std::vector<ConstantSource> found_;
};

}  // namespace

std::vector<ConstantSource> constant_sources(const System& system, const Module* module, const Controller& controller,
                                             const std::string& part, const Machine& machine, ConstantId id) {
    ConstantSearch search(system, module, controller);
    search.search_machine(part, machine, machine.constants.at(id.index), controller.definitions.size());
    return search.take_sources();
}

bool SharedConstant::is_one_constant() const {
    return std::ranges::all_of(
        sources, [&](const ConstantSource& source) { return source.constant == sources.front().constant; });
}

std::string SharedConstant::source_names() const {
    std::string names;
    for (const ConstantSource& source : sources) names += (names.empty() ? "" : ", ") + source.name;
    return names;
}

std::vector<SharedConstant> shared_constants(const System& system) {
    std::vector<SharedConstant> result;
    for (const Controller& controller : system.controllers)
        for (std::size_t i = 0; i < controller.definitions.size(); ++i) {
            const Machine& operation = system.machine(controller.definitions[i]);
            for (std::uint32_t k = 0; k < operation.constants.size(); ++k) {
                auto sources = constant_sources(system, nullptr, controller, controller.definition_names[i], operation,
                                                ConstantId{k});
                if (sources.size() > 1)
                    result.push_back({&controller, &operation, operation.constants[k].name, std::move(sources)});
            }
        }
    return result;
}

ConstantSource constant_source(const System& system, const Module* module, const Controller* controller,
                               const std::string& part, const Machine& machine, ConstantId id) {
    const Constant& own = machine.constants.at(id.index);
    if (controller == nullptr) return {constant_name(machine.package, machine.path, own.name), &own};
    return constant_sources(system, module, *controller, part, machine, id).front();
}

ConstantSource constant_source(const Module* module, const Controller& controller, ConstantId id) {
    const Constant& own = controller.constants.at(id.index);
    const bool outside = module != nullptr && own.required;
    const Constant* platform = outside ? find_constant(module->platform.constants, own.name) : nullptr;
    if (platform != nullptr) return {constant_name(module->package, module->name, own.name), platform};
    return {constant_name(controller.package, controller.path, own.name), &own};
}

bool is_named_by(const std::string& path, const std::string& name) {
    return path == name || path.ends_with("::" + name);
}

std::vector<NamedConstant> named_constants(const System& system) {
    ConstantList list;
    for (const auto& machine : system.machines) list.add_all(machine.package, machine.path, machine.constants);
    for (const auto& controller : system.controllers) {
        list.add_all(controller.package, controller.path, controller.constants);
        for (const auto& part : controller.machines)
            list.add_part(system, controller, part.name, system.machine(part.machine));
        for (std::size_t i = 0; i < controller.definitions.size(); ++i)
            list.add_part(system, controller, controller.definition_names.at(i),
                          system.machine(controller.definitions[i]));
    }
    for (const auto& module : system.modules) list.add_all(module.package, module.name, module.platform.constants);
    for (const auto& simulation : system.simulations) list.add("", simulation.name, simulation.cycle);
    return list.take_constants();
}

std::vector<ComponentRef> robosim_components(const System& system) {
    std::vector<ComponentRef> result;
    const auto add = [&](ComponentKind kind, const auto& component, const std::string& path, std::size_t index) {
        if (component.robosim) result.push_back({kind, path, component.package, static_cast<std::uint32_t>(index)});
    };
    for (std::size_t i = 0; i < system.machines.size(); ++i) {
        const bool operation = system.machines[i].kind == MachineKind::operation;
        add(operation ? ComponentKind::operation : ComponentKind::machine, system.machines[i], system.machines[i].path,
            i);
    }
    for (std::size_t i = 0; i < system.controllers.size(); ++i)
        add(ComponentKind::controller, system.controllers[i], system.controllers[i].path, i);
    for (std::size_t i = 0; i < system.modules.size(); ++i)
        add(ComponentKind::module, system.modules[i], system.modules[i].name, i);
    return result;
}

bool is_robosim(const System& system, const ComponentRef& ref) {
    switch (ref.kind) {
        case ComponentKind::machine:
        case ComponentKind::operation:
            return system.machines.at(ref.definition).robosim;
        case ComponentKind::controller:
            return system.controllers.at(ref.definition).robosim;
        case ComponentKind::module:
            return system.modules.at(ref.definition).robosim;
        case ComponentKind::simulation:
        case ComponentKind::process:
            break;
    }
    return false;
}

const Input* event_register(const Machine& machine, VariableId id) {
    const auto found = std::ranges::find_if(machine.inputs, [&](const Input& input) {
        return input.full.is_valid() && (input.full == id || input.content == id);
    });
    return found == machine.inputs.end() ? nullptr : &*found;
}

bool touches_registers(const Machine& machine, const Stmt& stmt) {
    const auto is_register = [&](VariableId id) { return machine.variables[id.index].scope == VariableScope::reg; };
    if (stmt.kind == StmtKind::communicate || stmt.kind == StmtKind::exec) return true;
    if (stmt.kind == StmtKind::assign && is_register(stmt.variable)) return true;
    if (stmt.kind == StmtKind::call && machine.operations[stmt.operation.index].output) return true;
    bool found = false;
    const auto look = [&](const ExprPtr& root) {
        if (!root) return;
        visit_operands(*root, [&](const Expr& expr) {
            found = found || (expr.kind == ExprKind::variable && is_register(expr.variable));
        });
    };
    for (const ExprPtr* expr : {&stmt.condition, &stmt.value, &stmt.upper}) look(*expr);
    for (const auto* list : {&stmt.path, &stmt.args}) std::ranges::for_each(*list, look);
    return found;
}

void remove_robosim(System& system) {
    // lowering puts them after those of RoboChart
    std::erase_if(system.machines, [](const Machine& machine) { return machine.robosim; });
    std::erase_if(system.controllers, [](const Controller& controller) { return controller.robosim; });
    std::erase_if(system.modules, [](const Module& module) { return module.robosim; });
    system.simulations.clear();
    std::erase_if(system.properties, [](const Property& property) { return property.file.ends_with(".rsa"); });
    std::erase_if(system.csp_blocks, [](const CspBlock& block) { return block.file.ends_with(".rsa"); });
}

bool is_instantiations(const CspBlock& block) {
    return block.name == "Instantiations" || block.name == "instantiations";
}

}  // namespace robochart::ir
