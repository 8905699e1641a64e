// SPDX-License-Identifier: Apache-2.0
// Emits a module. Events and calls of the platform are visible, writes to platform variables are propagated,
// asynchronous connections between controllers are buffers, and termination is hidden.
#include "csp_emit/compose/module.hpp"

#include <algorithm>

#include "checker/cspm/syntax/build.hpp"
#include "csp_emit/base/types.hpp"
#include "csp_emit/compose/controller.hpp"
#include "csp_emit/compose/cycles.hpp"
#include "csp_emit/expressions/expressions.hpp"
#include "semantics/instantiate/instantiate.hpp"
#include "semantics/ir/query.hpp"

namespace robochart::csp_emit {

namespace b = cspm::build;
using cspm::DeclPtr;
using ir::VariableScope;

namespace {

class ModuleEmitter {
public:
    ModuleEmitter(const ModuleContext& context, Emitted& emitted) : context_(context), emitted_(emitted) {}
    ComponentEmission emit();

private:
    const Project& project() const { return *context_.project; }
    const ir::Module& module() const { return *context_.module; }
    const ir::Platform& platform() const { return module().platform; }
    void declare_channels(std::vector<DeclPtr>& decls);
    void declare_variables(std::vector<DeclPtr>& decls);
    void declare_sets(std::vector<DeclPtr>& decls);
    std::vector<ir::OperationSignature> calls_of_platform() const;
    void add_constants();
    void add_constants(bool cycle);
    void add_part(const ir::ControllerInstance& instance, std::vector<DeclPtr>& decls);
    std::string constant_argument(const ir::Controller& controller, const ConstantParameter& constant);
    void add_connection(const ir::Connection& connection);

