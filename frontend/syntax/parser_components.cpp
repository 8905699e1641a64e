// SPDX-License-Identifier: Apache-2.0
// Members of contexts, controllers, modules, references, connections (RoboChart.xtext: ControllerDef, RCModule).
#include <fmt/format.h>

#include "frontend/syntax/parser.hpp"
#include "frontend/syntax/syntax_rules.hpp"

namespace robochart::frontend {

/// Parses a member that the grammar allows in any context, or that a rule (STM6, C7, C9, RP3) rejects there.
bool Parser::context_member(Context& context) {
    if (at("uses") || at("requires") || at("provides")) return interface_clause(context), true;
    if (at("var") || at("const")) return variable_list(context), true;
    if (at("event") || at("_broadcast")) return event(context), true;
    if (at("clock")) return clock(context), true;
    if (peek().kind == TokenKind::identifier && peek(1).is("(")) return operation_signature(context), true;
    return false;
}

/// RoboChart.xtext allows one name after each keyword; old models have lists.
void Parser::interface_clause(Context& context) {
    InterfaceClause clause;
    clause.use = at("uses") ? InterfaceUse::uses : at("requires") ? InterfaceUse::requires_ : InterfaceUse::provides;
    advance();
    const std::string_view word = previous().text;
    for (;;) {
        clause.name = qualified_name("the name of an interface");
        if (clause.name.parts.front().starts_with('?')) lost_declarations_ = true;  // its members are unknown, too
        context.interfaces.push_back(clause);
        if (!at(",")) return;
        const Token next = peek(1);
        if (next.is("uses") || next.is("requires") || next.is("provides"))
            return pass_superfluous("members are not separated by anything");
        old_list(peek().span, word);
        advance();
    }
}

/// Old models name several interfaces in one clause.
void Parser::old_list(Span comma, std::string_view word) {
    inserted_ = nullptr;
    out_.report(syntax::legacy_list, comma, {std::string(word)})
        .fixes.push_back({comma, " " + std::string(word), "write"});
}

void Parser::variable_list(Context& context) {
    const DeclKind kind = at("var") ? DeclKind::variable : DeclKind::constant;
    advance();
    do variable(context.variables, kind);
    while (accept(","));
}

void Parser::event(Context& context) {
    auto owned = std::make_unique<Event>();
    Event& event = *owned;
    event.span = peek().span;
    event.broadcast = accept("_broadcast");
    expect("event");
    name(event);
    context.events.push_back(std::move(owned));
    if (at("(")) bracketed_event(event);
    if (accept(":")) event.type_expr = type();
    event.span = since(event.span);
}

void Parser::clock(Context& context) {
    auto clock = std::make_unique<Clock>();
    clock->span = expect("clock");
    name(*clock);
    clock->span = since(clock->span);
    clock_with_value();
    context.clocks.push_back(std::move(clock));
}

void Parser::operation_signature(Context& context) {
    auto signature = std::make_unique<OperationSignature>();
    signature->span = peek().span;
    name(*signature);
    signature->parameters = parameters();
    if (accept("[")) {
        expect("terminates");
        expect("]");
        signature->terminates = true;
    }
    signature->span = since(signature->span);
    context.signatures.push_back(std::move(signature));
}

// ---------------------------------------------------------------- controllers and modules

std::unique_ptr<Component> Parser::controller() {
    auto controller = std::make_unique<Component>(DeclKind::controller);
    controller->span = expect("controller");
    name(*controller);
    guarded([&] { braces([&] { controller_member(*controller); }, context_members | controller_members); });
    controller->span = since(controller->span);
    return controller;
}

/// Parses `stm …` or a reference as a part of a component.
bool Parser::machine_part(Component& component) {
    if (at("stm")) {
        component.machines.push_back(watched([&] { return machine(); }));
        component.order.push_back(component.machines.back().get());
        return true;
    }
    if (!at("sref") && !at("opref") && !at("cref") && !at("rref")) return false;
    component.references.push_back(reference());
    component.order.push_back(component.references.back().get());
    return true;
}

void Parser::controller_member(Component& component) {
    const bool wrong_reference = at("cref") || at("rref");
    if (context_member(component)) return;
    if (at("connection")) return component.connections.push_back(connection());
    if (at("operation")) {
        component.operations.push_back(watched([&] { return operation(); }));
        component.order.push_back(component.operations.back().get());
        return;
    }
    if (neural_construct()) return;
    if (wrong_reference || !machine_part(component)) wrong_word("a member of a controller", {ForeignPlace::member});
}

std::unique_ptr<Component> Parser::module() {
    auto module = std::make_unique<Component>(DeclKind::module);
    module->span = expect("module");
    name(*module);
    guarded([&] { braces([&] { module_member(*module); }, module_members); });
    module->span = since(module->span);
    return module;
}

void Parser::module_member(Component& component) {
    if (at("connection")) return component.connections.push_back(connection());
    if (at("robotic")) {
        component.platforms.push_back(watched([&] { return platform(); }));
        component.order.push_back(component.platforms.back().get());
        return;
    }
    if (at("controller")) {
        component.controllers.push_back(watched([&] { return controller(); }));
        component.order.push_back(component.controllers.back().get());
        return;
    }
    if (neural_construct()) return;
    if (at("opref") || !machine_part(component))
        wrong_word("a platform, controller, reference or connection of the module", {ForeignPlace::member});
}

std::unique_ptr<Reference> Parser::reference() {
    auto reference = std::make_unique<Reference>();
    reference->refers_to = at("sref")   ? DeclKind::state_machine
                           : at("cref") ? DeclKind::controller
                           : at("rref") ? DeclKind::platform
                                        : DeclKind::operation;
    reference->span = advance().span;
    name(*reference);
    if (at(":") && peek(1).kind == TokenKind::identifier) {
        const Span colon = peek().span;
        diagnostics::Diagnostic* const finding =
            report(syntax::other_notation, colon, {":", "what a reference refers to stands behind `=`"});
        if (finding != nullptr) finding->fixes.push_back({colon, "=", "write"});
        quiet_until_ = 0;
        tokens_.correct(at_, TokenKind::symbol, "=");
    }
    expect("=");
    reference->target_name = qualified_name("the name of what is referred to");
    reference->span = since(reference->span);
    return reference;
}

void Parser::connection_end(Connection::End& end) {
    end.node = plain_name("the name of a component");
    expect("on");
    end.event = plain_name("the name of an event");
}

std::unique_ptr<Connection> Parser::connection() {
    auto connection = std::make_unique<Connection>();
    connection->span = expect("connection");
    connection_end(connection->from);
    expect("to");
    connection_end(connection->to);
    if (accept("(")) {
        (void)correct_word({"_async"});
        expect("_async");
        expect(")");
        connection->async = true;
    } else if (bare_async()) {
        connection->async = true;
    }
    if (accept("[")) {
        expect("mult");
        expect("]");
        connection->multiple = true;
    }
    connection->span = since(connection->span);
    return connection;
}

}  // namespace robochart::frontend
