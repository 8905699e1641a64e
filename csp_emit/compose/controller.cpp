// SPDX-License-Identifier: Apache-2.0
// Emits a controller: its channels, its machines, its connections.
#include "csp_emit/compose/controller.hpp"

#include <algorithm>

#include "checker/cspm/syntax/build.hpp"
#include "csp_emit/base/types.hpp"
#include "csp_emit/compose/cycles.hpp"
#include "csp_emit/compose/instantiations.hpp"
#include "csp_emit/machine/machine.hpp"
#include "semantics/ir/query.hpp"

namespace robochart::csp_emit {

namespace b = cspm::build;
using cspm::DeclPtr;
using ir::VariableScope;

namespace {

class ControllerEmitter {
public:
    ControllerEmitter(const ControllerContext& context, Emitted& emitted) : context_(context), emitted_(emitted) {}
    ComponentEmission emit();

private:
    const Project& project() const { return *context_.project; }
    const ir::Controller& controller() const { return *context_.controller; }
    void record_meaning(const std::string& event, EventMeaning meaning) {
        meaning.component = context_.path;
        emitted_.provenance.events[context_.path + "::" + event] = std::move(meaning);
    }
    void declare_channels(std::vector<DeclPtr>& decls);
    void declare_sets(std::vector<DeclPtr>& decls);
    void add_constants();
    void add_constants(bool cycle);
    void add_part(const ir::MachineInstance& instance, std::vector<DeclPtr>& decls);
    std::string constant_argument(const std::string& part, const ConstantParameter& constant);
    std::string part_of(const std::string& instance, const ir::Machine& owner) const;
    ComponentEmission emit_part(const ir::Machine& machine, const std::string& name, std::vector<DeclPtr>& decls);
    void add_operations(std::vector<DeclPtr>& decls);
    void add_connections();

