// SPDX-License-Identifier: Apache-2.0
// See seats.hpp.
#include "prism/assertions/process/seats.hpp"

#include "semantics/ir/query.hpp"

namespace robochart::probability {
namespace {

std::string path_below(const std::string& path, const std::string& name) {
    return path.empty() ? name : path + "::" + name;
}

void add_machines(const ir::System& system, const ir::Module* module, const ir::Controller& controller,
                  const std::string& path, const std::string& component, std::vector<Seat>& result) {
    for (const ir::MachineInstance& instance : controller.machines)
        result.push_back({module, &controller, instance.name, &system.machine(instance.machine),
                          path_below(path, instance.name), path_below(component, instance.name)});
}

}  // namespace

std::vector<Seat> seats_in(const ir::System& system, const ir::ComponentRef& subject) {
    std::vector<Seat> result;
    const std::string component = ir::qualified_name(subject);
    if (subject.kind == ir::ComponentKind::module) {
        const ir::Module& module = system.modules[subject.definition];
        for (const ir::ControllerInstance& instance : module.controllers)
            add_machines(system, &module, system.controller(instance.controller),
                         path_below(subject.path, instance.name), path_below(component, instance.name), result);
    } else if (subject.kind == ir::ComponentKind::controller) {
        add_machines(system, nullptr, system.controllers[subject.definition], subject.path, component, result);
    } else if (subject.kind == ir::ComponentKind::machine) {
        const ir::Machine& machine = system.machines[subject.definition];
        result.push_back({nullptr, nullptr, machine.name, &machine, subject.path, component});
    }
    return result;
}

}  // namespace robochart::probability
