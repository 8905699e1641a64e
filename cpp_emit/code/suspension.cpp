// SPDX-License-Identifier: Apache-2.0
// Decides by recursion over the structure of statements. Whether an event must wait depends on its source or target
// (semantics 3.9).
#include "cpp_emit/code/suspension.hpp"

#include <algorithm>

#include "cpp_emit/code/assignment.hpp"
#include "cpp_emit/code/cycles.hpp"
#include "semantics/evaluate/preconditions.hpp"
#include "semantics/ir/visit.hpp"

namespace robochart::cpp_emit {

using ir::CommKind;
using ir::StmtKind;

bool guards_deadlines(const ir::Machine& machine) {
    return std::ranges::any_of(machine.transitions, [&](const ir::Transition& transition) {
        const bool leaves_state = machine.nodes[transition.source.index].kind == ir::NodeKind::state;
        return transition.deadline && transition.guard && leaves_state;
    });
}

std::vector<const ir::Expr*> evaluated_first(const ir::Stmt& stmt) {
    std::vector<const ir::Expr*> result;
    if (stmt.kind == StmtKind::communicate && stmt.communication.kind == CommKind::input) return result;
    for (const auto* expr : {&stmt.condition, &stmt.value, &stmt.upper, &stmt.communication.value})
        if (*expr) result.push_back(expr->get());
    for (const auto* list : {&stmt.args, &stmt.path})
        for (const auto& expr : *list) result.push_back(expr.get());
    return result;
}

namespace {

/// Returns true if the statement may call a function outside its precondition, which blocks the thread forever.
bool may_be_stuck(const Generation& generation, const Unit& unit, const ir::Stmt& stmt) {
    const auto expressions = evaluated_first(stmt);
    return std::ranges::any_of(expressions, [&](const ir::Expr* expr) {
        return ir::preconditions_can_fail(generation.system, generation.inst, unit.constants, *expr);
    });
}

/// Returns whether the statement itself may suspend, without its nested statements.
bool suspends_itself(const Generation& generation, const Unit& unit, const ir::Stmt& stmt) {
    if (may_be_stuck(generation, unit, stmt) || may_await_cycle(generation, unit, stmt)) return true;
    switch (stmt.kind) {
        case StmtKind::wait:
        case StmtKind::wait_interval:
            return true;
        case StmtKind::communicate:
            return stmt.communication.kind == CommKind::input ||
                   generation.component.find_event(unit, stmt.communication.event).waits_to_send();
        case StmtKind::assign:
            return may_be_held_up(generation, unit, stmt.variable);
        case StmtKind::call:
            return unit.definitions[stmt.operation.index].is_valid();
        case StmtKind::skip:
        case StmtKind::sequence:
        case StmtKind::if_then_else:
        case StmtKind::clock_reset:
        case StmtKind::deadline:
        case StmtKind::exec:
        case StmtKind::choose:
            break;
    }
    return false;
}

}  // namespace

bool may_suspend(const Generation& generation, const Unit& unit, const ir::StmtPtr& stmt) {
    if (!stmt) return false;
    return suspends_itself(generation, unit, *stmt) || std::ranges::any_of(stmt->body, [&](const ir::StmtPtr& part) {
               return may_suspend(generation, unit, part);
           });
}

namespace {

/// Returns whether the statement itself takes time, without its nested statements.
bool takes_time(const Generation& generation, const Unit& unit, const ir::Stmt& stmt) {
    const auto zero = [](const ir::ExprPtr& expr) { return expr->kind == ir::ExprKind::integer && expr->number == 0; };
    if (stmt.kind == StmtKind::wait && zero(stmt.value)) return false;
    if (stmt.kind == StmtKind::wait_interval && zero(stmt.upper)) return false;
    if (stmt.kind == StmtKind::call && unit.definitions[stmt.operation.index].is_valid())
        return may_be_stuck(generation, unit, stmt) ||
               actions_take_time(generation, generation.component.unit_at(unit.callees[stmt.operation.index]));
    return suspends_itself(generation, unit, stmt);
}

/// Returns true if an operation may rest in a state. This is possible if none of the state's transitions is always
/// enabled.
bool may_rest(const ir::Machine& operation) {
    const auto leaves = [&](const ir::TransitionId id) {
        const ir::Transition& transition = operation.transitions[id.index];
        return !transition.trigger && !transition.guard;
    };
    return std::ranges::any_of(operation.nodes, [&](const ir::Node& node) {
        return node.kind == ir::NodeKind::state && std::ranges::none_of(node.outgoing, leaves);
    });
}

}  // namespace

bool actions_take_time(const Generation& generation, const Unit& unit) {
    bool found = !unit.root && may_rest(*unit.machine);
    ir::visit_statements(*unit.machine, [&](const ir::Stmt& stmt) {
        if (!found) found = takes_time(generation, unit, stmt);
    });
    return found;
}

namespace {

/// Counts the writes of a variable in a machine, by statements and by triggers.
std::size_t count_writes(const ir::Machine& machine, const std::string& name) {
    std::size_t count = 0;
    const auto into = [&](ir::VariableId id) {
        if (id.is_valid() && machine.variables[id.index].name == name) ++count;
    };
    ir::visit_statements(machine, [&](const ir::Stmt& stmt) {
        if (stmt.kind == StmtKind::assign) into(stmt.variable);
        if (stmt.kind == StmtKind::communicate) into(stmt.communication.variable);
    });
    for (const ir::Transition& transition : machine.transitions)
        if (transition.trigger) into(transition.trigger->variable);
    return count;
}

}  // namespace

bool calls_hold_up_writes(const Generation& generation, const Unit& unit) {
    const Component& component = generation.component;
    std::size_t count = 0;
    for (const auto& [name, index] : component.part_of(unit).variables) {
        const StoredVariable& required = component.variables[index];
        if (!required.shared || required.level == nullptr) continue;
        for (const Unit& other : component.units) {
            const auto& theirs = component.part_of(other).variables;
            for (const auto& [their_name, their_index] : theirs)
                if (their_index == index) count += count_writes(*other.machine, their_name);
        }
    }
    return count > 1;
}

bool reads_variables(const ir::Stmt& call) {
    bool found = false;
    for (const ir::ExprPtr& argument : call.args)
        ir::visit_operands(*argument,
                           [&](const ir::Expr& part) { found = found || part.kind == ir::ExprKind::variable; });
    return found;
}

}  // namespace robochart::cpp_emit
