// SPDX-License-Identifier: Apache-2.0
// Lowers controllers and modules: their components, the operations that they define, and their connections (semantics
// 3.8, 3.9).
#include "semantics/lower/components.hpp"

#include "semantics/ir/query.hpp"
#include "semantics/lower/machines.hpp"
#include "semantics/lower/registers.hpp"
#include "semantics/rules.hpp"

namespace robochart::ir {
namespace {

namespace ast = frontend;

/// A component in its context: the declaration that connections name, and the definition to which this declaration
/// refers.
struct Part {
    const ast::Declaration* place;
    const ast::Declaration* definition;  ///< null: unresolved reference
};

Part part_of(const ast::Declaration& declaration) {
    if (declaration.kind != ast::DeclKind::reference) return {&declaration, &declaration};
    return {&declaration, static_cast<const ast::Reference&>(declaration).target};
}

ConnectionEnd end_of(Lowering& lowering, const ast::Connection::End& end, const ByDeclaration<std::uint32_t>& parts,
                     const ast::Declaration* self) {
    ConnectionEnd result;
    result.event = end.event_target != nullptr ? end.event_target->name : end.event.text();
    const auto part = parts.find(end.node_target);
    if (part != parts.end()) {
        result.kind = EndKind::part;
        result.part = part->second;
    } else if (end.node_target == nullptr || end.node_target != self) {
        lowering.report_unresolved("the end '" + end.node.text() + "' of a connection", end.node.span);
    }
    return result;
}

std::vector<Connection> connections_of(Lowering& lowering, const ast::Component& source, const std::string& element,
                                       const ByDeclaration<std::uint32_t>& parts, const ast::Declaration* self) {
    std::vector<Connection> connections;
    for (const auto& item : source.connections) {
        Connection connection;
        connection.from = end_of(lowering, item->from, parts, self);
        connection.to = end_of(lowering, item->to, parts, self);
        connection.async = item->async;
        connection.multiple = item->multiple;
        connection.origin = origin_of(element, item->span);
        connections.push_back(std::move(connection));
    }
    return connections;
}

void mark_event(std::vector<Event>& events, const std::string& name, bool input, bool output) {
    for (auto& event : events) {
        if (event.name != name) continue;
        event.input = event.input || input;
        event.output = event.output || output;
    }
}

/// Marks the directions of events. A connection that starts at the controller or platform itself makes its event an
/// input. A connection that ends there makes it an output.
void mark_uses(std::vector<Event>& events, const std::vector<Connection>& connections) {
    for (const auto& connection : connections) {
        if (connection.from.kind == EndKind::self) mark_event(events, connection.from.event, true, connection.multiple);
        if (connection.to.kind == EndKind::self) mark_event(events, connection.to.event, connection.multiple, true);
    }
}

class ControllerLowering {
public:
    ControllerLowering(Lowering& lowering, const ast::Component& source, Controller& controller)
        : lowering_(lowering), source_(source), controller_(controller) {}

    void run();

private:
    void declare_members();
    void lower_part(const ast::Declaration& declaration);
    void lower_machine_part(const Part& part, MachineId id);
    void bind_operations();
    void check_software_calls();

