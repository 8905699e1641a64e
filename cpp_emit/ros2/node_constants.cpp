// SPDX-License-Identifier: Apache-2.0
// Finds constants whose values come from options of the generator and not from the model.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "cpp_emit/ros2/model_values.hpp"
#include "cpp_emit/ros2/node_files.hpp"
#include "semantics/ir/query.hpp"

namespace robochart::cpp_emit::ros2 {

namespace {

/// The context of a part's machines.
struct Surroundings {
    const ir::Module* module = nullptr;
    const ir::Controller* controller = nullptr;
};

Surroundings context_of_part(const Generation& generation, const Part& part) {
    const ir::System& system = generation.system;
    const ir::ComponentRef& ref = generation.component.ref;
    if (ref.kind == ir::ComponentKind::module) {
        const ir::Module& module = system.modules[ref.definition];
        return {&module, &system.controllers[module.controllers[part.controller].controller.index]};
    }
    if (ref.kind == ir::ComponentKind::controller) return {nullptr, &system.controllers[ref.definition]};
    return {};
}

/// The name under which a machine or operation runs in its controller.
std::string name_in(const Surroundings& around, const Unit& unit, const Part& part) {
    if (around.controller == nullptr) return "";
    const ir::Controller& controller = *around.controller;
    if (unit.root) return controller.machines[part.machine].name;
    const auto found = std::ranges::find(controller.definitions, unit.id);
    return controller.definition_names[static_cast<std::size_t>(found - controller.definitions.begin())];
}

/// The name of the parameter: "SPEED" for "P::M::SPEED". If other constants have the same last part, the whole path
/// with dots.
std::string parameter_of(const std::string& path, const std::map<std::string, int>& ends) {
    const std::string last = path.substr(path.rfind(':') + 1);
    if (ends.at(last) == 1) return "constants." + last;
    std::string dotted = path;
    for (std::size_t at = dotted.find("::"); at != std::string::npos; at = dotted.find("::"))
        dotted.replace(at, 2, ".");
    return "constants." + dotted;
}

}  // namespace

std::vector<NodeConstant> node_constants(const Generation& generation) {
    std::map<std::string, std::string> paths;
    for (const ir::NamedConstant& constant : ir::named_constants(generation.system))
        paths.emplace(constant.name, constant.path);
    std::map<std::string, NodeConstant> found;
    for (const Unit& unit : generation.component.units) {
        const Part& part = generation.component.part_of(unit);
        const Surroundings around = context_of_part(generation, part);
        const std::string name = name_in(around, unit, part);
        for (std::uint32_t i = 0; i < unit.machine->constants.size(); ++i) {
            const ir::ConstantId id{i};
            const ir::ConstantSource source =
                ir::constant_source(generation.system, around.module, around.controller, name, *unit.machine, id);
            const bool open = generation.inst.constants.contains(source.name) && paths.contains(source.name);
            const ir::TypeId type = unit.machine->constants[i].type;
            if (open && scalar_kind(generation.system.type(type)))
                found.emplace(source.name, NodeConstant{"", paths.at(source.name), type, unit.constants[i]});
        }
    }
    std::map<std::string, int> ends;
    for (const auto& [name, constant] : found) ++ends[constant.path.substr(constant.path.rfind(':') + 1)];
    std::vector<NodeConstant> result;
    for (auto& [name, constant] : found) {
        constant.parameter = parameter_of(constant.path, ends);
        result.push_back(std::move(constant));
    }
    return result;
}

}  // namespace robochart::cpp_emit::ros2
