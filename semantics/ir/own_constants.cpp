// SPDX-License-Identifier: Apache-2.0
// See own_constants.hpp.
#include "semantics/ir/own_constants.hpp"

#include "semantics/ir/query.hpp"

namespace robochart::ir {

std::map<std::string, std::string> own_constants(const System& system) {
    std::map<std::string, std::string> result;
    for (const Controller& controller : system.controllers) {
        const auto add = [&](const std::string& part, const Machine& machine) {
            for (std::uint32_t i = 0; i < machine.constants.size(); ++i) {
                const Constant& constant = machine.constants[i];
                const auto source = constant_source(system, nullptr, &controller, part, machine, ConstantId{i});
                if (source.constant == &constant)
                    result.emplace(source.name, constant_name(machine.package, machine.path, constant.name));
            }
        };
        for (const MachineInstance& part : controller.machines) add(part.name, system.machine(part.machine));
        for (std::size_t i = 0; i < controller.definitions.size(); ++i)
            add(controller.definition_names.at(i), system.machine(controller.definitions[i]));
    }
    return result;
}

}  // namespace robochart::ir
