// SPDX-License-Identifier: Apache-2.0
// Lowers statements to small structured programs (semantics 3.5).
#include "semantics/lower/programs.hpp"

#include <algorithm>

#include "semantics/lower/types.hpp"
#include "semantics/rules.hpp"

namespace robochart::ir {
namespace {

namespace ast = frontend;

class Programs {
public:
    Programs(Lowering& lowering, const Names& names, const std::string& element)
        : lowering_(lowering), names_(names), element_(element) {}

    StmtPtr lower(const ast::Stmt& source);

private:
    Stmt start_statement(const ast::Stmt& source, StmtKind kind);
    void fill_statement(const ast::Stmt& source, Stmt& stmt);
    void lower_sequence(const ast::Stmt& source, Stmt& stmt);
    void lower_conditional(const ast::Stmt& source, Stmt& stmt);
    void lower_assignment(const ast::Stmt& source, Stmt& stmt);
    TypeId lower_path(const ast::Expr& target, Stmt& stmt);
    TypeId member_step(const ast::Expr& target, TypeId base, Stmt& stmt);
    TypeId index_step(const ast::Expr& target, TypeId base, Stmt& stmt);
    void lower_communication_statement(const ast::Stmt& source, Stmt& stmt);
    void lower_call(const ast::Stmt& source, Stmt& stmt);
    OperationId software_operation(const ast::Stmt& source);
    void clock_reset(const ast::Stmt& source, Stmt& stmt);

    static StmtPtr share_statement(Stmt stmt) { return std::make_shared<const Stmt>(std::move(stmt)); }

