// SPDX-License-Identifier: Apache-2.0
#include "cpp_emit/faults/statement_faults.hpp"

#include <algorithm>

#include "cpp_emit/plan/types.hpp"

namespace robochart::cpp_emit {

using ir::StmtKind;
using ir::StmtPtr;

namespace {

StmtPtr make_statement(ir::Stmt stmt) {
    return std::make_shared<ir::Stmt>(std::move(stmt));
}

StmtPtr skip_statement(const ir::Stmt& in_place_of) {
    ir::Stmt skip;
    skip.point = in_place_of.point;
    skip.origin = in_place_of.origin;
    return make_statement(std::move(skip));
}

StmtPtr one_after_the_other(std::vector<StmtPtr> parts) {
    ir::Stmt all;
    all.kind = StmtKind::sequence;
    all.point = parts.front()->point;
    all.origin = parts.front()->origin;
    all.body = std::move(parts);
    return make_statement(std::move(all));
}

StmtPtr wait_statement(const ir::Stmt& at, ir::ExprPtr duration) {
    ir::Stmt wait;
    wait.kind = StmtKind::wait;
    wait.point = at.point;
    wait.origin = at.origin;
    wait.value = std::move(duration);
    return make_statement(std::move(wait));
}

}  // namespace

StmtPtr StatementFaults::rewrite(const StmtPtr& stmt) {
    if (!stmt) return stmt;
    ir::Stmt changed = *stmt;
    rewrite_parts(changed);
    return apply_fault(changed);
}

void StatementFaults::rewrite_parts(ir::Stmt& stmt) {
    for (StmtPtr& part : stmt.body) part = rewrite(part);
    stmt.condition = expressions_.rewrite(stmt.condition);
    rewrite_path(stmt);
    stmt.value = expressions_.rewrite(stmt.value);
    stmt.upper = expressions_.rewrite(stmt.upper);
    for (ir::ExprPtr& argument : stmt.args) argument = expressions_.rewrite(argument);
    if (stmt.kind != StmtKind::communicate) return;
    if (stmt.communication.kind == ir::CommKind::input)
        rewrite_reception(stmt.communication);
    else
        stmt.communication.value = expressions_.rewrite(stmt.communication.value);
}

/// Rewrites the path of an assignment. Steps to a field are field numbers; steps to an item are expressions.
void StatementFaults::rewrite_path(ir::Stmt& stmt) {
    if (stmt.path.empty()) return;
    ir::TypeId type = unit_.machine->variables[stmt.variable.index].type;
    bool in_row = false;  // the first index of a matrix selects a row
    for (ir::ExprPtr& step : stmt.path) {
        const ir::Type& outer = system_.type(type);
        if (is_struct(outer)) {
            const std::int64_t first = outer.kind == ir::TypeKind::product ? 1 : 0;
            type = outer.args.at(static_cast<std::size_t>(step->number - first));
            continue;
        }
        step = expressions_.rewrite_place(step);
        in_row = outer.kind == ir::TypeKind::matrix && !in_row;
        if (!in_row) type = outer.args.at(0);
    }
}

StmtPtr StatementFaults::apply_fault(const ir::Stmt& stmt) {
    switch (stmt.kind) {
        case StmtKind::sequence:
            return rewrite_sequence(stmt);
        case StmtKind::if_then_else:
            return rewrite_branches(stmt);
        case StmtKind::assign:
            return rewrite_assignment(stmt);
        case StmtKind::communicate:
            return rewrite_communication(stmt);
        case StmtKind::call:
            return rewrite_call(stmt);
        case StmtKind::wait:
        case StmtKind::wait_interval:
            return rewrite_wait(stmt);
        case StmtKind::clock_reset:
            return has_effect(stmt.clock) && mutation_.hits(Fault::clock_not_reset) ? skip_statement(stmt)
                                                                                    : make_statement(stmt);
        case StmtKind::deadline:
            return deadline_statement(stmt);
        case StmtKind::skip:
        case StmtKind::exec:  // RoboSim: no code is generated
        case StmtKind::choose:
            break;
    }
    return make_statement(stmt);
}

StmtPtr StatementFaults::rewrite_sequence(ir::Stmt stmt) {
    for (std::size_t i = 0; i + 1 < stmt.body.size(); ++i)
        if (mutation_.hits(Fault::statements_exchanged)) std::swap(stmt.body[i], stmt.body[i + 1]);
    return make_statement(std::move(stmt));
}

StmtPtr StatementFaults::rewrite_branches(ir::Stmt stmt) {
    if (!mutation_.hits(Fault::branches_exchanged)) return make_statement(std::move(stmt));
    if (stmt.body.size() < 2) stmt.body.push_back(skip_statement(stmt));
    std::swap(stmt.body[0], stmt.body[1]);
    return make_statement(std::move(stmt));
}

StmtPtr StatementFaults::rewrite_assignment(ir::Stmt stmt) {
    if (mutation_.hits(Fault::assignment_dropped)) return skip_statement(stmt);
    if (stmt.path.empty() || !mutation_.hits(Fault::part_not_assigned)) return make_statement(std::move(stmt));
    ir::Expr same;
    same.kind = ir::ExprKind::variable;
    same.variable = stmt.variable;
    same.type = unit_.machine->variables[stmt.variable.index].type;
    stmt.value = std::make_shared<ir::Expr>(std::move(same));
    stmt.path.clear();
    return make_statement(std::move(stmt));
}

StmtPtr StatementFaults::rewrite_communication(ir::Stmt stmt) {
    ir::Communication& what = stmt.communication;
    if (what.kind == ir::CommKind::input)
        return mutation_.hits(Fault::loop_never_ends) ? skip_statement(stmt) : make_statement(std::move(stmt));
    if (mutation_.hits(Fault::send_dropped)) return skip_statement(stmt);
    const EventUse& use = component_.find_event(unit_, what.event);
    if (use.ports.empty() || !use.filled.empty()) return make_statement(std::move(stmt));
    const ir::EventId other = other_event(what.event, false);
    if (other.is_valid() && mutation_.hits(Fault::wrong_output)) what.event = other;
    return repeat_if_faulty(std::move(stmt));
}

/// Changes an output of the component according to Fault::output_repeated.
StmtPtr StatementFaults::repeat_if_faulty(ir::Stmt stmt) {
    const StmtPtr once = make_statement(std::move(stmt));
    return mutation_.hits(Fault::output_repeated) ? one_after_the_other({once, once}) : once;
}

void StatementFaults::rewrite_reception(ir::Communication& what) {
    what.predicate = expressions_.rewrite(what.predicate);
    if (what.predicate && mutation_.hits(Fault::predicate_dropped)) what.predicate = nullptr;
    const ir::EventId other = other_event(what.event, true);
    if (other.is_valid() && mutation_.hits(Fault::wrong_input)) what.event = other;
    if (what.variable.is_valid() && mutation_.hits(Fault::value_not_stored)) what.variable = {};
}

/// Returns the machine's next event of the same type at the component's boundary, cyclically; invalid if there is none.
ir::EventId StatementFaults::other_event(ir::EventId own, bool received) const {
    const EventUse& use = component_.find_event(unit_, own);
    const auto& all = unit_.machine->events;
    if (use.ports.empty()) return {};
    for (std::size_t step = 1; step < all.size(); ++step) {
        const auto place = static_cast<std::uint32_t>((own.index + step) % all.size());
        const EventUse* const next = component_.find_event(Peer{unit_.part, all[place].name});
        if (next == nullptr || next->ports.empty() || next->type != use.type) continue;
        const EventPort& port = component_.events[next->ports.front()];
        if (received ? port.received : port.sent) return {place};
    }
    return {};
}

StmtPtr StatementFaults::rewrite_call(ir::Stmt stmt) {
    if (mutation_.hits(Fault::call_dropped)) return skip_statement(stmt);
    exchange_arguments(stmt);
    if (!unit_.definitions[stmt.operation.index].is_valid()) {
        const ir::OperationId other = other_operation(stmt.operation);
        if (other.is_valid() && mutation_.hits(Fault::wrong_output)) stmt.operation = other;
        return repeat_if_faulty(std::move(stmt));
    }
    const auto& parameters = unit_.machine->operations[stmt.operation.index].parameters;
    for (std::size_t i = 0; i < stmt.args.size(); ++i) {
        const ir::ExprPtr literal = default_literal(system_, inst_, parameters[i]);
        if (literal && mutation_.hits(Fault::argument_dropped)) stmt.args[i] = literal;
    }
    return make_statement(std::move(stmt));
}

void StatementFaults::exchange_arguments(ir::Stmt& stmt) {
    const auto& parameters = unit_.machine->operations[stmt.operation.index].parameters;
    const bool alike = stmt.args.size() >= 2 && parameters[0] == parameters[1];
    if (alike && mutation_.hits(Fault::argument_swapped)) std::swap(stmt.args[0], stmt.args[1]);
}

/// Returns the machine's next platform operation with the same parameters, cyclically; invalid if there is none.
ir::OperationId StatementFaults::other_operation(ir::OperationId own) const {
    const auto& all = unit_.machine->operations;
    for (std::size_t step = 1; step < all.size(); ++step) {
        const auto place = static_cast<std::uint32_t>((own.index + step) % all.size());
        const bool called = std::ranges::any_of(
            component_.calls, [&](const PlatformCall& call) { return call.signature->name == all[place].name; });
        if (called && !unit_.definitions[place].is_valid() && all[place].parameters == all[own.index].parameters)
            return {place};
    }
    return {};
}

StmtPtr StatementFaults::rewrite_wait(ir::Stmt stmt) {
    if (mutation_.hits(Fault::wait_dropped) || mutation_.hits(Fault::loop_never_ends)) return skip_statement(stmt);
    const ir::ExprPtr less = one_less(system_, stmt.value);
    if (less && mutation_.hits(Fault::wait_early)) stmt.value = less;
    const ir::ExprPtr unit = one_literal(system_, stmt.value->type);
    const StmtPtr all = make_statement(std::move(stmt));
    return mutation_.hits(Fault::wait_late) ? one_after_the_other({all, wait_statement(*all, unit)}) : all;
}

StmtPtr StatementFaults::deadline_statement(ir::Stmt stmt) {
    if (mutation_.hits(Fault::deadline_ignored)) return stmt.body[0];
    stmt.value = rewrite_bound(stmt.value);
    return make_statement(std::move(stmt));
}

ir::ExprPtr StatementFaults::rewrite_bound(const ir::ExprPtr& bound) {
    if (mutation_.hits(Fault::deadline_late)) return one_more(system_, bound);
    const ir::ExprPtr less = one_less(system_, bound);
    return less && mutation_.hits(Fault::deadline_early) ? less : bound;
}

StmtPtr StatementFaults::run_again(const StmtPtr& program) const {
    ir::Expr unit;
    unit.kind = ir::ExprKind::integer;
    unit.number = 1;
    const auto nat =
        std::ranges::find_if(system_.types, [](const ir::Type& type) { return type.kind == ir::TypeKind::nat; });
    if (nat == system_.types.end()) return program;
    unit.type = {static_cast<std::uint32_t>(nat - system_.types.begin())};
    return one_after_the_other(
        {program, wait_statement(*program, std::make_shared<ir::Expr>(std::move(unit))), program});
}

bool StatementFaults::has_effect(ir::ClockId clock) const {
    const auto [owner, own] = component_.clock_owner(unit_, clock);
    return owner->clock_read[own.index];
}

}  // namespace robochart::cpp_emit
