// SPDX-License-Identifier: Apache-2.0
// Parses members of contexts, controllers and modules, references, and connections (RoboChart.xtext: ControllerDef,
// RCModule).
#include <fmt/format.h>

#include "frontend/syntax/parser.hpp"
#include "frontend/syntax/syntax_rules.hpp"

namespace robochart::frontend {

/// Parses a member that the grammar allows in every context. Rules (STM6, C7, C9, RP3) reject some of them later.
bool Parser::context_member(Context& context) {
    if (at_token("uses") || at_token("requires") || at_token("provides"))
        interface_clause(context);
    else if (at_token("var") || at_token("const"))
        variable_list(context);
    else if (at_token("event") || at_token("_broadcast"))
        parse_event(context);
    else if (at_token("clock"))
        parse_clock(context);
    else if (peek().kind == TokenKind::identifier && peek(1).is_word("("))
        operation_signature(context);
    else
        return robosim_member(context);
    return true;
}

/// Parses an interface clause. RoboChart.xtext allows one name after the keyword, but old models have lists.
void Parser::interface_clause(Context& context) {
    InterfaceClause clause;
    clause.use = InterfaceUse::provides;
    if (at_token("uses")) clause.use = InterfaceUse::uses;
    if (at_token("requires")) clause.use = InterfaceUse::requires_;
    advance_token();
    const std::string_view word = previous_token().text;
    for (;;) {
        clause.name = qualified_name("the name of an interface");
        // The members of this interface are unknown too.
        if (clause.name.parts.front().starts_with('?')) lost_declarations_ = true;
        context.interfaces.push_back(clause);
        if (!at_token(",")) return;
        const Token next = peek(1);
        if (next.is_word("uses") || next.is_word("requires") || next.is_word("provides"))
            return pass_superfluous("members need no separator");
        old_list(peek().span, word);
        advance_token();
    }
}

/// Reports several interfaces in one clause, as old models have them.
void Parser::old_list(Span comma, std::string_view word) {
    inserted_ = nullptr;
    out_.report(syntax::legacy_list, comma, {std::string(word)})
        .fixes.push_back({comma, " " + std::string(word), "write"});
}

void Parser::variable_list(Context& context) {
    const DeclKind kind = at_token("var") ? DeclKind::variable : DeclKind::constant;
    advance_token();
    do parse_variable(context.variables, kind);
    while (accept_token(","));
}

void Parser::parse_event(Context& context) {
    auto owned = std::make_unique<Event>();
    Event& event = *owned;
    event.span = peek().span;
    if (at_token("_broadcast"))
        refuse_robochart(peek().span, "_broadcast", "an event is a register, which every connected component can read");
    event.broadcast = accept_token("_broadcast");
    expect_token("event");
    name(event);
    context.events.push_back(std::move(owned));
    if (at_token("(")) bracketed_event(event);
    if (accept_token(":")) event.type_expr = parse_type();
    event.span = span_since(event.span);
}

void Parser::parse_clock(Context& context) {
    auto clock = std::make_unique<Clock>();
    clock->span = expect_token("clock");
    name(*clock);
    clock->span = span_since(clock->span);
    clock_with_value();
    context.clocks.push_back(std::move(clock));
}

void Parser::operation_signature(Context& context) {
    auto signature = std::make_unique<OperationSignature>();
    signature->span = peek().span;
    name(*signature);
    signature->parameters = parse_parameters();
    if (accept_token("[")) {
        expect_token("terminates");
        expect_token("]");
        signature->terminates = true;
    }
    signature->span = span_since(signature->span);
    context.signatures.push_back(std::move(signature));
}

// ---------------------------------------------------------------- controllers and modules

std::unique_ptr<Component> Parser::parse_controller() {
    auto controller = std::make_unique<Component>(DeclKind::controller);
    controller->dialect = dialect_;
    controller->span = expect_token("controller");
    name(*controller);
    catch_syntax_error(
        [&] { parse_braces([&] { controller_member(*controller); }, context_members | controller_members); });
    controller->span = span_since(controller->span);
    return controller;
}

/// Parses `stm …` or a reference as a part of a component.
bool Parser::machine_part(Component& component) {
    if (at_token("stm")) {
        component.machines.push_back(note_failures([&] { return parse_machine(); }));
        component.order.push_back(component.machines.back().get());
        return true;
    }
    if (!at_token("sref") && !at_token("opref") && !at_token("cref") && !at_token("rref")) return false;
    component.references.push_back(parse_reference());
    component.order.push_back(component.references.back().get());
    return true;
}

void Parser::controller_member(Component& component) {
    const bool wrong_reference = at_token("cref") || at_token("rref");
    if (context_member(component)) return;
    if (at_token("connection")) return component.connections.push_back(parse_connection());
    if (at_token("operation")) {
        component.operations.push_back(note_failures([&] { return parse_operation(); }));
        component.order.push_back(component.operations.back().get());
        return;
    }
    if (neural_construct()) return;
    if (wrong_reference || !machine_part(component)) wrong_word("a member of a controller", {ForeignPlace::member});
}

std::unique_ptr<Component> Parser::parse_module() {
    auto module = std::make_unique<Component>(DeclKind::module);
    module->dialect = dialect_;
    module->span = expect_token("module");
    name(*module);
    catch_syntax_error([&] { parse_braces([&] { module_member(*module); }, module_members); });
    module->span = span_since(module->span);
    return module;
}

void Parser::module_member(Component& component) {
    if (at_token("connection")) return component.connections.push_back(parse_connection());
    if (robosim_member(component)) return;
    if (at_token("robotic")) {
        component.platforms.push_back(note_failures([&] { return parse_platform(); }));
        component.order.push_back(component.platforms.back().get());
        return;
    }
    if (at_token("controller")) {
        component.controllers.push_back(note_failures([&] { return parse_controller(); }));
        component.order.push_back(component.controllers.back().get());
        return;
    }
    if (neural_construct()) return;
    if (at_token("opref") || !machine_part(component))
        wrong_word("a platform, controller, reference or connection of the module", {ForeignPlace::member});
}

std::unique_ptr<Reference> Parser::parse_reference() {
    auto reference = std::make_unique<Reference>();
    reference->refers_to = DeclKind::operation;
    if (at_token("sref")) reference->refers_to = DeclKind::state_machine;
    if (at_token("cref")) reference->refers_to = DeclKind::controller;
    if (at_token("rref")) reference->refers_to = DeclKind::platform;
    reference->span = advance_token().span;
    name(*reference);
    if (at_token(":") && peek(1).kind == TokenKind::identifier) {
        const Span colon = peek().span;
        diagnostics::Diagnostic* const finding =
            report(syntax::other_notation, colon, {":", "the target of a reference is written after `=`"});
        if (finding != nullptr) finding->fixes.push_back({colon, "=", "write"});
        quiet_until_ = 0;
        tokens_.correct_token(at_, TokenKind::symbol, "=");
    }
    expect_token("=");
    reference->target_name = qualified_name("the name of the target");
    reference->span = span_since(reference->span);
    return reference;
}

void Parser::connection_end(Connection::End& end) {
    end.node = plain_name("the name of a component");
    expect_token("on");
    end.event = plain_name("the name of an event");
}

std::unique_ptr<Connection> Parser::parse_connection() {
    auto connection = std::make_unique<Connection>();
    connection->span = expect_token("connection");
    connection_end(connection->from);
    expect_token("to");
    connection_end(connection->to);
    if (accept_token("(")) {
        (void)correct_word({"_async"});
        expect_token("_async");
        expect_token(")");
        connection->async = true;
    } else if (bare_async()) {
        connection->async = true;
    }
    if (accept_token("[")) {
        expect_token("mult");
        expect_token("]");
        connection->multiple = true;
    }
    connection->span = span_since(connection->span);
    return connection;
}

}  // namespace robochart::frontend