    Lowering& lowering_;
    const ast::Component& source_;
    Controller& controller_;
    ByDeclaration<std::uint32_t> parts_;
};

void ControllerLowering::declare_members() {
    Declarations declared = lower_declarations(lowering_, source_, controller_.path);
    controller_.variables = std::move(declared.variables);
    controller_.constants = std::move(declared.constants);
    controller_.events = std::move(declared.events);
    controller_.operations = std::move(declared.operations);
    controller_.interfaces = std::move(declared.interfaces);
    controller_.robosim = source_.dialect == ast::Dialect::robosim;
    if (controller_.robosim) controller_.constants.push_back(cycle_constant(lowering_, declared.names, source_, true));
    if (!declared.clocks.empty())
        lowering_.report_unsupported("a clock of controller " + source_.name, source_.name_span);
}

/// Reports components with the same name, because names identify them.
template <class Parts>
void check_part(Lowering& lowering, const std::string& owner, const Parts& parts, const ast::Declaration& part) {
    for (const auto& known : parts)
        if (known.name == part.name)
            lowering.diagnostics.report(rules::declared_twice, part.name_span, {owner, "part", part.name})
                .notes.push_back({known.origin.span, "the first one"});
}

void ControllerLowering::lower_machine_part(const Part& part, MachineId id) {
    check_part(lowering_, controller_.path, controller_.machines, *part.place);
    MachineInstance instance;
    instance.name = part.place->name;
    instance.machine = id;
    instance.origin = origin_of(controller_.path + "::" + part.place->name, part.place->span);
    parts_[part.place] = static_cast<std::uint32_t>(controller_.machines.size());
    controller_.machines.push_back(std::move(instance));
}

void ControllerLowering::lower_part(const ast::Declaration& declaration) {
    const Part part = part_of(declaration);
    const auto id = lowering_.machines.find(part.definition);
    if (id == lowering_.machines.end())
        return lowering_.report_unresolved("part '" + declaration.name + "' of controller " + source_.name,
                                           declaration.span);
    if (lowering_.system.machine(id->second).kind == MachineKind::state_machine)
        return lower_machine_part(part, id->second);
    controller_.definitions.push_back(id->second);
    controller_.definition_names.push_back(declaration.name);
}

/// Binds calls of operations to the definitions in the controller. Other calls leave the controller (semantics 3.8).
void ControllerLowering::bind_operations() {
    for (auto& instance : controller_.machines)
        for (const auto& signature : lowering_.system.machine(instance.machine).operations)
            instance.definitions.push_back(signature.output ? MachineId{}
                                                            : definition_in(lowering_.system, controller_, signature));
    auto& leaving = controller_.operations;
    const auto defined = [&](const OperationSignature& signature) {
        return definition_in(lowering_.system, controller_, signature).is_valid();
    };
    // the operations that a RoboSim controller requires are outputs
    if (!controller_.robosim) std::erase_if(leaving, defined);
    if (controller_.robosim) check_software_calls();
}

/// Reports calls without `$` of operations that the controller does not define.
void ControllerLowering::check_software_calls() {
    std::vector<MachineId> callers = controller_.definitions;
    for (const auto& instance : controller_.machines) callers.push_back(instance.machine);
    for (const MachineId id : callers) {
        const Machine& caller = lowering_.system.machine(id);
        for (const OperationId called : called_operations(caller)) {
            const OperationSignature& operation = caller.operations[called.index];
            if (operation.output || definition_in(lowering_.system, controller_, operation).is_valid()) continue;
            lowering_.diagnostics.report(
                rules::robosim_unsupported, caller.origin.span,
                {"the call of " + operation.name + " in " + caller.name + ", which " + controller_.name +
                     " does not define,",
                 "call `$" + operation.name + "` if the platform performs it, or add the operation to the controller"});
        }
    }
}

void ControllerLowering::run() {
    declare_members();
    for (const auto* declaration : source_.order) lower_part(*declaration);
    bind_operations();
    controller_.connections = connections_of(lowering_, source_, controller_.path, parts_, &source_);
    mark_uses(controller_.events, controller_.connections);
}

Platform platform_of(Lowering& lowering, const ast::Context& source) {
    Declarations declared = lower_declarations(lowering, source, source.name);
    Platform platform;
    platform.name = source.name;
    platform.variables = std::move(declared.variables);
    platform.constants = std::move(declared.constants);
    platform.events = std::move(declared.events);
    platform.operations = std::move(declared.operations);
    platform.interfaces = std::move(declared.interfaces);
    platform.origin = origin_of(source.name, source.span);
    return platform;
}

class ModuleLowering {
public:
    ModuleLowering(Lowering& lowering, const ast::Component& source, Module& module)
        : lowering_(lowering), source_(source), module_(module) {}

    void run();

private:
    void lower_part(const ast::Declaration& declaration);

    Lowering& lowering_;
    const ast::Component& source_;
    Module& module_;
    ByDeclaration<std::uint32_t> parts_;
    const ast::Declaration* platform_ = nullptr;
};

void ModuleLowering::lower_part(const ast::Declaration& declaration) {
    const Part part = part_of(declaration);
    const std::string where = "part '" + declaration.name + "' of module " + source_.name;
    if (part.definition == nullptr) return lowering_.report_unresolved(where, declaration.span);
    if (part.definition->kind == ast::DeclKind::platform) {
        if (platform_ != nullptr)
            return lowering_.report_unsupported("a second platform in a module", declaration.span);
        platform_ = part.place;
        module_.platform = platform_of(lowering_, static_cast<const ast::Context&>(*part.definition));
        return;
    }
    const auto id = lowering_.controllers.find(part.definition);
    if (id == lowering_.controllers.end()) return lowering_.report_unsupported(where, declaration.span);
    check_part(lowering_, module_.name, module_.controllers, declaration);
    parts_[part.place] = static_cast<std::uint32_t>(module_.controllers.size());
    module_.controllers.push_back(
        {declaration.name, id->second, origin_of(module_.name + "::" + declaration.name, declaration.span)});
}

void ModuleLowering::run() {
    module_.origin = origin_of(module_.name, source_.span);
    for (const auto* declaration : source_.order) lower_part(*declaration);
    if (platform_ == nullptr) lowering_.report_unresolved("the platform of module " + source_.name, source_.name_span);
    module_.robosim = source_.dialect == ast::Dialect::robosim;
    if (module_.robosim) {
        module_.platform.constants.push_back(cycle_constant(lowering_, {}, source_, false));
    }
    module_.connections = connections_of(lowering_, source_, module_.name, parts_, platform_);
    mark_uses(module_.platform.events, module_.connections);
}

}  // namespace

void lower_controller(Lowering& lowering, const ast::Component& source, ControllerId id) {
    Controller controller = std::move(lowering.system.controllers[id.index]);
    controller.origin = origin_of(controller.path, source.span);
    ControllerLowering(lowering, source, controller).run();
    lowering.system.controllers[id.index] = std::move(controller);
}

void lower_module(Lowering& lowering, const ast::Component& source, std::size_t index) {
    Module module = std::move(lowering.system.modules[index]);
    ModuleLowering(lowering, source, module).run();
    lowering.system.modules[index] = std::move(module);
}

}  // namespace robochart::ir
