// SPDX-License-Identifier: Apache-2.0
// Determines what is urgent, and what a tock changes.
#include "csp_emit/machine/rules/time.hpp"

#include <algorithm>

#include "base/diagnostics/containers.hpp"
#include "checker/cspm/syntax/build.hpp"
#include "csp_emit/machine/rules/shared_variables.hpp"
#include "csp_emit/machine/rules/transitions.hpp"

namespace robochart::csp_emit {

namespace b = cspm::build;
using cspm::ExprPtr;
using Op = cspm::ExprKind;

namespace {

ExprPtr minus_one(const ExprPtr& value) {
    return b::binary(Op::minus, value, b::number(1));
}

/// Calls `visit` with the counters of the threads' current deadlines.
template <class Visit>
void for_each_deadline(const View& view, const Visit& visit) {
    const auto deadlines = [&](const Program& program) {
        for (const Link* link = program.get(); link != nullptr; link = link->tail.get())
            if (link->head.kind == ItemKind::deadline_end) visit(link->head.cells.at(0));
    };
    for (const RunningThread& call : view.calls) deadlines(call.thread().rest);
    for (const RunningThread& running : view.threads) deadlines(running.thread().rest);
}

/// Returns the preconditions of a call of a platform operation, `pre & opCall`. The call is urgent only if it is
/// offered.
b::Exprs call_preconditions(const MachineTables& tables, const RunningThread& running, bool alone) {
    const Item& item = running.head();
    if (item.kind != ItemKind::statement || item.stmt->kind != ir::StmtKind::call) return {};
    const bool steady =
        is_stable(tables, running.frame(), *item.stmt, alone) && !reads_in_turn(tables, running, *item.stmt);
    return steady && is_visible(tables, running, *item.stmt)
               ? function_preconditions(tables, running.frame(), *item.stmt, {})
               : b::Exprs{};
}

/// Returns the conditions under which time may pass: no deadline has expired and no operation of the platform can be
/// called.
b::Exprs time_conditions(const MachineTables& tables, const View& view) {
    b::Exprs result;
    for (const RunningThread& running : view.threads)
        if (const auto conditions = call_preconditions(tables, running, view.threads.size() == 1); !conditions.empty())
            result.push_back(b::logical_not(b::all_of(conditions)));
    const auto left = [&](CellId cell) {
        return b::binary(Op::greater, tables.cells.parameter_name(cell), b::number(0));
    };
    for_each_deadline(view, [&](CellId cell) { result.push_back(left(cell)); });
    for (const auto& [cell, condition] : active_monitors(tables, view, {})) {
        const bool always = condition->kind == Op::boolean && condition->number != 0;
        result.push_back(always ? left(cell) : b::any_of({b::logical_not(condition), left(cell)}));
    }
    return result;
}

/// Decreases the remaining times of waits. A thread whose wait is over continues. The waits are handled one after the
/// other, and `values` contains the results of those handled so far.
Next after_tock(const MachineTables& tables, const Activation& config, const Values& values) {
    const View now = view_of(config);
    for (const RunningThread& running : now.threads) {
        const Item& item = running.head();
        if (item.kind != ItemKind::waiting) continue;
        if (item.cells.empty()) return after_tock(tables, running.replace(running.tail()), values);
        if (values.count(item.cells[0]) != 0) continue;
        const ExprPtr left = tables.cells.parameter_name(item.cells[0]);
        Values shorter = values;
        shorter[item.cells[0]] = minus_one(left);
        return {Next::Kind::wait_over,
                {},
                {},
                b::binary(Op::greater, left, b::number(1)),
                {after_tock(tables, config, shorter), after_tock(tables, running.replace(running.tail()), values)}};
    }
    return next_configuration(config, values);
}

Next wait_for(MachineTables& tables, const RunningThread& running, const ir::Stmt& stmt, const ExprPtr& units,
              const Program& rest, const Values& values) {
    const bool literal = units->kind == Op::integer;
    if (literal && units->number <= 0) return next_configuration(running.replace(rest), values);
    if (units->kind == Op::negate) return next_configuration(running.replace(rest), values);
    Item item = running.head();
    item.kind = ItemKind::waiting;
    item.stmt = &stmt;
    Values changed = values;
    if (!literal || units->number > 1) {
        item.cells = {tables.cells.of_statement(running.frame(), stmt, 0, CellKind::waiting, "w__")};
        changed[item.cells[0]] = units;
    }
    const Next waiting = next_configuration(running.replace(push_item(item, rest)), changed);
    if (literal) return waiting;
    return next_if(b::binary(Op::greater, units, b::number(0)), waiting,
                   next_configuration(running.replace(rest), values));
}

}  // namespace

bool stops_time(const MachineTables& tables, const RunningThread& running, bool alone) {
    const Item& item = running.head();
    if (item.kind == ItemKind::entered || item.kind == ItemKind::left || item.kind == ItemKind::shown) return true;
    if (item.kind == ItemKind::store)
        return !tables.cells[tables.frames[running.frame()].variables.at(item.variable.index)].shared;
    if (item.kind == ItemKind::frozen) return item.stmt->kind == ir::StmtKind::call;
    if (item.kind != ItemKind::statement) return false;
    const ir::Stmt& stmt = *item.stmt;
    if (!is_visible(tables, running, stmt)) return true;
    if (stmt.kind == ir::StmtKind::call) return call_preconditions(tables, running, alone).empty();
    const bool input = stmt.kind == ir::StmtKind::communicate && stmt.communication.kind == ir::CommKind::input;
    return !input && !is_stable(tables, running.frame(), stmt, alone);
}

bool is_urgent(const MachineTables& tables, const View& view) {
    const bool alone = view.threads.size() == 1;
    return std::ranges::any_of(view.threads,
                               [&](const RunningThread& running) { return stops_time(tables, running, alone); }) ||
           std::ranges::any_of(view.machines, [&](const RunningMachine& running) {
               return has_urgent_transition(tables, *running.activation);
           });
}

std::vector<std::pair<CellId, ExprPtr>> active_monitors(const MachineTables& tables, const View& view,
                                                        const Values& values) {
    std::vector<std::pair<CellId, ExprPtr>> result;
    for (const RunningMachine& running : view.machines) {
        const std::uint32_t index = running.activation->frame;
        const Frame& frame = tables.frames[index];
        for (const auto& [id, cell] : frame.monitors) {
            const ir::Transition& transition = frame.machine->transitions[id];
            const auto& entered = running.activation->entered;
            if (std::ranges::find(entered, transition.source) == entered.end()) continue;
            // The monitor of the deadline receives no value, so it reads the variable (semantics 3.10).
            const bool receives = transition.trigger && transition.trigger->kind == ir::CommKind::input;
            const ExprPtr known =
                receives ? tables.cells.current_value(frame.variables.at(transition.trigger->variable.index), values)
                         : nullptr;
            result.emplace_back(cell, guard_of(tables, index, transition, values, known));
        }
    }
    return result;
}

Values with_monitors(const MachineTables& tables, const Activation& config, const Values& values) {
    Values changed = values;
    for (const auto& [cell, guard] : active_monitors(tables, view_of(config), values)) {
        const bool known = guard->kind == Op::boolean;
        if (known && guard->number != 0) continue;
        const ExprPtr anew = tables.frames.full_time(cell, values);
        changed[cell] = known ? anew : b::if_(guard, tables.cells.current_value(cell, values), anew);
    }
    return changed;
}

Branch tock_branch(const MachineTables& tables, const Activation& config, const View& view) {
    // Clocks of callers advance too, even if the callers are not part of the configuration (SparseCall::after_tock).
    Values values;
    for (const RunningMachine& running : view.machines)
        for (const CellId cell : tables.frames[running.activation->frame].own)
            if (tables.cells[cell].kind == CellKind::clock && tables.cells[cell].reading.empty())
                values[cell] = b::call("clock_step", {tables.cells.parameter_name(cell), tables.cells[cell].limit});
    for_each_deadline(view, [&](CellId cell) { values[cell] = minus_one(tables.cells.parameter_name(cell)); });
    for (const auto& [cell, condition] : active_monitors(tables, view, {})) {
        const ExprPtr left = minus_one(tables.cells.parameter_name(cell));
        const bool always = condition->kind == Op::boolean && condition->number != 0;
        values[cell] = always ? left : b::if_(condition, left, tables.frames.full_time(cell, {}));
    }
    const b::Exprs conditions = time_conditions(tables, view);
    return {conditions.empty() ? nullptr : b::all_of(conditions),
            b::name("tock"),
            {},
            after_tock(tables, config, values),
            true};
}

Next start_wait(MachineTables& tables, const RunningThread& running, const ir::Stmt& stmt, const Program& rest,
                const Values& values) {
    if (!tables.timed()) return next_configuration(running.replace(rest), values);
    const Project& project = tables.project();
    const auto units = [&](const ir::Expr& expr) {
        const std::int64_t scale = project.instantiation.scale;
        const ExprPtr value = translate_expression(project, tables.frames.make_scope(running.frame(), values), expr);
        const bool real = expr.type.is_valid() && project.system.type(expr.type).kind == ir::TypeKind::real;
        return real && scale != 1 ? b::binary(Op::divide, value, b::number(scale)) : value;
    };
    if (stmt.kind == ir::StmtKind::wait) return wait_for(tables, running, stmt, units(*stmt.value), rest, values);
    const ExprPtr least = units(*stmt.value);
    return {Next::Kind::interval,
            {},
            {},
            b::set_range(least, units(*stmt.upper)),
            {wait_for(tables, running, stmt, b::name("d__"), rest, values)},
            stmt.origin.span};
}

std::vector<CellId> clocks_needed(const MachineTables& tables, const View& view) {
    std::vector<CellId> result;
    for (const RunningMachine& running : view.machines) {
        const Frame& frame = tables.frames[running.activation->frame];
        const auto note = [&](const ir::Expr& part) {
            if (part.kind != ir::ExprKind::since || !frame.clocks.at(part.clock.index)) return false;
            const CellId cell = *frame.clocks[part.clock.index];
            if (!tables.cells[cell].reading.empty()) result.push_back(cell);
            return false;
        };
        for (const ir::TransitionId id : outgoing_transitions(tables, *running.activation))
            if (const auto& guard = frame.machine->transitions[id.index].guard) (void)has_part(*guard, note);
    }
    diagnostics::sort_unique(result);
    return result;
}

}  // namespace robochart::csp_emit