    Lowering& lowering_;
    const Names& names_;
    const std::string& element_;
};

StmtKind kind_of(ast::StmtKind kind) {
    switch (kind) {
        case ast::StmtKind::sequence:
            return StmtKind::sequence;
        case ast::StmtKind::if_then_else:
            return StmtKind::if_then_else;
        case ast::StmtKind::assignment:
            return StmtKind::assign;
        case ast::StmtKind::communication:
            return StmtKind::communicate;
        case ast::StmtKind::call:
            return StmtKind::call;
        case ast::StmtKind::wait:
            return StmtKind::wait;
        case ast::StmtKind::wait_interval:
            return StmtKind::wait_interval;
        case ast::StmtKind::clock_reset:
            return StmtKind::clock_reset;
        case ast::StmtKind::deadline:
            return StmtKind::deadline;
        case ast::StmtKind::exec:
            return StmtKind::exec;
        case ast::StmtKind::skip:
        case ast::StmtKind::parenthesised:
        case ast::StmtKind::error:
            break;
    }
    return StmtKind::skip;
}

CommKind kind_of(ast::CommKind kind) {
    switch (kind) {
        case ast::CommKind::input:
            return CommKind::input;
        case ast::CommKind::output:
            return CommKind::output;
        case ast::CommKind::sync:
            return CommKind::sync;
        case ast::CommKind::simple:
            break;
    }
    return CommKind::simple;
}

/// Returns the part of a communication that triggers and statements have in common.
Communication lower_communication(Lowering& lowering, const Names& names, const ast::Communication& source) {
    Communication result;
    result.kind = kind_of(source.kind);
    result.event = look_up(names.events, source.event_target);
    if (!result.event.is_valid()) {
        lowering.report_unresolved("event '" + source.event.text() + "'", source.span);
        return result;
    }
    const Event& event = names.machine->events[result.event.index];
    if (event.broadcast) lowering.report_unsupported("broadcast event " + event.name, source.span);
    if (!source.from_variable.empty()) lowering.report_unsupported("receiving the sender of a broadcast", source.span);
    if (source.kind == ast::CommKind::input) {
        result.variable = look_up(names.variables, source.variable_target);
        if (!result.variable.is_valid())
            lowering.report_unresolved("variable '" + source.variable.text() + "'", source.span);
    }
    if (source.value) result.value = lower_expression(lowering, names, *source.value, event.type.value_or(TypeId{}));
    return result;
}

Stmt Programs::start_statement(const ast::Stmt& source, StmtKind kind) {
    Stmt stmt;
    stmt.kind = kind;
    stmt.point = names_.machine->points++;
    stmt.origin = origin_of(element_, source.span);
    return stmt;
}

/// Lowers a statement. Parentheses are dropped.
StmtPtr Programs::lower(const ast::Stmt& source) {
    const ast::Stmt* inner = &source;
    while (inner->kind == ast::StmtKind::parenthesised && !inner->body.empty() && inner->body[0])
        inner = inner->body[0].get();
    Stmt stmt = start_statement(*inner, kind_of(inner->kind));
    fill_statement(*inner, stmt);
    return share_statement(std::move(stmt));
}

void Programs::lower_sequence(const ast::Stmt& source, Stmt& stmt) {
    for (const auto& part : source.body)
        if (part) stmt.body.push_back(lower(*part));
}

void Programs::lower_conditional(const ast::Stmt& source, Stmt& stmt) {
    stmt.condition = lower_expression(lowering_, names_, *source.condition, boolean_type);
    if (mentions_time(stmt.condition))
        lowering_.report_unsupported("a timed expression in an action", source.condition->span);
    lower_sequence(source, stmt);
    if (stmt.body.size() < 2) stmt.body.push_back(share_statement(start_statement(source, StmtKind::skip)));
}

TypeId Programs::member_step(const ast::Expr& target, TypeId base, Stmt& stmt) {
    const Type& type = lowering_.system.type(base);
    const auto at = std::ranges::find(type.labels, target.text);
    if (type.kind != TypeKind::record || at == type.labels.end()) {
        lowering_.report_unresolved("field '" + target.text + "'", target.span);
        return base;
    }
    Expr field;
    field.kind = ExprKind::integer;
    field.type = nat_type;
    field.number = at - type.labels.begin();
    field.text = target.text;
    field.span = target.span;
    const auto place = static_cast<std::size_t>(field.number);
    stmt.path.push_back(std::make_shared<const Expr>(std::move(field)));
    return type.args[place];
}

TypeId Programs::index_step(const ast::Expr& target, TypeId base, Stmt& stmt) {
    for (std::size_t i = 1; i < target.args.size(); ++i)
        if (target.args[i]) stmt.path.push_back(lower_expression(lowering_, names_, *target.args[i]));
    const Type& type = lowering_.system.type(base);
    const bool indexed =
        type.kind == TypeKind::sequence || type.kind == TypeKind::vector || type.kind == TypeKind::matrix;
    if (indexed) return type.args[0];
    const bool fixed = !stmt.path.empty() && stmt.path.back()->kind == ExprKind::integer;
    const auto place = fixed ? static_cast<std::size_t>(stmt.path.back()->number - 1) : type.args.size();
    if (type.kind == TypeKind::product && place < type.args.size()) return type.args[place];
    lowering_.report_unsupported("an assignment through an index of type " + type.name, target.span);
    return base;
}

/// Lowers the assigned variable and the path to its assigned part. Returns the type of that part.
TypeId Programs::lower_path(const ast::Expr& target, Stmt& stmt) {
    if (target.kind == ast::ExprKind::member || target.kind == ast::ExprKind::index) {
        const TypeId base = lower_path(*target.args[0], stmt);
        return target.kind == ast::ExprKind::member ? member_step(target, base, stmt) : index_step(target, base, stmt);
    }
    const bool written = target.kind == ast::ExprKind::register_;
    stmt.variable = look_up(written ? names_.registers : names_.variables, target.target);
    if (stmt.variable.is_valid()) return names_.machine->variables[stmt.variable.index].type;
    lowering_.report_unresolved("variable '" + target.name.text() + "'", target.span);
    return nat_type;
}

void Programs::lower_assignment(const ast::Stmt& source, Stmt& stmt) {
    const TypeId type = lower_path(*source.target, stmt);
    const bool part = !stmt.path.empty() && stmt.variable.is_valid();
    const bool written = part && names_.machine->variables[stmt.variable.index].output;
    const auto reads = [&](const Input& input) { return input.content == stmt.variable; };
    if (written && std::ranges::none_of(names_.machine->inputs, reads))
        lowering_.diagnostics.report(rules::robosim_unsupported, source.span,
                                     {"an assignment to a part of an output that is not an input",
                                      "its other parts have no value; add the variable to the input context"});
    stmt.value = lower_expression(lowering_, names_, *source.value, type);
    if (mentions_time(stmt.value)) lowering_.report_unsupported("a timed expression in an action", source.value->span);
}

void Programs::lower_communication_statement(const ast::Stmt& source, Stmt& stmt) {
    const ast::Communication& communication = *source.communication;
    stmt.communication = lower_communication(lowering_, names_, communication);
    if (!communication.predicate) return;
    if (communication.kind != ast::CommKind::input)
        return lowering_.report_unsupported("a condition on a communication that receives no value in an action",
                                            source.span);
    Names incoming = names_;  // the variable stands for the received value, as in a trigger
    incoming.trigger_variable = communication.variable_target;
    stmt.communication.predicate = lower_expression(lowering_, incoming, *communication.predicate, boolean_type);
    if (mentions_time(stmt.communication.predicate))
        lowering_.report_unsupported("a timed expression in an action", communication.predicate->span);
}

/// For a call without `$` of an operation in the output context, returns the software operation with this name. The id
/// is invalid if there is no such output.
OperationId Programs::software_operation(const ast::Stmt& source) {
    const OperationId output = look_up(names_.platform_operations, source.declaration);
    if (!output.is_valid()) return {};
    std::vector<OperationSignature>& known = names_.machine->operations;
    OperationSignature software = known[output.index];
    software.output = false;
    const auto same = std::ranges::find_if(known, [&](const OperationSignature& operation) {
        return !operation.output && operation.name == software.name && operation.parameters == software.parameters;
    });
    const OperationId result{static_cast<std::uint32_t>(same - known.begin())};
    if (same == known.end()) known.push_back(std::move(software));
    return result;
}

void Programs::lower_call(const ast::Stmt& source, Stmt& stmt) {
    const bool marked = source.through_register;
    stmt.operation = look_up(marked ? names_.platform_operations : names_.operations, source.declaration);
    // a call of an output without `$` (RC-Y06)
    if (!marked && !stmt.operation.is_valid()) stmt.operation = software_operation(source);
    if (!stmt.operation.is_valid())
        return lowering_.report_unresolved("operation '" + source.name.text() + "'", source.span);
    const auto types = names_.machine->operations[stmt.operation.index].parameters;
    for (std::size_t i = 0; i < source.args.size(); ++i)
        stmt.args.push_back(
            lower_expression(lowering_, names_, *source.args[i], i < types.size() ? types[i] : TypeId{}));
    if (types.size() != source.args.size()) lowering_.report_unresolved("a call with these arguments", source.span);
}

void Programs::clock_reset(const ast::Stmt& source, Stmt& stmt) {
    stmt.clock = look_up(names_.clocks, source.declaration);
    if (!stmt.clock.is_valid()) lowering_.report_unresolved("clock '" + source.name.text() + "'", source.span);
}

void Programs::fill_statement(const ast::Stmt& source, Stmt& stmt) {
    switch (source.kind) {
        case ast::StmtKind::sequence:
            return lower_sequence(source, stmt);
        case ast::StmtKind::if_then_else:
            return lower_conditional(source, stmt);
        case ast::StmtKind::assignment:
            return lower_assignment(source, stmt);
        case ast::StmtKind::communication:
            return lower_communication_statement(source, stmt);
        case ast::StmtKind::call:
            return lower_call(source, stmt);
        case ast::StmtKind::clock_reset:
            return clock_reset(source, stmt);
        case ast::StmtKind::deadline:
            if (names_.machine->robosim)
                lowering_.diagnostics.report(rules::robosim_unsupported, source.span,
                                             {"a deadline in an action", "no source defines its meaning"});
            lower_sequence(source, stmt);
            [[fallthrough]];
        case ast::StmtKind::wait:
        case ast::StmtKind::wait_interval:
            stmt.value = lower_duration(lowering_, names_, *source.value);
            if (source.upper) stmt.upper = lower_duration(lowering_, names_, *source.upper);
            return;
        case ast::StmtKind::skip:
        case ast::StmtKind::exec:
            return;
        case ast::StmtKind::parenthesised:
        case ast::StmtKind::error:
            return lowering_.report_unresolved("a statement", source.span);
    }
}

}  // namespace

StmtPtr lower_action(Lowering& lowering, const Names& names, const ast::Stmt& source, const std::string& element) {
    return Programs(lowering, names, element).lower(source);
}

Communication lower_trigger(Lowering& lowering, const Names& names, const ast::Communication& source) {
    Communication trigger = lower_communication(lowering, names, source);
    if (trigger.kind == CommKind::output || trigger.kind == CommKind::sync)
        lowering.report_unsupported("a trigger that sends a value", source.span);
    return trigger;
}

ExprPtr lower_duration(Lowering& lowering, const Names& names, const ast::Expr& source) {
    const ExprPtr duration = lower_expression(lowering, names, source);
    const TypeKind kind = lowering.system.type(duration->type).kind;
    if (kind == TypeKind::nat || kind == TypeKind::integer) return duration;
    if (kind != TypeKind::real) {
        lowering.report_unsupported("a duration that is not a number", source.span);
        return duration;
    }
    const bool whole = duration->kind != ExprKind::real || duration->decimal.decimals == 0;
    if (!whole) lowering.report_unsupported("a duration that is not a whole number of time units", source.span);
    Expr cast;
    cast.kind = ExprKind::cast;
    cast.type = integer_type;
    cast.span = duration->span;
    cast.args = {duration};
    return std::make_shared<const Expr>(std::move(cast));
}

}  // namespace robochart::ir
