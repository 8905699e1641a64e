// SPDX-License-Identifier: Apache-2.0
// Finds constants whose values come from options of the generator and not from the model.
#include "cpp_emit/files/open_constants.hpp"

#include <algorithm>
#include <map>

#include "cpp_emit/plan/types.hpp"
#include "semantics/ir/numbers.hpp"
#include "semantics/ir/query.hpp"

namespace robochart::cpp_emit {

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

/// Returns the name under which a machine or operation runs in its controller.
std::string name_in(const Surroundings& around, const Unit& unit, const Part& part) {
    if (around.controller == nullptr) return "";
    const ir::Controller& controller = *around.controller;
    if (unit.root) return controller.machines[part.machine].name;
    const auto found = std::ranges::find(controller.definitions, unit.id);
    return controller.definition_names[static_cast<std::size_t>(found - controller.definitions.begin())];
}

/// Returns whether `--const` can set constants of the type.
bool is_settable(const ir::Type& type) {
    switch (type.kind) {
        case ir::TypeKind::boolean:
        case ir::TypeKind::nat:
        case ir::TypeKind::integer:
        case ir::TypeKind::real:
            return true;
        case ir::TypeKind::enumeration:
            return !is_struct(type);
        case ir::TypeKind::string:
        case ir::TypeKind::given:
        case ir::TypeKind::sequence:
        case ir::TypeKind::set:
        case ir::TypeKind::product:
        case ir::TypeKind::record:
        case ir::TypeKind::function:
        case ir::TypeKind::relation:
        case ir::TypeKind::vector:
        case ir::TypeKind::matrix:
        case ir::TypeKind::unit:
            break;
    }
    return false;
}

std::string literal_text(const Generation& generation, const ir::Type& type, const ir::Value& value) {
    if (type.kind == ir::TypeKind::boolean) return value.number != 0 ? "true" : "false";
    if (type.kind == ir::TypeKind::enumeration) return type.labels[static_cast<std::size_t>(value.number)];
    return ir::decimal_text(value.number, type.kind == ir::TypeKind::real ? generation.inst.scale : 1);
}

}  // namespace

std::vector<OpenConstant> open_constants(const Generation& generation) {
    std::map<std::string, std::string> paths;
    for (const ir::NamedConstant& constant : ir::named_constants(generation.system))
        paths.emplace(constant.name, constant.path);
    std::map<std::string, OpenConstant> found;
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
            if (open && is_settable(generation.system.type(type)))
                found.emplace(source.name,
                              OpenConstant{paths.at(source.name), type, unit.constants[i],
                                           literal_text(generation, generation.system.type(type), unit.constants[i])});
        }
    }
    std::vector<OpenConstant> result;
    for (auto& [name, constant] : found) result.push_back(std::move(constant));
    return result;
}

}  // namespace robochart::cpp_emit
