// SPDX-License-Identifier: Apache-2.0
// See components.hpp.
#include "claims/checks/components.hpp"

#include <algorithm>

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

void add_call(const ir::OperationSignature& operation, Component& component) {
    component.channels.push_back({operation.name, ChannelKind::call, operation.parameters});
}

class Lister {
public:
    explicit Lister(const ir::System& system) : system_(system) {}

    /// Claims in English are about RoboChart components only.
    std::vector<Component> list_all() {
        for (const ir::Module& module : system_.modules)
            if (!module.robosim) add_module(module);
        for (const ir::Controller& controller : system_.controllers)
            if (!controller.robosim)
                add_controller(controller, qualified(controller.package, controller.path), controller.package, false);
        for (std::uint32_t i = 0; i < system_.machines.size(); ++i) {
            const ir::Machine& machine = system_.machines[i];
            if (machine.kind == ir::MachineKind::state_machine && !machine.robosim)
                add_machine({i}, {}, qualified(machine.package, machine.path), machine.package, false);
        }
        return std::move(result_);
    }

private:
    void add_module(const ir::Module& module) {
        Component component{
            ir::ComponentKind::module, qualified(module.package, module.name), module.package, false, {}};
        add_events(module.platform.events, component);
        for (const ir::OperationSignature& operation : module.platform.operations) add_call(operation, component);
        for (const ir::ControllerInstance& instance : module.controllers)
            add_definitions(system_.controller(instance.controller), component);
        const std::string path = component.path;
        for (const ir::ControllerInstance& instance : module.controllers)
            add_machines(system_.controller(instance.controller), path + "::" + instance.name, component);
        result_.push_back(std::move(component));
        for (const ir::ControllerInstance& instance : module.controllers)
            add_controller(system_.controller(instance.controller), path + "::" + instance.name, module.package, true);
    }

    void add_definitions(const ir::Controller& controller, Component& component) {
        for (const ir::MachineId definition : controller.definitions)
            component.defined.push_back(system_.machine(definition).name);
    }

    static void add_machines(const ir::Controller& controller, const std::string& path, Component& component) {
        for (const ir::MachineInstance& instance : controller.machines)
            component.machines.push_back({path + "::" + instance.name, instance.machine});
    }

    void add_controller(const ir::Controller& controller, const std::string& path, const std::string& package,
                        bool part) {
        Component component{ir::ComponentKind::controller, path, package, part, {}};
        add_events(controller.events, component);
        for (const ir::OperationSignature& operation : controller.operations) add_call(operation, component);
        add_definitions(controller, component);
        add_machines(controller, path, component);
        result_.push_back(std::move(component));
        for (const ir::MachineInstance& instance : controller.machines)
            add_machine(instance.machine, instance.definitions, path + "::" + instance.name, package, true);
    }

    void add_machine(ir::MachineId id, const std::vector<ir::MachineId>& definitions, const std::string& path,
                     const std::string& package, bool part) {
        const ir::Machine& machine = system_.machine(id);
        Component component{ir::ComponentKind::machine, path, package, part, {}};
        component.machines.push_back({path, id});
        add_events(machine.events, component);
        for (std::size_t i = 0; i < machine.operations.size(); ++i) {
            const bool defined = i < definitions.size() && definitions[i].is_valid();
            if (defined)
                component.defined.push_back(machine.operations[i].name);
            else
                add_call(machine.operations[i], component);
        }
        result_.push_back(std::move(component));
    }

    const ir::System& system_;
    std::vector<Component> result_;
};

}  // namespace

std::vector<Component> components_of(const ir::System& system) {
    return Lister(system).list_all();
}

}  // namespace robochart::claims