    const ModuleContext& context_;
    Emitted& emitted_;
    Composition composition_;
    std::vector<std::string> visible_;
};

std::vector<ir::OperationSignature> ModuleEmitter::calls_of_platform() const {
    std::vector<ir::OperationSignature> result;
    for (const ir::ControllerInstance& instance : module().controllers)
        for (const auto& call : leaving_calls(project().system, project().system.controller(instance.controller))) {
            const auto same = [&](const auto& other) { return other.name == call.name; };
            if (std::ranges::none_of(result, same)) result.push_back(call);
        }
    return result;
}

void ModuleEmitter::declare_channels(std::vector<DeclPtr>& decls) {
    decls.push_back(b::channel({"terminate"}));
    emitted_.provenance.events[context_.path + "::terminate"] = {
        MeaningKind::terminate, module().name + " terminates", {}, module().origin, context_.path};
    ChannelDeclarations channels(project(), context_.path, emitted_.provenance, decls);
    for (const ir::Event& event : platform().events) channels.declare_event(event);
    for (const ir::OperationSignature& call : calls_of_platform()) channels.declare_call(call);
}

/// Declares the platform's variables. Writes to provided variables are visible to the platform. An explicit initial
/// value is propagated to the controllers at the start.
void ModuleEmitter::declare_variables(std::vector<DeclPtr>& decls) {
    ChannelDeclarations channels(project(), context_.path, emitted_.provenance, decls);
    for (const ir::Variable& variable : platform().variables) {
        channels.declare_variable(variable.name, variable.type, false, variable.origin);
        SharedVariable shared{variable.name, variable.type, false, variable.scope == VariableScope::required, nullptr};
        if (variable.initial) {
            const auto value =
                ir::evaluate_constant(project().system, project().instantiation, nullptr, *variable.initial);
            if (value)
                shared.pushed = value_literal(project(), variable.type, *value);
            else
                project().report_unsupported("the initial value of " + variable.name, variable.origin.span);
        }
        composition_.variables.push_back(shared);
    }
}

void ModuleEmitter::declare_sets(std::vector<DeclPtr>& decls) {
    b::Exprs visible;
    for (const ir::Event& event : platform().events) visible.push_back(b::name(event.name));
    for (const ir::OperationSignature& call : calls_of_platform()) visible.push_back(b::name(call.name + "Call"));
    for (const ir::Variable& variable : platform().variables)
        if (variable.scope == VariableScope::required) visible.push_back(b::name("set_" + variable.name));
    for (const auto& channel : visible) visible_.push_back(channel->text);
    decls.push_back(b::value("sem__events", b::productions(visible)));
}

void ModuleEmitter::add_constants() {
    for (const bool cycle : {true, false}) add_constants(cycle);  // RoboTool's order
}

void ModuleEmitter::add_constants(bool cycle) {
    for (std::uint32_t i = 0; i < platform().constants.size(); ++i) {
        const ir::Constant& constant = platform().constants[i];
        if ((constant.name == ir::cycle_length) != cycle) continue;
        const std::string name = ir::constant_name(module().package, module().name, constant.name);
        composition_.constants.push_back({name, constant.name, name, nullptr, {i}, constant.type});
    }
}

/// Returns the module's parameter for a controller's constant: the platform's constant if the controller requires it.
std::string ModuleEmitter::constant_argument(const ir::Controller& controller, const ConstantParameter& constant) {
    std::string name = constant.parameter;
    const bool own = constant.owner == nullptr && controller.constants.at(constant.id.index).required;
    const auto provided = [&](const ir::Constant& c) { return c.name == constant.constant; };
    if (own && std::ranges::any_of(platform().constants, provided))
        name = ir::constant_name(module().package, module().name, constant.constant);
    const auto same = [&](const ConstantParameter& c) { return c.parameter == name; };
    if (std::ranges::none_of(composition_.constants, same)) {
        composition_.constants.push_back(constant);
        composition_.constants.back().parameter = name;
    }
    return name;
}

void ModuleEmitter::add_part(const ir::ControllerInstance& instance, std::vector<DeclPtr>& decls) {
    const ir::Controller& controller = project().system.controller(instance.controller);
    ControllerContext context{&project(),     &controller, instance.name, context_.path + "::" + instance.name,
                              context_.names, &module(),   context_.given};
    Part part;
    part.name = instance.name;
    part.emission = emit_controller(context, emitted_);
    decls.push_back(part.emission.module);
    for (const ir::Event& event : controller.events) part.events.push_back(event.name);
    for (const ir::Variable& variable : controller.variables)
        if (variable.scope == VariableScope::required) part.variables.push_back(variable.name);
    for (const auto& call : leaving_calls(project().system, controller)) part.calls.push_back(call.name);
    for (const ConstantParameter& constant : part.emission.constants)
        part.arguments.push_back(constant_argument(controller, constant));
    composition_.parts.push_back(std::move(part));
}

void ModuleEmitter::add_connection(const ir::Connection& connection) {
    const auto place = [](const ir::ConnectionEnd& end) {
        return end.kind == ir::EndKind::part ? std::optional<std::size_t>(end.part) : std::nullopt;
    };
    const auto from = place(connection.from);
    const auto to = place(connection.to);
    // Connections with the platform synchronise with the environment even if they are declared `_async`.
    if (!connection.async || !from || !to) {
        connect_ends(composition_, from, connection.from.event, to, connection.to.event);
        return;
    }
    const auto& writer = project().system.controller(module().controllers.at(*from).controller);
    const auto event =
        std::ranges::find_if(writer.events, [&](const ir::Event& e) { return e.name == connection.from.event; });
    Buffer buffer{*from, *to, connection.from.event, connection.to.event, {}};
    if (event != writer.events.end() && event->type) buffer.type = *event->type;
    const auto keep = [&](std::size_t part, const std::string& name) {
        composition_.targets[{part, name}].push_back({composition_.parts[part].name + "::" + name, false});
    };
    keep(*from, connection.from.event);
    keep(*to, connection.to.event);
    composition_.buffers.push_back(buffer);
}

ComponentEmission ModuleEmitter::emit() {
    composition_.project = &project();
    composition_.hides_termination = true;
    std::vector<DeclPtr> decls;
    CycleLinks links;
    if (module().robosim) {
        links = cycle_links(project(), module());
        visible_ =
            declare_cycle_channels(project(), context_.path, links, module().origin, true, emitted_.provenance, decls);
    } else {
        declare_channels(decls);
        declare_variables(decls);
        declare_sets(decls);
    }
    add_constants();
    for (const ir::ControllerInstance& instance : module().controllers) add_part(instance, decls);
    if (module().robosim) {
        define_cycles(composition_, links, decls);
    } else {
        for (const ir::Connection& connection : module().connections) add_connection(connection);
        define_composition(composition_, decls);
    }
    ComponentEmission result;
    result.module = b::module_(module().name, {}, {}, decls, "module " + module().origin.element);
    result.constants = composition_.constants;
    result.visible = visible_;
    result.large = is_large(composition_);
    emitted_.components[context_.path] = result;
    return result;
}

}  // namespace

ComponentEmission emit_module(const ModuleContext& context, Emitted& emitted) {
    return ModuleEmitter(context, emitted).emit();
}

}  // namespace robochart::csp_emit
