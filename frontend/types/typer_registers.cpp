// SPDX-License-Identifier: Apache-2.0
// Resolves the names after `$`, which denote the registers of RoboSim. The names in scope are those of RoboTool, except
// that RoboTool also accepts some names that have no register.
#include <fmt/format.h>

#include "base/diagnostics/spelling.hpp"
#include "frontend/rules/rules.hpp"
#include "frontend/syntax/print.hpp"
#include "frontend/types/typer.hpp"

namespace robochart::frontend {

namespace {

template <class Map>
auto find_in(const Map& map, const QualifiedName& name) -> typename Map::mapped_type {
    const auto found = map.find(name.parts.back());
    return found != map.end() ? found->second : nullptr;
}

std::string owner_name(const Surroundings& around) {
    const Declaration* component = component_around(around.place.inside);
    return component != nullptr ? component->name : std::string("this file");
}

}  // namespace

TypePtr Typer::type_register(Expr& expr, Surroundings& around) {
    if (around.registers == nullptr) {
        finder_.out().report(rules::no_registers, expr.span, {to_text(expr)});
        return nullptr;
    }
    if (&expr == written_) return written_register(expr, around);
    return read_register(expr, around);
}

/// Computes the type of a read of a register: `$e` is true if the register of the event e contains a value, and `$x` is
/// the value of the variable x.
TypePtr Typer::read_register(Expr& expr, Surroundings& around) {
    const TypePtr boolean = make_type(TypeForm::boolean);
    const Event* const input = find_in(around.registers->inputs.events, expr.name);
    const Event* const output = find_in(around.registers->outputs.events, expr.name);
    const Variable* const variable = find_in(around.registers->inputs.variables, expr.name);
    if (output != nullptr) {
        finder_.out()
            .report(rules::output_read, expr.span, {output->name, owner_name(around)})
            .notes.push_back({output->name_span, "the output is declared here"});
        expr.target = output;
        return boolean;
    }
    expr.target = input;
    if (input == nullptr) expr.target = variable;
    if (expr.target == nullptr) {
        unknown_register(expr.name, expr.span, false, around);
    }
    if (!expr.args.empty()) {
        check_store(expr, around);
        return boolean;
    }
    if (input != nullptr) return boolean;
    return variable != nullptr ? variable->type : nullptr;
}

/// Checks `$e?v` and `$e?$x`: the variable can hold the values of the event. In the predicate, v is the received value.
void Typer::check_store(Expr& expr, Surroundings& around) {
    Expr& stored = *expr.args[0];
    const auto* event = dynamic_cast<const Event*>(expr.target);
    if (stored.kind == ExprKind::register_) {
        stored.type = written_register(stored, around);
    } else if (const Variable* variable = stored_into(stored.name, around)) {
        stored.target = variable;
        stored.type = variable->type;
    }
    if (expr.args[1]) check_boolean(expr.args[1], around, "what follows `:`");
    if (event == nullptr) {
        if (expr.target != nullptr)
            finder_.out()
                .report(rules::variable_stored, expr.span, {expr.target->name})
                .notes.push_back({expr.target->name_span, "the variable is declared here"});
        return;
    }
    if (event->type_expr == nullptr) {
        finder_.out()
            .report(rules::tg5, expr.span, {event->name, "received"})
            .notes.push_back({event->name_span, "the event is declared here"});
        return;
    }
    const auto* variable = dynamic_cast<const Variable*>(stored.target);
    if (variable == nullptr || !variable->type || !event->type || is_compatible(event->type, variable->type)) return;
    const bool narrows = is_compatible(variable->type, event->type);
    finder_.out()
        .report(narrows ? rules::comm_narrow : rules::comm_input, expr.span,
                {event->name, to_string(event->type), variable->name, to_string(variable->type)})
        .notes.push_back({event->name_span, "the event is declared here"});
}

/// Returns the type of the variable x in `$x = e` and `$e?$x`.
TypePtr Typer::written_register(Expr& expr, Surroundings& around) {
    if (const Variable* variable = find_in(around.registers->outputs.variables, expr.name)) {
        expr.target = variable;
        return variable->type;
    }
    if (const Variable* variable = find_in(around.registers->inputs.variables, expr.name)) {
        finder_.out()
            .report(rules::input_written, expr.span, {variable->name, owner_name(around)})
            .notes.push_back({variable->name_span, "the variable is declared here"});
        expr.target = variable;
        return variable->type;
    }
    unknown_register(expr.name, expr.span, true, around);
    return nullptr;
}

/// Reports a name after `$` that neither context declares. `whole` includes the `$`.
void Typer::unknown_register(const QualifiedName& name, Span whole, bool written, Surroundings& around) {
    const std::string& simple = name.parts.back();
    const Variable* const own = around.scope != nullptr ? find_in(around.scope->variables, name) : nullptr;
    const Span sign{whole.source, whole.begin, name.span.begin};
    if (own != nullptr) {
        auto& finding = finder_.out().report(rules::own_marked, whole,
                                             {own->name, std::string(to_text(own->kind)), owner_name(around)});
        finding.notes.push_back({own->name_span, "it is declared here"});
        finding.fixes.push_back({sign, "", "remove the `$`"});
        return;
    }
    const Registers& registers = *around.registers;
    std::vector<std::string> candidates =
        finder_.keys_of(written ? registers.outputs.variables : registers.inputs.variables);
    for (std::string& event : finder_.keys_of(written ? registers.outputs.events : registers.inputs.events))
        candidates.push_back(std::move(event));
    auto& finding = finder_.report_unknown(
        name, written ? "output" : "input",
        fmt::format("in the {} context of `{}`", written ? "output" : "input", owner_name(around)), candidates);
    if (finder_.out().error_count() > diagnostics::Diagnostics::max_kept) return;
    const auto note = [&](DeclKind kind, std::string_view clause) {
        const Context* const interface = finder_.names().interface_with(simple, kind);
        if (interface == nullptr) return false;
        finding.notes.push_back(
            {interface->name_span,
             fmt::format("interface `{}` declares `{}`; `{} {}` in the {} context makes it visible", interface->name,
                         simple, clause, finder_.names().full_name(interface), written ? "output" : "input")});
        return true;
    };
    if (!note(DeclKind::event, "uses")) (void)note(DeclKind::variable, "requires");
}

/// Returns the event e of `$e`, `$e!v` or `$e.v`.
const Event* Typer::output_event(const Communication& communication, Surroundings& around) {
    if (around.registers == nullptr) {
        finder_.out().report(rules::no_registers, communication.span, {to_text(communication)});
        return nullptr;
    }
    const Event* const input = find_in(around.registers->inputs.events, communication.event);
    if (input != nullptr) {
        finder_.out()
            .report(rules::input_written, communication.span, {input->name, owner_name(around)})
            .notes.push_back({input->name_span, "the input is declared here"});
        return input;
    }
    if (const Event* output = find_in(around.registers->outputs.events, communication.event)) return output;
    unknown_register(communication.event, communication.span, true, around);
    return nullptr;
}

/// Finds the operation of a call in the output context. A call without `$` means a defined operation if there is one.
bool Typer::find_output_operation(Stmt& statement, Surroundings& around) {
    if (around.registers == nullptr) return false;
    const OperationSignature* const operation = find_in(around.registers->outputs.operations, statement.name);
    if (operation == nullptr || !finder_.names().is_qualified_by(statement.name, *operation)) return false;
    if (!statement.through_register) {
        if (around.scope->operations.contains(statement.name.parts.back())) return false;
        auto& finding =
            finder_.out().report(rules::operation_unmarked, statement.span, {operation->name, owner_name(around)});
        finding.notes.push_back({operation->name_span, "the operation is declared here"});
        finding.fixes.push_back({{statement.span.source, statement.span.begin, statement.span.begin}, "$", "insert"});
    }
    statement.declaration = operation;
    return true;
}

}  // namespace robochart::frontend
