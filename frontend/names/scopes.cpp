// SPDX-License-Identifier: Apache-2.0
// Collects what components offer, require and use, from their declarations and interfaces.
#include "frontend/names/scopes.hpp"

#include <algorithm>

namespace robochart::frontend {

const Context* interface_of(const InterfaceClause& clause) {
    return dynamic_cast<const Context*>(clause.target);
}

bool has_unknown_interface(const Context& context) {
    return std::ranges::any_of(context.interfaces,
                               [](const InterfaceClause& clause) { return clause.target == nullptr; });
}

namespace {

template <class Map, class Items>
void add(Map& map, const Items& items) {
    for (const auto& item : items) map.emplace(item->name, &*item);
}

/// Adds the members of an interface. The variables of a provided interface are not visible, because other components
/// use them.
void add_interface(Scope& scope, const Context& interface, InterfaceUse use) {
    if (use != InterfaceUse::provides) add(scope.variables, interface.variables);
    if (use != InterfaceUse::provides) add(scope.clocks, interface.clocks);
    add(scope.events, interface.events);
    add(scope.operations, interface.signatures);
}

template <class Use>
void for_interfaces(const Context& context, Use use) {
    for (const InterfaceClause& clause : context.interfaces)
        if (const Context* interface = interface_of(clause)) use(*interface, clause.use);
}

/// Adds the events that a context of a RoboSim machine declares or uses.
void add_register_events(Scope& scope, const Context* registers) {
    if (registers == nullptr) return;
    add(scope.events, registers->events);
    for_interfaces(*registers, [&](const Context& interface, InterfaceUse use) {
        if (use == InterfaceUse::uses) add(scope.events, interface.events);
    });
}

}  // namespace

Registers registers_of(const Context& owner) {
    Registers result;
    add_register_events(result.inputs, owner.input.get());
    if (owner.input)
        for_interfaces(*owner.input, [&](const Context& interface, InterfaceUse) {
            add(result.inputs.variables, interface.variables);
        });
    if (owner.output) result.outputs = scope_of(*owner.output);
    return result;
}

Scope scope_of(const Context& context) {
    Scope scope;
    if (const auto* machine = dynamic_cast<const Machine*>(&context)) add(scope.variables, machine->parameters);
    add(scope.variables, context.variables);
    add(scope.events, context.events);
    add(scope.clocks, context.clocks);
    add(scope.operations, context.signatures);
    for_interfaces(context, [&](const Context& i, InterfaceUse use) { add_interface(scope, i, use); });
    add_register_events(scope, context.input.get());
    add_register_events(scope, context.output.get());
    return scope;
}

const Declaration* follow_reference(const Declaration* declaration) {
    if (declaration == nullptr || declaration->kind != DeclKind::reference) return declaration;
    return static_cast<const Reference*>(declaration)->target;
}

const Declaration* component_around(const Declaration* declaration) {
    const auto is_part = [](DeclKind kind) {
        return kind == DeclKind::state || kind == DeclKind::initial || kind == DeclKind::final ||
               kind == DeclKind::junction || kind == DeclKind::probabilistic || kind == DeclKind::transition ||
               kind == DeclKind::variable || kind == DeclKind::constant || kind == DeclKind::parameter ||
               kind == DeclKind::operation_signature || kind == DeclKind::event || kind == DeclKind::clock ||
               kind == DeclKind::input_context || kind == DeclKind::output_context;
    };
    while (declaration != nullptr && is_part(declaration->kind)) declaration = declaration->parent;
    return declaration;
}

std::vector<const Variable*> visible_variables(const Context& context) {
    std::vector<const Variable*> result;
    for (const auto& variable : context.variables) result.push_back(variable.get());
    for_interfaces(context, [&](const Context& i, InterfaceUse use) {
        if (use == InterfaceUse::provides) return;
        for (const auto& variable : i.variables) result.push_back(variable.get());
    });
    return result;
}

std::vector<const Variable*> offered_variables(const Context& platform) {
    std::vector<const Variable*> result = visible_variables(platform);
    for_interfaces(platform, [&](const Context& i, InterfaceUse use) {
        if (use != InterfaceUse::provides) return;
        for (const auto& variable : i.variables) result.push_back(variable.get());
    });
    return result;
}

std::vector<const Variable*> required_variables(const Context& context) {
    std::vector<const Variable*> result;
    for_interfaces(context, [&](const Context& i, InterfaceUse use) {
        if (use != InterfaceUse::requires_) return;
        for (const auto& variable : i.variables) result.push_back(variable.get());
    });
    return result;
}

std::vector<const OperationSignature*> required_operations(const Context& context) {
    std::vector<const OperationSignature*> result;
    for_interfaces(context, [&](const Context& i, InterfaceUse use) {
        if (use != InterfaceUse::requires_) return;
        for (const auto& signature : i.signatures) result.push_back(signature.get());
    });
    return result;
}

std::vector<const OperationSignature*> provided_operations(const Context& context) {
    std::vector<const OperationSignature*> result;
    for (const auto& signature : context.signatures) result.push_back(signature.get());
    for_interfaces(context, [&](const Context& i, InterfaceUse use) {
        if (use != InterfaceUse::provides) return;
        for (const auto& signature : i.signatures) result.push_back(signature.get());
    });
    return result;
}

std::vector<const Event*> visible_events(const Context& context) {
    std::vector<const Event*> result;
    for (const auto& event : context.events) result.push_back(event.get());
    for_interfaces(context, [&](const Context& i, InterfaceUse) {
        for (const auto& event : i.events) result.push_back(event.get());
    });
    for (const Context* registers : {context.input.get(), context.output.get()}) {
        if (registers == nullptr) continue;
        for (const auto& event : registers->events) result.push_back(event.get());
        for_interfaces(*registers, [&](const Context& i, InterfaceUse use) {
            if (use != InterfaceUse::uses) return;
            for (const auto& event : i.events) result.push_back(event.get());
        });
    }
    return result;
}

std::vector<const Machine*> defined_operations(const Component& controller) {
    std::vector<const Machine*> result;
    for (const Declaration* part : controller.order) {
        const Declaration* behind = follow_reference(part);
        if (behind != nullptr && behind->kind == DeclKind::operation)
            result.push_back(static_cast<const Machine*>(behind));
    }
    return result;
}

}  // namespace robochart::frontend
