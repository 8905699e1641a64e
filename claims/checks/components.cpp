// SPDX-License-Identifier: Apache-2.0
// See components.hpp.
#include "claims/checks/components.hpp"

#include <algorithm>
#include <map>

#include "semantics/ir/own_constants.hpp"
#include "semantics/ir/query.hpp"

namespace robochart::claims {
namespace {

std::string qualified(const std::string& package, const std::string& path) {
    return package.empty() ? path : package + "::" + path;
}

void add_events(const std::vector<ir::Event>& events, Component& component) {
    for (const ir::Event& event : events) {
        std::vector<ir::TypeId> types;
        if (event.type) types.push_back(*event.type);
        if (event.input) component.channels.push_back({event.name, ChannelKind::input, types});
        if (event.output) component.channels.push_back({event.name, ChannelKind::output, types});
    }
}

/// Adds the events of the input context of a RoboSim machine, which are registers of the machine.
void add_registers(const ir::Machine& machine, Component& component) {
    for (const ir::Input& input : machine.inputs) {
        if (!input.full.is_valid()) continue;
        std::vector<ir::TypeId> types;
        if (input.content.is_valid()) types.push_back(machine.variables[input.content.index].type);
        component.channels.push_back({input.name, ChannelKind::input, types});
    }
}

void add_call(const ir::OperationSignature& operation, Component& component) {
    component.channels.push_back({operation.name, ChannelKind::call, operation.parameters});
}

/// Returns the ends of connections that are connected to an event of a part.
std::vector<const ir::ConnectionEnd*> ends_of(const std::vector<ir::Connection>& connections, std::size_t part,
                                              const std::string& event) {
    const auto is_here = [&](const ir::ConnectionEnd& end) {
        return end.kind == ir::EndKind::part && end.part == part && end.event == event;
    };
    std::vector<const ir::ConnectionEnd*> result;
    for (const ir::Connection& connection : connections) {
        if (is_here(connection.from)) result.push_back(&connection.to);
        if (is_here(connection.to)) result.push_back(&connection.from);
    }
    return result;
}

class Lister {
public:
    explicit Lister(const ir::System& system) : system_(system), own_(ir::own_constants(system)) {}

    std::vector<Component> list_all() {
        for (const ir::Module& module : system_.modules) add_module(module);
        for (const ir::Controller& controller : system_.controllers)
            add_controller(controller, qualified(controller.package, controller.path), controller.package, nullptr);
        for (std::uint32_t i = 0; i < system_.machines.size(); ++i) {
            const ir::Machine& machine = system_.machines[i];
            if (machine.kind == ir::MachineKind::state_machine) result_.push_back(machine_alone({i}));
        }
        return std::move(result_);
    }

private:
    void add_module(const ir::Module& module) {
        Component component{ir::ComponentKind::module,
                            qualified(module.package, module.name),
                            module.package,
                            false,
                            module.robosim,
                            {}};
        add_events(module.platform.events, component);
        for (const ir::OperationSignature& operation : module.platform.operations) add_call(operation, component);
        for (const ir::ControllerInstance& instance : module.controllers)
            add_definitions(system_.controller(instance.controller), component);
        const std::string path = component.path;
        for (const ir::Constant& constant : module.platform.constants)
            add_constant(constant, ir::constant_name(module.package, module.name, constant.name), component);
        for (std::size_t i = 0; i < module.controllers.size(); ++i) {
            add_spontaneous(system_.controller(module.controllers[i].controller), &module, i, component);
            add_sources(system_.controller(module.controllers[i].controller), &module, component);
        }
        for (const ir::ControllerInstance& instance : module.controllers)
            add_machines(system_.controller(instance.controller), path + "::" + instance.name, component);
        result_.push_back(std::move(component));
        for (const ir::ControllerInstance& instance : module.controllers)
            add_controller(system_.controller(instance.controller), path + "::" + instance.name, module.package,
                           &module);
    }

    // ------------------------------------------------------------ constants

    /// The length of a cycle is not a constant that claims set.
    void add_constant(const ir::Constant& constant, const std::string& source, Component& component) const {
        add_source(source, component);
        if (!ir::is_cycle_name(source)) component.constants.push_back({constant.name, source, constant.type});
    }
    /// A machine's own constant determines its value in the controllers that run the machine, too.
    void add_source(const std::string& source, Component& component) const {
        component.sources.insert(source);
        if (const auto own = own_.find(source); own != own_.end()) component.sources.insert(own->second);
    }
    /// `part` names the machine or operation in the controller.
    void add_sources(const ir::Module* module, const ir::Controller& controller, const std::string& part,
                     const ir::Machine& machine, Component& component) const {
        for (std::uint32_t i = 0; i < machine.constants.size(); ++i)
            for (const ir::ConstantSource& source :
                 ir::constant_sources(system_, module, controller, part, machine, ir::ConstantId{i}))
                add_source(source.name, component);
    }
    void add_sources(const ir::Controller& controller, const ir::Module* module, Component& component) const {
        for (std::uint32_t i = 0; i < controller.constants.size(); ++i)
            add_source(ir::constant_source(module, controller, ir::ConstantId{i}).name, component);
        for (const ir::MachineInstance& instance : controller.machines)
            add_sources(module, controller, instance.name, system_.machine(instance.machine), component);
        add_sources_of_operations(controller, module, component);
    }
    void add_sources_of_operations(const ir::Controller& controller, const ir::Module* module,
                                   Component& component) const {
        for (std::size_t i = 0; i < controller.definitions.size(); ++i)
            add_sources(module, controller, controller.definition_names[i], system_.machine(controller.definitions[i]),
                        component);
    }

