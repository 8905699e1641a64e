// Questions about a System.
#include "semantics/query.hpp"

#include <algorithm>
#include <set>

#include "semantics/visit.hpp"

namespace robochart::ir {
namespace {

const Constant* find_constant(const std::vector<Constant>& constants, const std::string& name) {
    const auto it = std::find_if(constants.begin(), constants.end(), [&](const Constant& c) { return c.name == name; });
    return it == constants.end() ? nullptr : &*it;
}

bool parameters_match(const Machine& operation, const OperationSignature& signature) {
    std::vector<TypeId> types;
    for (const auto& variable : operation.variables)
        if (variable.scope == VariableScope::parameter) types.push_back(variable.type);
    return types == signature.parameters;
}

/// Collects NamedConstants, each name once.
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
    /// The constants of a part that its controller does not provide.
    void add_part(const Controller& controller, const std::string& part, const Machine& machine) {
        for (const auto& constant : machine.constants)
            if (!constant.required || find_constant(controller.constants, constant.name) == nullptr)
                add(controller.package, controller.path + "::" + part, constant);
    }
    std::vector<NamedConstant> take() { return std::move(constants_); }

private:
    std::set<std::string> names_;
    std::vector<NamedConstant> constants_;
};

}  // namespace

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
    return "const_" + name + "_" + constant;
}

ConstantSource constant_source(const System&, const Module* module, const Controller* controller,
                               const std::string& part, const Machine& machine, ConstantId id) {
    const Constant& own = machine.constants.at(id.index);
    if (controller == nullptr) return {constant_name(machine.package, machine.path, own.name), &own};
    const Constant* provided = own.required ? find_constant(controller->constants, own.name) : nullptr;
    if (provided == nullptr)
        return {constant_name(controller->package, controller->path + "::" + part, own.name), &own};
    const auto place = static_cast<std::uint32_t>(provided - controller->constants.data());
    return constant_source(module, *controller, ConstantId{place});
}

ConstantSource constant_source(const Module* module, const Controller& controller, ConstantId id) {
    const Constant& own = controller.constants.at(id.index);
    const bool outside = module != nullptr && own.required;
    const Constant* platform = outside ? find_constant(module->platform.constants, own.name) : nullptr;
    if (platform != nullptr) return {constant_name(module->package, module->name, own.name), platform};
    return {constant_name(controller.package, controller.path, own.name), &own};
}

std::vector<NamedConstant> named_constants(const System& system) {
    ConstantList list;
    for (const auto& machine : system.machines) list.add_all(machine.package, machine.path, machine.constants);
    for (const auto& controller : system.controllers) {
        list.add_all(controller.package, controller.path, controller.constants);
        for (const auto& part : controller.machines) list.add_part(controller, part.name, system.machine(part.machine));
        for (std::size_t i = 0; i < controller.definitions.size(); ++i)
            list.add_part(controller, controller.definition_names.at(i), system.machine(controller.definitions[i]));
    }
    for (const auto& module : system.modules) list.add_all(module.package, module.name, module.platform.constants);
    return list.take();
}

}  // namespace robochart::ir
