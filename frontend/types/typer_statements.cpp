// SPDX-License-Identifier: Apache-2.0
// Resolves names and computes types in statements and communications.
#include <fmt/format.h>

#include "frontend/rules/rules.hpp"
#include "frontend/syntax/print.hpp"
#include "frontend/types/typer.hpp"

namespace robochart::frontend {

void Typer::check_statement(Stmt& statement, Surroundings& around) {
    switch (statement.kind) {
        case StmtKind::if_then_else: {
            const TypePtr condition = assign_type(statement.condition, around);
            if (condition && !is_compatible(condition, make_type(TypeForm::boolean)))
                finder_.out().report(rules::if_type, statement.condition->span, {to_string(condition)});
            break;
        }
        case StmtKind::assignment:
            return check_assignment(statement, around);
        case StmtKind::communication:
            return check_communication(*statement.communication, around, false);
        case StmtKind::call:
            return check_call(statement, around);
        case StmtKind::wait:
            return check_wait(statement.value, around);
        case StmtKind::wait_interval:
            check_wait(statement.value, around);
            return check_wait(statement.upper, around);
        case StmtKind::clock_reset:
            statement.declaration = find_clock(statement.name, around, rules::ts1);
            return;
        case StmtKind::deadline: {
            const TypePtr bound = simplify_type(assign_type(statement.value, around));
            if (bound && !is_compatible(bound, make_type(TypeForm::real)))
                finder_.out().report(rules::deadline_type, statement.value->span, {to_string(bound)});
            break;
        }
        case StmtKind::skip:
        case StmtKind::exec:
        case StmtKind::sequence:
        case StmtKind::parenthesised:
        case StmtKind::error:
            break;
    }
    for (const StmtPtr& inner : statement.body) this->check_statement(*inner, around);
}

void Typer::check_wait(const ExprPtr& duration, Surroundings& around) {
    const TypePtr type = simplify_type(this->assign_type(duration, around));
    const TypePtr whole = make_type(TypeForm::integer);
    if (type && !is_compatible(type, whole) && !is_compatible(type, make_type(TypeForm::set, {whole})))
        finder_.out().report(rules::wait_type, duration->span, {to_string(type)});
}

/// True for `C = 0` and `reset(C)` if C is a clock and not a variable, so that the author probably means `#C`.
bool Typer::resets_clock(const Stmt& statement, const Expr& named, std::string_view what, Surroundings& around) {
    const bool plain = named.kind == ExprKind::name && named.name.parts.size() == 1;
    if (!plain || around.scope == nullptr) return false;
    const std::string& name = named.name.parts.front();
    const auto clock = around.scope->clocks.find(name);
    if (clock == around.scope->clocks.end() || around.scope->variables.contains(name)) return false;
    const Declaration* component = component_around(around.place.inside);
    const std::string where = component != nullptr ? fmt::format("in `{}`", component->name) : "here";
    const QualifiedName& missing = statement.kind == StmtKind::call ? statement.name : named.name;
    auto& finding = finder_.report_unknown(missing, what, where, {});
    finding.notes.push_back({clock->second->name_span, fmt::format("write `#{}` to reset a clock", name)});
    finding.fixes = {{statement.span, "#" + name, "write"}};
    return true;
}

void Typer::check_assignment(Stmt& statement, Surroundings& around) {
    if (resets_clock(statement, *statement.target, "variable", around)) return;
    const Expr* root = statement.target.get();
    while ((root->kind == ExprKind::member || root->kind == ExprKind::index) && root->args[0])
        root = root->args[0].get();
    written_ = root->kind == ExprKind::register_ ? root : nullptr;
    const TypePtr target = assign_type(statement.target, around);
    written_ = nullptr;
    const TypePtr value = assign_type(statement.value, around);
    const Declaration* assigned = root->target;
    if (assigned != nullptr && assigned->kind == DeclKind::parameter) {
        finder_.out()
            .report(rules::parameter_assigned, statement.span, {assigned->name})
            .notes.push_back({assigned->name_span, "the parameter is declared here"});
    } else if (assigned != nullptr && assigned->kind != DeclKind::variable) {
        finder_.out()
            .report(rules::not_assignable, statement.span, {assigned->name, std::string(to_text(assigned->kind))})
            .notes.push_back({assigned->name_span, "it is declared here"});
    }
    if (!target || !value || is_compatible(value, target)) return;
    auto& finding = finder_.out().report(rules::assignment_type, statement.value->span,
                                         {to_text(*statement.target), to_string(target), to_string(value)});
    if (assigned != nullptr)
        finding.notes.push_back({assigned->name_span, fmt::format("`{}` is declared here", assigned->name)});
}

void Typer::check_call(Stmt& statement, Surroundings& around) {
    const std::string& called = statement.name.parts.back();
    const bool known = around.scope != nullptr && around.scope->operations.contains(called);
    const bool resets = (called == "reset" || called == "restart") && statement.args.size() == 1;
    if (!known && resets && resets_clock(statement, *statement.args.front(), "operation", around)) return;
    for (const ExprPtr& arg : statement.args) assign_type(arg, around);
    if (around.scope == nullptr) return;
    if (!find_output_operation(statement, around)) {
        const auto found = around.scope->operations.find(statement.name.parts.back());
        if (found == around.scope->operations.end() || !finder_.names().is_qualified_by(statement.name, *found->second))
            return unknown_operation(statement, around);
        statement.declaration = found->second;
    }
    const auto& signature = static_cast<const OperationSignature&>(*statement.declaration);
    const std::size_t expected = signature.parameters.size();
    if (statement.args.size() != expected) {
        finder_.out()
            .report(rules::call_count, statement.span,
                    {signature.name, std::to_string(expected), plural(expected), std::to_string(statement.args.size())})
            .notes.push_back({signature.name_span, "the operation is declared here"});
        return;
    }
    for (std::size_t i = 0; i < expected; ++i) {
        const TypePtr& formal = signature.parameters[i]->type;
        const TypePtr& actual = statement.args[i]->type;
        if (actual && formal && !is_compatible(actual, formal))
            finder_.out()
                .report(rules::call_type, statement.args[i]->span,
                        {std::to_string(i + 1), signature.name, to_string(formal), to_string(actual)})
                .notes.push_back({signature.parameters[i]->name_span, "the parameter is declared here"});
    }
}

/// Reports a call of an unknown operation. Only the signatures that the component requires are visible to a call, so
/// the message names the component that should require the operation.
void Typer::unknown_operation(const Stmt& statement, Surroundings& around) {
    const Declaration* component = component_around(around.place.inside);
    const std::string where = component != nullptr ? fmt::format("required by `{}`", component->name) : "here";
    const Missing missing = this->find_missing(statement.name.parts.back(), DeclKind::operation_signature, around);
    if (missing.reported) return;
    auto& finding =
        finder_.report_unknown(statement.name, "operation", where, finder_.keys_of(around.scope->operations));
    if (finder_.out().error_count() > diagnostics::Diagnostics::max_kept) return;
    const std::string& name = statement.name.parts.back();
    if (const auto event = around.scope->events.find(name); event != around.scope->events.end()) {
        const std::string value = event->second->type_expr ? "!v" : "";
        finding.notes.push_back(
            {event->second->name_span, fmt::format("`{0}` is an event: it is sent by `{0}{1}`", name, value)});
        return;
    }
    if (missing.interface != nullptr) return note_missing(missing, "requires", name, finding);
    if (const Declaration* defined = finder_.names().find_anywhere(name, {DeclKind::operation}))
        finding.notes.push_back(
            {defined->name_span, "it is defined here, but only operations of a required interface can be called"});
}

// ---------------------------------------------------------------- communications

const Event* Typer::find_event(Communication& communication, Surroundings& around) {
    if (around.scope == nullptr) return nullptr;
    if (communication.through_register) return output_event(communication, around);
    const auto found = around.scope->events.find(communication.event.parts.back());
    if (found != around.scope->events.end()) return found->second;
    unknown_event(communication, around);
    return nullptr;
}

void Typer::unknown_event(const Communication& communication, Surroundings& around) {
    const Declaration* component = component_around(around.place.inside);
    const std::string where = component != nullptr ? fmt::format("of `{}`", component->name) : "here";
    const Missing missing = this->find_missing(communication.event.parts.back(), DeclKind::event, around);
    if (missing.reported) return;
    auto& finding = finder_.report_unknown(communication.event, "event", where, finder_.keys_of(around.scope->events));
    const std::string& name = communication.event.parts.back();
    if (around.scope->operations.contains(name)) {
        finding.notes.push_back({{}, fmt::format("`{0}` is an operation: it is called by `{0}()`", name)});
        return;
    }
    if (missing.interface != nullptr) return note_missing(missing, "uses", name, finding);
    const auto* outer = component != nullptr ? dynamic_cast<const Context*>(component->parent) : nullptr;
    if (outer == nullptr) return;
    for (const Event* event : visible_events(*outer))
        if (event->name == communication.event.parts.back()) {
            finding.notes.push_back(
                {event->name_span,
                 fmt::format("`{}` has one; its parts declare their own and are connected to it", outer->name)});
            return;
        }
}

Typer::Missing Typer::find_missing(std::string_view name, DeclKind kind, const Surroundings& around) {
    const auto* component = dynamic_cast<const Context*>(component_around(around.place.inside));
    if (component == nullptr || finder_.out().error_count() > diagnostics::Diagnostics::max_kept) return {};
    if (has_unknown_interface(*component)) return {true, nullptr};
    const Context* const interface = finder_.names().interface_with(name, kind);
    if (interface == nullptr || interface == component) return {};
    return {!finder_.first_missing(component, interface), interface};
}

void Typer::note_missing(const Missing& missing, std::string_view clause, std::string_view name,
                         diagnostics::Diagnostic& finding) const {
    const Context& interface = *missing.interface;
    const std::string full = finder_.names().full_name(&interface);
    finding.notes.push_back(
        {interface.name_span, fmt::format("interface `{}` declares `{}`; `{} {}` makes its declarations visible",
                                          interface.name, name, clause, full)});
}

const Variable* Typer::stored_into(const QualifiedName& name, Surroundings& around) {
    if (around.scope == nullptr) return nullptr;
    const auto found = around.scope->variables.find(name.parts.back());
    if (found != around.scope->variables.end() && finder_.names().is_qualified_by(name, *found->second)) {
        const Variable& variable = *found->second;
        if (variable.kind == DeclKind::parameter)
            finder_.out().report(rules::parameter_assigned, name.span, {variable.name});
        else if (variable.kind != DeclKind::variable)
            finder_.out().report(rules::not_assignable, name.span,
                                 {variable.name, std::string(to_text(variable.kind))});
        return &variable;
    }
    const Declaration* component = component_around(around.place.inside);
    const Missing missing = this->find_missing(name.parts.back(), DeclKind::variable, around);
    if (missing.reported) return nullptr;
    auto& finding =
        finder_.report_unknown(name, "variable", component != nullptr ? "in `" + component->name + "`" : "here",
                               finder_.keys_of(around.scope->variables));
    if (missing.interface != nullptr) note_missing(missing, "requires", name.parts.back(), finding);
    return nullptr;
}

void Typer::check_communication(Communication& communication, Surroundings& around, bool) {
    const Event* event = this->find_event(communication, around);
    communication.event_target = event;
    if (!communication.from_variable.empty())
        communication.from_target = stored_into(communication.from_variable, around);
    if (communication.predicate) check_boolean(communication.predicate, around, "what stands in `[| |]`");
    if (communication.kind == CommKind::input)
        communication.variable_target = stored_into(communication.variable, around);
    if (communication.value) assign_type(communication.value, around);
    if (event != nullptr) check_communicated(communication, *event, around);
}

/// Checks that the variable can store the values of the event. RoboTool checks compat(variable, event), which allows
/// narrowing. This check also allows a wider variable, which is safer.
void Typer::check_received(const Communication& communication, const Event& event) {
    const auto* variable = static_cast<const Variable*>(communication.variable_target);
    if (variable == nullptr || !variable->type || is_compatible(event.type, variable->type)) return;
    const bool narrows = is_compatible(variable->type, event.type);
    finder_.out()
        .report(narrows ? rules::comm_narrow : rules::comm_input, communication.span,
                {event.name, to_string(event.type), variable->name, to_string(variable->type)})
        .notes.push_back({event.name_span, "the event is declared here"});
}

/// Checks rules Tg2 and Tg5, and the types of communicated values.
void Typer::check_communicated(Communication& communication, const Event& event, Surroundings&) {
    const bool simple = communication.kind == CommKind::simple;
    const bool input = communication.kind == CommKind::input;
    const bool typed = event.type_expr != nullptr;
    if (simple && typed && event.type)
        finder_.out()
            .report(rules::tg2, communication.span, {event.name, to_string(event.type)})
            .notes.push_back({event.name_span, "the event is declared here"});
    if (!simple && !typed)
        finder_.out()
            .report(rules::tg5, communication.span, {event.name, input ? "received" : "sent"})
            .notes.push_back({event.name_span, "the event is declared here"});
    if (simple || !typed || !event.type) return;
    if (input) {
        check_received(communication, event);
        return;
    }
    if (communication.value->type && !is_compatible(communication.value->type, event.type))
        finder_.out()
            .report(rules::comm_value, communication.value->span,
                    {event.name, to_string(event.type), to_string(communication.value->type)})
            .notes.push_back({event.name_span, "the event is declared here"});
}

}  // namespace robochart::frontend