    // ------------------------------------------------------------ parts

    /// Adds events of the controller that trigger transitions without being raised. `module` is the module in which the
    /// controller runs as part `number`; null if the controller is alone.
    void add_spontaneous(const ir::Controller& controller, const ir::Module* module, std::size_t number,
                         Component& component) const {
        const auto raised = [&](std::size_t part, const std::string& event) {
            return std::ranges::any_of(ends_of(controller.connections, part, event), [&](const ir::ConnectionEnd* end) {
                return end->kind == ir::EndKind::part || module == nullptr ||
                       !ends_of(module->connections, number, end->event).empty();
            });
        };
        for (std::size_t part = 0; part < controller.machines.size(); ++part) {
            const ir::Machine& machine = system_.machine(controller.machines[part].machine);
            for (std::size_t event = 0; event < machine.events.size(); ++event) {
                const ir::Event& declared = machine.events[event];
                const bool awaited = std::ranges::any_of(machine.transitions, [&](const ir::Transition& transition) {
                    return transition.trigger && transition.trigger->event.index == event;
                });
                if (awaited && !raised(part, declared.name))
                    component.spontaneous.push_back({declared.name, machine.name, declared.origin.span});
            }
        }
    }

    void add_definitions(const ir::Controller& controller, Component& component) {
        for (const ir::MachineId definition : controller.definitions)
            component.defined.push_back(system_.machine(definition).name);
    }

    static void add_machines(const ir::Controller& controller, const std::string& path, Component& component) {
        for (const ir::MachineInstance& instance : controller.machines)
            component.machines.push_back({path + "::" + instance.name, instance.machine});
    }

    /// `module`: the module in which the controller runs; null: it is alone.
    void add_controller(const ir::Controller& controller, const std::string& path, const std::string& package,
                        const ir::Module* module) {
        const bool part = module != nullptr;
        Component component{ir::ComponentKind::controller, path, package, part, controller.robosim, {}};
        add_events(controller.events, component);
        for (const ir::OperationSignature& operation : controller.operations) add_call(operation, component);
        add_definitions(controller, component);
        add_machines(controller, path, component);
        add_spontaneous(controller, nullptr, 0, component);
        for (std::uint32_t i = 0; i < controller.constants.size(); ++i)
            add_constant(controller.constants[i], ir::constant_source(module, controller, ir::ConstantId{i}).name,
                         component);
        add_sources(controller, module, component);
        result_.push_back(std::move(component));
        for (const ir::MachineInstance& instance : controller.machines) {
            Component machine = machine_at(instance.machine, instance.definitions, path + "::" + instance.name);
            machine.package = package;
            machine.part = true;
            const ir::Machine& declared = system_.machine(instance.machine);
            for (std::uint32_t i = 0; i < declared.constants.size(); ++i)
                add_constant(
                    declared.constants[i],
                    ir::constant_source(system_, module, &controller, instance.name, declared, ir::ConstantId{i}).name,
                    machine);
            add_sources_of_operations(controller, module, machine);
            result_.push_back(std::move(machine));
        }
    }

    [[nodiscard]] Component machine_alone(ir::MachineId id) const {
        const ir::Machine& machine = system_.machine(id);
        Component component = machine_at(id, {}, qualified(machine.package, machine.path));
        component.package = machine.package;
        for (std::uint32_t i = 0; i < machine.constants.size(); ++i)
            add_constant(machine.constants[i],
                         ir::constant_source(system_, nullptr, nullptr, "", machine, ir::ConstantId{i}).name,
                         component);
        return component;
    }

    [[nodiscard]] Component machine_at(ir::MachineId id, const std::vector<ir::MachineId>& definitions,
                                       const std::string& path) const {
        const ir::Machine& machine = system_.machine(id);
        Component component{ir::ComponentKind::machine, path, "", false, machine.robosim, {}};
        component.machines.push_back({path, id});
        add_events(machine.events, component);
        add_registers(machine, component);
        for (std::size_t i = 0; i < machine.operations.size(); ++i) {
            const bool defined = i < definitions.size() && definitions[i].is_valid();
            if (defined)
                component.defined.push_back(machine.operations[i].name);
            else
                add_call(machine.operations[i], component);
        }
        return component;
    }

    const ir::System& system_;
    std::map<std::string, std::string> own_;  ///< maps a constant of a part to the machine's own constant
    std::vector<Component> result_;
};

}  // namespace

std::vector<Component> components_of(const ir::System& system) {
    return Lister(system).list_all();
}

}  // namespace robochart::claims
