// SPDX-License-Identifier: Apache-2.0
// Executes the first item of a thread's program, with or without an event.
#include "csp_emit/machine/rules/actions.hpp"

#include <algorithm>

#include "checker/cspm/syntax/build.hpp"
#include "csp_emit/base/registers.hpp"
#include "csp_emit/base/types.hpp"
#include "csp_emit/machine/rules/cycles.hpp"
#include "csp_emit/machine/rules/operations.hpp"
#include "csp_emit/machine/rules/shared_variables.hpp"
#include "csp_emit/machine/rules/states.hpp"
#include "csp_emit/machine/rules/time.hpp"

namespace robochart::csp_emit {

namespace b = cspm::build;
using cspm::ExprPtr;
using ir::CommKind;
using ir::StmtKind;

namespace {

const char* const received = "in__";

Item item_of_statement(const ir::StmtPtr& stmt, const std::string& label) {
    Item item;
    item.stmt = stmt.get();
    item.label = label;
    return item;
}

/// Returns the configuration after the statement, with these changed values.
Next finish_item(const RunningThread& running, Values values) {
    return next_configuration(running.replace(running.tail()), std::move(values));
}

/// Resets the clock if a cell of this machine holds the time of the clock.
void reset_clock(const MachineTables& tables, std::uint32_t index, ir::ClockId clock, Values& values) {
    const Frame& frame = tables.frames[index];
    tables.watch.note_reset(frame, clock, values);
    const auto& cell = frame.clocks.at(clock.index);
    if (tables.timed() && cell && tables.cells[*cell].reading.empty()) values[*cell] = b::number(0);
}

/// Starts `S <{d}`: adds a counter that runs in parallel with the statement S and ends with it.
Next start_deadline(MachineTables& tables, const RunningThread& running, const ir::Stmt& stmt, const Program& rest,
                    const Values& values) {
    const Item inner = item_of_statement(stmt.body.at(0), running.head().label);
    if (!tables.timed()) return next_configuration(running.replace(push_item(inner, rest)), values);
    const CellId cell = tables.cells.of_statement(running.frame(), stmt, 0, CellKind::deadline, "d__");
    Item end = running.head();
    end.kind = ItemKind::deadline_end;
    end.cells = {cell};
    Values changed = values;
    changed[cell] =
        translate_expression(tables.project(), tables.frames.make_scope(running.frame(), values), *stmt.value);
    return next_configuration(running.replace(push_item(inner, push_item(end, rest))), changed);
}

Next branch_on_condition(const MachineTables& tables, const RunningThread& running, const ir::Stmt& stmt,
                         const Program& rest, const Values& values) {
    const std::string& label = running.head().label;
    const Program other = stmt.body.size() > 1 ? push_item(item_of_statement(stmt.body[1], label), rest) : rest;
    return {Next::Kind::branching,
            {},
            {},
            translate_expression(tables.project(), tables.frames.make_scope(running.frame(), values), *stmt.condition),
            {next_configuration(running.replace(push_item(item_of_statement(stmt.body.at(0), label), rest)), values),
             next_configuration(running.replace(other), values)}};
}

/// Returns the internal choice between the alternatives.
Next choose_alternative(const RunningThread& running, const ir::Stmt& stmt, const Program& rest, const Values& values) {
    if (stmt.body.empty()) return next_configuration(block_thread(running), values);
    Next result{Next::Kind::internal};
    for (const ir::StmtPtr& part : stmt.body) {
        const Program program = push_item(item_of_statement(part, running.head().label), rest);
        result.parts.push_back(next_configuration(running.replace(program), values));
    }
    return result;
}

/// Returns the effect of the first statement, without the preconditions of the functions that it uses.
Next effect_of(MachineTables& tables, const RunningThread& running, const Values& values) {
    const ir::Stmt& stmt = *running.head().stmt;
    const Program& rest = running.tail();
    switch (stmt.kind) {
        case StmtKind::sequence: {
            Program all = rest;
            for (auto part = stmt.body.rbegin(); part != stmt.body.rend(); ++part)
                all = push_item(item_of_statement(*part, running.head().label), all);
            return next_configuration(running.replace(all), values);
        }
        case StmtKind::if_then_else:
            return branch_on_condition(tables, running, stmt, rest, values);
        case StmtKind::assign: {
            Values changed = values;
            changed[tables.frames[running.frame()].variables.at(stmt.variable.index)] =
                assigned_value(tables, running.frame(), stmt, values);
            return finish_item(running, changed);
        }
        case StmtKind::call:
            return call_operation(tables, running, stmt, rest, values);
        case StmtKind::wait:
        case StmtKind::wait_interval:
            return start_wait(tables, running, stmt, rest, values);
        case StmtKind::clock_reset: {
            Values changed = values;
            reset_clock(tables, running.frame(), stmt.clock, changed);
            return finish_item(running, changed);
        }
        case StmtKind::deadline:
            return start_deadline(tables, running, stmt, rest, values);
        case StmtKind::choose:
            return choose_alternative(running, stmt, rest, values);
        case StmtKind::skip:
        case StmtKind::communicate:
        case StmtKind::exec:
            break;
    }
    return finish_item(running, values);
}

/// Returns the effect of the first statement if it is not an event of the alphabet, followed by the continuation.
Next perform_statement(MachineTables& tables, const RunningThread& running, const Values& values) {
    Next then = effect_of(tables, running, values);
    const b::Exprs conditions = function_preconditions(tables, running.frame(), *running.head().stmt, values);
    if (conditions.empty()) return then;
    return next_if(b::all_of(conditions), std::move(then), next_configuration(block_thread(running), values));
}

std::optional<Next> silent_statement(MachineTables& tables, const RunningThread& running, const Activation& config,
                                     const Values& values, bool alone, bool branching) {
    const ir::Stmt& stmt = *running.head().stmt;
    const bool changes = stmt.kind == StmtKind::assign || stmt.kind == StmtKind::clock_reset;
    if (is_visible(tables, running, stmt) || stmt.kind == StmtKind::choose) return std::nullopt;
    const bool about_time = stmt.kind == StmtKind::clock_reset || stmt.kind == StmtKind::wait ||
                            stmt.kind == StmtKind::wait_interval || stmt.kind == StmtKind::deadline;
    // The untimed semantics omits the statement (semantics 3.11).
    if (about_time && !tables.timed()) return perform_statement(tables, running, values);
    if (changes && (running.during || !alone)) return std::nullopt;
    if (!is_stable(tables, running.frame(), stmt, alone)) return std::nullopt;
    // Each further conditional in one function would double the size of the text. So a second conditional after a first
    // one gets a separate function.
    const bool again = stmt.kind == StmtKind::if_then_else && branching;
    if (again || !reads_only_names(tables, running.frame(), stmt, values)) return at_point(config, values);
    return perform_statement(tables, running, values);
}

std::optional<Next> silent_head(MachineTables& tables, const RunningThread& running, const Activation& config,
                                const Values& values, bool alone, bool branching) {
    const Item& item = running.head();
    switch (item.kind) {
        case ItemKind::statement:
            return silent_statement(tables, running, config, values, alone, branching);
        case ItemKind::deadline_end:
            return finish_item(running, values);
        case ItemKind::join: {
            const auto& beside = running.owner().durings;
            if (std::ranges::any_of(beside, [&](const During& d) { return d.node == item.node; })) return std::nullopt;
            return finish_item(running, values);
        }
        case ItemKind::enter:
            return enter_node(tables, running, values);
        case ItemKind::entered:
            // the environment does not observe the states of called operations
            if (running.frame() != 0) return mark_entered(tables, running, values);
            return std::nullopt;
        case ItemKind::store: {
            const CellId target = tables.frames[running.frame()].variables.at(item.variable.index);
            const Cell& cell = tables.cells[target];
            if (cell.shared || !cell.output.empty() || !alone || running.during) return std::nullopt;
            Values changed = values;
            changed[target] = tables.cells.current_value(item.cells.at(0), values);
            return finish_item(running, changed);
        }
        case ItemKind::frozen:
        case ItemKind::waiting:
        case ItemKind::left:
        case ItemKind::resume:
        case ItemKind::shown:
        case ItemKind::stuck:
            break;
    }
    return std::nullopt;
}

/// Returns the values that the statement reads, in the order of the fields of its channel: the assigned or sent value,
/// or the arguments of a call.
b::Exprs values_read(const MachineTables& tables, std::uint32_t index, const ir::Stmt& stmt) {
    const Frame& frame = tables.frames[index];
    b::Exprs result;
    if (stmt.kind == StmtKind::assign) result.push_back(assigned_value(tables, index, stmt, {}));
    if (stmt.kind == StmtKind::communicate && stmt.communication.value)
        result.push_back(expression_as(tables.project(), tables.frames.make_scope(index, {}), *stmt.communication.value,
                                       *frame.machine->events.at(stmt.communication.event.index).type));
    for (std::size_t i = 0; i < stmt.args.size(); ++i)
        result.push_back(expression_as(tables.project(), tables.frames.make_scope(index, {}), *stmt.args[i],
                                       frame.machine->operations.at(stmt.operation.index).parameters.at(i)));
    return result;
}

/// Reads all expressions of the statement at once and stores their values.
Branch freeze_values(MachineTables& tables, const RunningThread& running, const ir::Stmt& stmt) {
    const std::uint32_t frame = running.frame();
    Item item = running.head();
    item.kind = ItemKind::frozen;
    Values values;
    for (const ExprPtr& value : values_read(tables, frame, stmt)) {
        item.cells.push_back(tables.cells.of_statement(frame, stmt, item.cells.size(), CellKind::frozen, "x__"));
        values[item.cells.back()] = value;
    }
    Next then = next_configuration(running.replace(push_item(item, running.tail())), values);
    const b::Exprs conditions = function_preconditions(tables, frame, stmt, {});
    if (!conditions.empty())
        then = next_if(b::all_of(conditions), std::move(then), next_configuration(block_thread(running), {}));
    return {nullptr, hidden_step(tables, frame, stmt, "read "), {}, std::move(then)};
}

/// Returns the branch `e.out` or `e.out!v`.
Branch send_event(const MachineTables& tables, const RunningThread& running, const ir::Stmt& stmt,
                  const b::Exprs& value) {
    const std::string& channel = tables.frames[running.frame()].events.at(stmt.communication.event.index);
    std::vector<cspm::Field> fields;
    if (!value.empty()) fields.push_back(b::output(value.front()));
    if (tables.machine().robosim)
        return {nullptr, register_write("o_" + channel), std::move(fields), finish_item(running, {})};
    return {nullptr, b::dot({b::name(channel), b::name("out")}), std::move(fields), finish_item(running, {})};
}

/// Returns the branch `e.in?x`, after which the value is stored (semantics 3.5).
Branch receive_event(MachineTables& tables, const RunningThread& running, const ir::Stmt& stmt) {
    const std::uint32_t frame = running.frame();
    const Project& project = tables.project();
    const ir::Communication& input = stmt.communication;
    const ir::TypeId type = *tables.frames[frame].machine->events.at(input.event.index).type;
    const CellId cell = tables.cells.of_statement(frame, stmt, 0, CellKind::frozen, "x__");
    Item store = running.head();
    store.kind = ItemKind::store;
    store.variable = input.variable;
    store.cells = {cell};
    const ir::TypeId variable = tables.frames[frame].machine->variables.at(input.variable.index).type;
    const ExprPtr value = received_as(project, b::name(received), type, variable, stmt.origin.span);
    ExprPtr from;
    if (input.predicate) {
        const Scope names = tables.frames.make_scope(frame, {}, value);
        b::Exprs conditions = translate_preconditions(project, names, *input.predicate);
        conditions.push_back(translate_expression(project, names, *input.predicate));
        from = b::set_comprehension({b::name(received)}, {b::generator(received, type_set(project, type)),
                                                          b::condition(b::all_of(conditions))});
    }
    return {nullptr,
            b::dot({b::name(tables.frames[frame].events.at(input.event.index)), b::name("in")}),
            {b::input(received, from)},
            next_configuration(running.replace(push_item(store, running.tail())), {{cell, value}})};
}

/// Writes a variable: by `set_x!v` if it is shared, and by a hidden step otherwise (semantics 3.7).
Branch write_variable(MachineTables& tables, const RunningThread& running, CellId id, const ExprPtr& value) {
    const Cell& cell = tables.cells[id];
    Next next = finish_item(running, {{id, value}});
    if (!cell.output.empty()) return {nullptr, register_write(cell.output), {b::output(value)}, std::move(next)};
    if (cell.shared) return {nullptr, b::name("set_" + cell.channel), {b::output(value)}, std::move(next)};
    if (const ir::Stmt* stmt = running.head().stmt)
        return {nullptr, hidden_step(tables, running.frame(), *stmt, ""), {}, std::move(next)};
    const EventMeaning meaning{MeaningKind::assignment, "store the received value in " + cell.meaning, {}, {}};
    return {nullptr, tables.events.step_event("store " + cell.name, meaning), {}, std::move(next)};
}

/// Returns the event of a statement that sends, calls or writes. Its fields are the values read before.
Branch event_of(MachineTables& tables, const RunningThread& running, const b::Exprs& values) {
    const ir::Stmt& stmt = *running.head().stmt;
    if (stmt.kind == StmtKind::communicate) return send_event(tables, running, stmt, values);
    if (stmt.kind == StmtKind::call) return call_event(tables, running, stmt, values);
    return write_variable(tables, running, tables.frames[running.frame()].variables.at(stmt.variable.index),
                          values.at(0));
}

Branch statement_branch(MachineTables& tables, const RunningThread& running, bool alone) {
    const ir::Stmt& stmt = *running.head().stmt;
    const std::uint32_t frame = running.frame();
    if (stmt.kind == StmtKind::exec) return end_cycle(running);
    if (!is_visible(tables, running, stmt)) {
        Next then = perform_statement(tables, running, {});
        return {nullptr, hidden_step(tables, frame, stmt, ""), {}, std::move(then)};
    }
    if (stmt.kind == StmtKind::communicate && stmt.communication.kind == CommKind::input)
        return receive_event(tables, running, stmt);
    if (stmt.kind == StmtKind::clock_reset) {
        Values changed;
        reset_clock(tables, frame, stmt.clock, changed);
        const ExprPtr event =
            b::dot({b::name("clockReset"), b::name(*tables.frames.reset_constructor(frame, stmt.clock))});
        return {nullptr, event, {}, finish_item(running, changed)};
    }
    const bool steady = is_stable(tables, frame, stmt, alone) && !reads_in_turn(tables, running, stmt);
    if (!steady) return freeze_values(tables, running, stmt);
    Branch result = event_of(tables, running, values_read(tables, frame, stmt));
    // Adds `pre &` for the preconditions of the functions that the statement uses.
    if (const b::Exprs conditions = function_preconditions(tables, frame, stmt, {}); !conditions.empty())
        result.guard = b::all_of(conditions);
    return result;
}

}  // namespace

std::optional<Next> silent_step(MachineTables& tables, const Activation& config, const Values& values, bool branching) {
    const View now = view_of(config);
    for (const RunningThread& waiting : now.calls)  // a called operation in its final state returns (semantics 3.8)
        if (is_final(tables, *waiting.thread().callee))
            return next_configuration(waiting.replace(waiting.thread().rest), values);
    const bool between = is_between_cycles(now);
    for (const RunningThread& running : now.threads)
        if (between && touches_registers(tables, running))
            continue;
        else if (auto result = silent_head(tables, running, config, values, now.threads.size() == 1, branching))
            return result;
    return std::nullopt;
}

std::optional<Branch> head_branch(MachineTables& tables, const RunningThread& running, bool alone) {
    const Item& item = running.head();
    switch (item.kind) {
        case ItemKind::statement:
            return statement_branch(tables, running, alone);
        case ItemKind::frozen: {
            b::Exprs values;
            for (const CellId cell : item.cells) values.push_back(tables.cells.parameter_name(cell));
            return event_of(tables, running, values);
        }
        case ItemKind::store:
            return write_variable(tables, running, tables.frames[running.frame()].variables.at(item.variable.index),
                                  tables.cells.parameter_name(item.cells.at(0)));
        case ItemKind::entered:
            return entered_branch(tables, running);
        case ItemKind::left:
        case ItemKind::shown:
            return left_branch(tables, running);
        case ItemKind::waiting:  // changes only with time
        case ItemKind::deadline_end:
        case ItemKind::enter:
        case ItemKind::join:
        case ItemKind::resume:
        case ItemKind::stuck:  // nothing more happens
            break;
    }
    return std::nullopt;
}

}  // namespace robochart::csp_emit