    const ControllerContext& context_;
    Emitted& emitted_;
    Composition composition_;
    std::vector<std::string> visible_;
};

void ControllerEmitter::declare_channels(std::vector<DeclPtr>& decls) {
    decls.push_back(b::channel({"terminate"}));
    record_meaning("terminate", {MeaningKind::terminate, controller().name + " terminates", {}, controller().origin});
    ChannelDeclarations channels(project(), context_.path, emitted_.provenance, decls);
    for (const ir::Event& event : controller().events) channels.declare_event(event);
    for (const ir::OperationSignature& call : leaving_calls(project().system, controller()))
        channels.declare_call(call);
    for (const ir::Variable& variable : controller().variables) {
        channels.declare_variable(variable.name, variable.type, variable.scope == VariableScope::required,
                                  variable.origin);
        composition_.variables.push_back({variable.name, variable.type, variable.scope == VariableScope::required,
                                          variable.scope == VariableScope::required, nullptr});
    }
}

void ControllerEmitter::declare_sets(std::vector<DeclPtr>& decls) {
    b::Exprs visible{b::name("terminate")};
    b::Exprs external;
    for (const ir::Event& event : controller().events) visible.push_back(b::name(event.name));
    for (const auto& call : leaving_calls(project().system, controller()))
        visible.push_back(b::name(call.name + "Call"));
    for (const ir::Variable& variable : controller().variables) {
        if (variable.scope != VariableScope::required) continue;
        external.push_back(b::name("set_EXT_" + variable.name));
        visible.push_back(external.back());
        visible.push_back(b::name("set_" + variable.name));
    }
    for (const auto& channel : visible) visible_.push_back(channel->text);
    decls.push_back(b::value("sem__events", b::productions(visible)));
    decls.push_back(b::value("shared_variable_events", b::productions(external)));
}

void ControllerEmitter::add_constants() {
    for (const bool cycle : {true, false}) add_constants(cycle);  // RoboTool's order
}

void ControllerEmitter::add_constants(bool cycle) {
    for (std::uint32_t i = 0; i < controller().constants.size(); ++i) {
        const ir::Constant& constant = controller().constants[i];
        if ((constant.name == ir::cycle_length) != cycle) continue;
        const std::string name = ir::constant_name(controller().package, controller().path, constant.name);
        const std::string source = ir::constant_source(context_.module, controller(), {i}).name;
        composition_.constants.push_back({name, constant.name, source, nullptr, {i}, constant.type, source});
    }
}

/// Returns the instance that declares a constant: the machine itself, or an operation that it calls.
std::string ControllerEmitter::part_of(const std::string& instance, const ir::Machine& owner) const {
    for (std::size_t i = 0; i < controller().definitions.size(); ++i)
        if (&project().system.machine(controller().definitions[i]) == &owner)
            return controller().definition_names.at(i);
    return instance;
}

/// Returns the controller's parameter for a machine's constant. Adds it if it does not exist yet.
std::string ControllerEmitter::constant_argument(const std::string& part, const ConstantParameter& constant) {
    // if the controller is checked separately, its own parameters replace constants of the platform
    const ir::Machine& owner = *constant.owner;
    const auto source =
        ir::constant_source(project().system, nullptr, &controller(), part_of(part, owner), owner, constant.id);
    const auto known = std::ranges::any_of(composition_.constants,
                                           [&](const ConstantParameter& c) { return c.parameter == source.name; });
    if (!known) {
        ConstantParameter added = constant;
        added.parameter = source.name;
        composition_.constants.push_back(added);
    }
    return source.name;
}

/// Emits a machine in this controller. The controller supplies the definitions of the machine's operations and the
/// elements that the machine requires.
ComponentEmission ControllerEmitter::emit_part(const ir::Machine& machine, const std::string& name,
                                               std::vector<DeclPtr>& decls) {
    MachineContext context;
    context.project = &project();
    context.machine = &machine;
    context.name = name;
    context.path = context_.path + "::" + name;
    context.names = context_.names;
    for (const ir::MachineId id : controller().definitions) context.definitions[project().system.machine(id).name] = id;
    for (const ir::OperationSignature& operation : machine.operations)
        if (const ir::MachineId id = ir::definition_in(project().system, controller(), operation);
            id.is_valid() && !operation.output)
            context.definitions[operation.name] = id;
    const std::string path = context.path;
    ComponentEmission result = emit_machine(std::move(context), emitted_);
    decls.push_back(result.module);
    for (ConstantParameter& constant : result.constants) {
        const ir::Machine& owner = *constant.owner;
        const auto source = ir::constant_source(project().system, context_.module, &controller(), part_of(name, owner),
                                                owner, constant.id);
        const bool provided = source.constant != &owner.constants.at(constant.id.index);
        constant.source = source.name;
        // RoboTool sets the part's constant to the machine's own constant. If a CSP block defines only the part's
        // constant, the block's value is used.
        const auto given = [&](const std::string& constant_name) {
            return context_.given != nullptr && context_.given->contains(constant_name);
        };
        const bool of_part = provided || given(source.name);
        const bool of_machine = !of_part && given(constant.value);
        if (!of_machine)
            constant.value = of_part ? source.name : default_constant(project(), constant.value, source.name);
    }
    emitted_.components[path] = result;
    return result;
}

void ControllerEmitter::add_part(const ir::MachineInstance& instance, std::vector<DeclPtr>& decls) {
    const ir::Machine& machine = project().system.machine(instance.machine);
    Part part;
    part.name = instance.name;
    part.emission = emit_part(machine, instance.name, decls);
    for (const ir::Event& event : machine.events) part.events.push_back(event.name);
    for (const ir::Variable& variable : machine.variables)
        if (variable.scope == VariableScope::required) part.variables.push_back(variable.name);
    const auto defined = [&](const ir::OperationSignature& operation) {
        return std::ranges::any_of(controller().definitions, [&](ir::MachineId id) {
            return project().system.machine(id).name == operation.name;
        });
    };
    for (const ir::OperationSignature& operation : machine.operations)
        if (!defined(operation)) part.calls.push_back(operation.name);
    for (const ConstantParameter& constant : part.emission.constants)
        part.arguments.push_back(constant_argument(instance.name, constant));
    composition_.parts.push_back(std::move(part));
}

/// Emits `C::OP_o`, an operation as a separate process with the controller's definitions, if an assertion or a CSP
/// block mentions it.
void ControllerEmitter::add_operations(std::vector<DeclPtr>& decls) {
    for (std::size_t i = 0; i < controller().definitions.size(); ++i) {
        const ir::Machine& machine = project().system.machine(controller().definitions[i]);
        const std::string name = module_name(machine);
        const std::string path = context_.path + "::" + name;
        if (!project().mentions_component(path)) continue;
        ComponentEmission& emission = emitted_.components[path] = emit_part(machine, name, decls);
        const std::string place = controller().path + "::" + controller().definition_names.at(i);
        std::size_t next = 0;
        for (const ir::Variable& variable : machine.variables) {
            if (variable.scope != VariableScope::parameter) continue;
            const std::string constant = ir::constant_name(controller().package, place, variable.name);
            emission.arguments.at(next++).name = "param_" + constant.substr(std::string("const_").size());
        }
    }
}

void ControllerEmitter::add_connections() {
    const auto place = [](const ir::ConnectionEnd& end) {
        return end.kind == ir::EndKind::part ? std::optional<std::size_t>(end.part) : std::nullopt;
    };
    // Asynchronous connections between machines are treated as synchronous (semantics 3.9).
    for (const ir::Connection& connection : controller().connections)
        connect_ends(composition_, place(connection.from), connection.from.event, place(connection.to),
                     connection.to.event);
}

ComponentEmission ControllerEmitter::emit() {
    composition_.project = &project();
    std::vector<DeclPtr> decls;
    CycleLinks links;
    if (controller().robosim) {
        links = cycle_links(project(), controller());
        visible_ = declare_cycle_channels(project(), context_.path, links, controller().origin, false,
                                          emitted_.provenance, decls);
    } else {
        declare_channels(decls);
        declare_sets(decls);
    }
    add_constants();
    for (const ir::MachineInstance& instance : controller().machines) add_part(instance, decls);
    add_operations(decls);
    if (controller().robosim) {
        define_cycles(composition_, links, decls);
    } else {
        add_connections();
        define_composition(composition_, decls);
    }
    ComponentEmission result;
    result.module = b::module_(context_.name, {}, {}, decls, "controller " + controller().origin.element);
    result.constants = composition_.constants;
    result.visible = visible_;
    result.large = is_large(composition_);
    emitted_.components[context_.path] = result;
    return result;
}

}  // namespace

std::vector<ir::OperationSignature> leaving_calls(const ir::System& system, const ir::Controller& controller) {
    std::vector<ir::OperationSignature> result = controller.operations;
    const auto add = [&](const ir::OperationSignature& operation) {
        const auto same = [&](const auto& other) { return other.name == operation.name; };
        const auto defines = [&](ir::MachineId id) { return system.machine(id).name == operation.name; };
        if (std::ranges::none_of(result, same) && std::ranges::none_of(controller.definitions, defines))
            result.push_back(operation);
    };
    for (const ir::MachineInstance& instance : controller.machines)
        for (const ir::OperationSignature& operation : system.machine(instance.machine).operations) add(operation);
    return result;
}

ComponentEmission emit_controller(const ControllerContext& context, Emitted& emitted) {
    return ControllerEmitter(context, emitted).emit();
}

}  // namespace robochart::csp_emit
