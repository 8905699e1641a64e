// SPDX-License-Identifier: Apache-2.0
// Builds the declarations of random syntax trees.
#include "tests/random_models/syntax/syntax_builder.hpp"

namespace robochart::random_models {

using namespace frontend;

namespace {
constexpr std::size_t depth_of_expressions = 3;
}

Import SyntaxBuilder::import() {
    Import result;
    result.name = qualified();
    result.wildcard = random_.chance(50);
    return result;
}

void SyntaxBuilder::parameters(std::vector<VariablePtr>& list) {
    for (std::size_t i = random_.below(3); i > 0; --i) list.push_back(variable(DeclKind::parameter, 2));
}

std::unique_ptr<Declaration> SyntaxBuilder::type_declaration() {
    constexpr DeclKind kinds[] = {DeclKind::primitive_type, DeclKind::record_type, DeclKind::enumeration};
    auto type = std::make_unique<TypeDeclaration>(kinds[random_.below(3)]);
    type->name = name();
    if (type->kind == DeclKind::record_type) {
        type->record_keyword = random_.chance(50);
        for (std::size_t i = random_.below(4); i > 0; --i) type->fields.push_back(variable(DeclKind::field, 2));
    }
    if (type->kind == DeclKind::enumeration)
        for (std::size_t i = random_.below(4); i > 0; --i) {
            auto literal = std::make_unique<EnumLiteral>();
            literal->name = name();
            if (random_.chance(30))
                for (std::size_t k = random_.between(1, 2); k > 0; --k) literal->arguments.push_back(this->type(2));
            type->literals.push_back(std::move(literal));
        }
    return type;
}

std::unique_ptr<Declaration> SyntaxBuilder::function() {
    auto function = std::make_unique<Function>();
    function->name = name();
    parameters(function->parameters);
    function->result_expr = type(2);
    for (std::size_t i = random_.below(3); i > 0; --i)
        function->preconditions.push_back(expression(depth_of_expressions));
    for (std::size_t i = random_.below(3); i > 0; --i)
        function->postconditions.push_back(expression(depth_of_expressions));
    return function;
}

void SyntaxBuilder::context(Context& context, bool clauses) {
    if (clauses)
        for (std::size_t i = random_.below(4); i > 0; --i) {
            const auto use = static_cast<InterfaceUse>(random_.below(3));
            context.interfaces.push_back({use, qualified(), nullptr});
        }
    for (std::size_t i = random_.below(3); i > 0; --i) {
        const bool constant = random_.chance(40);
        context.variables.push_back(variable(constant ? DeclKind::constant : DeclKind::variable, depth_of_expressions));
    }
    for (std::size_t i = random_.below(3); i > 0; --i) {
        auto event = std::make_unique<Event>();
        event->name = name();
        event->broadcast = random_.chance(25);
        if (random_.chance(50)) event->type_expr = type(2);
        context.events.push_back(std::move(event));
    }
    for (std::size_t i = random_.below(2); i > 0; --i) {
        context.clocks.push_back(std::make_unique<Clock>());
        context.clocks.back()->name = name();
    }
    for (std::size_t i = random_.below(2); i > 0; --i) {
        auto signature = std::make_unique<OperationSignature>();
        signature->name = name();
        parameters(signature->parameters);
        signature->terminates = random_.chance(40);
        context.signatures.push_back(std::move(signature));
    }
}

// ---------------------------------------------------------------- machines

/// Adds a trigger, the old form of an empty trigger, or a probability.
void SyntaxBuilder::trigger(Transition& transition) {
    const std::size_t way = random_.below(6);
    if (way < 3) transition.trigger = communication(depth_of_expressions, true);
    if (way == 3) transition.legacy_trigger = true;
    if (way == 4) transition.probability = expression(depth_of_expressions);
}

std::unique_ptr<Transition> SyntaxBuilder::transition() {
    auto result = std::make_unique<Transition>();
    result->name = name();
    result->from = simple();
    result->to = simple();
    trigger(*result);
    for (std::size_t i = random_.below(2); i > 0; --i) result->resets.push_back({simple(), nullptr});
    if (random_.chance(25)) result->deadline = expression(2);
    const std::size_t guard = random_.below(3);
    result->otherwise = guard == 1;
    if (guard == 2) result->condition = expression(depth_of_expressions);
    if (random_.chance(50)) result->action = statement(depth_of_expressions);
    return result;
}

std::unique_ptr<State> SyntaxBuilder::node(std::size_t depth) {
    constexpr DeclKind kinds[] = {DeclKind::state, DeclKind::state,    DeclKind::initial,
                                  DeclKind::final, DeclKind::junction, DeclKind::probabilistic};
    auto state = std::make_unique<State>(kinds[random_.below(6)]);
    state->name = name();
    if (state->kind != DeclKind::state) return state;
    for (std::size_t i = random_.below(4); i > 0; --i) {
        Action action;
        action.kind = static_cast<ActionKind>(random_.below(3));
        action.statement = statement(depth_of_expressions);
        state->actions.push_back(std::move(action));
    }
    if (depth > 0 && random_.chance(40)) nodes(*state, depth - 1);
    return state;
}

void SyntaxBuilder::nodes(NodeContainer& container, std::size_t depth) {
    for (std::size_t i = random_.below(4); i > 0; --i) container.nodes.push_back(node(depth));
    for (std::size_t i = random_.below(3); i > 0; --i) container.transitions.push_back(transition());
}

std::unique_ptr<Machine> SyntaxBuilder::machine(DeclKind kind) {
    auto result = std::make_unique<Machine>(kind);
    result->name = name();
    result->has_body = kind == DeclKind::state_machine;
    if (random_.chance(5)) return result;  // sometimes empty
    context(*result, true);
    if (kind == DeclKind::operation) {
        parameters(result->parameters);
        result->terminates = random_.chance(30);
        for (std::size_t i = random_.below(2); i > 0; --i) result->preconditions.push_back(expression(2));
        for (std::size_t i = random_.below(2); i > 0; --i) result->postconditions.push_back(expression(2));
    }
    nodes(*result, 2);
    result->has_body = kind == DeclKind::state_machine || !result->nodes.empty();
    return result;
}

// ---------------------------------------------------------------- components

std::unique_ptr<Context> SyntaxBuilder::platform() {
    auto result = std::make_unique<Context>(DeclKind::platform);
    result->name = name();
    context(*result, true);
    return result;
}

std::unique_ptr<Reference> SyntaxBuilder::reference(DeclKind to) {
    auto result = std::make_unique<Reference>();
    result->name = name();
    result->refers_to = to;
    result->target_name = qualified();
    return result;
}

std::unique_ptr<Connection> SyntaxBuilder::connection() {
    auto result = std::make_unique<Connection>();
    result->from.node = simple();
    result->from.event = simple();
    result->to.node = simple();
    result->to.event = simple();
    result->async = random_.chance(40);
    result->multiple = random_.chance(30);
    return result;
}

std::unique_ptr<Component> SyntaxBuilder::controller() {
    auto result = std::make_unique<Component>(DeclKind::controller);
    result->name = name();
    if (random_.chance(5)) return result;  // sometimes empty
    context(*result, true);
    for (std::size_t i = random_.below(4); i > 0; --i) {
        const std::size_t way = random_.below(4);
        if (way == 0) result->order.push_back(result->machines.emplace_back(machine(DeclKind::state_machine)).get());
        if (way == 1) result->order.push_back(result->operations.emplace_back(machine(DeclKind::operation)).get());
        if (way < 2) continue;
        const DeclKind to = way == 2 ? DeclKind::state_machine : DeclKind::operation;
        result->order.push_back(result->references.emplace_back(reference(to)).get());
    }
    for (std::size_t i = random_.below(3); i > 0; --i) result->connections.push_back(connection());
    return result;
}

std::unique_ptr<Component> SyntaxBuilder::module() {
    auto result = std::make_unique<Component>(DeclKind::module);
    result->name = name();
    for (std::size_t i = random_.below(4); i > 0; --i) {
        const std::size_t way = random_.below(6);
        if (way == 0) result->order.push_back(result->platforms.emplace_back(platform()).get());
        if (way == 1) result->order.push_back(result->controllers.emplace_back(controller()).get());
        if (way == 2) result->order.push_back(result->machines.emplace_back(machine(DeclKind::state_machine)).get());
        if (way < 3) continue;
        constexpr DeclKind kinds[] = {DeclKind::platform, DeclKind::controller, DeclKind::state_machine};
        result->order.push_back(result->references.emplace_back(reference(kinds[way - 3])).get());
    }
    for (std::size_t i = random_.below(3); i > 0; --i) result->connections.push_back(connection());
    return result;
}

std::unique_ptr<Declaration> SyntaxBuilder::declaration() {
    switch (random_.below(10)) {
        case 0:
        case 1:
            return type_declaration();
        case 2:
            return function();
        case 3: {
            auto interface = std::make_unique<Context>(DeclKind::interface);
            interface->name = name();
            context(*interface, false);
            return interface;
        }
        case 4:
            return platform();
        case 5:
        case 6:
            return machine(DeclKind::state_machine);
        case 7:
            return machine(DeclKind::operation);
        case 8:
            return controller();
        default:
            return module();
    }
}

}  // namespace robochart::random_models
