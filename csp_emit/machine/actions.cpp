// Statements (semantics 3.5). A statement whose effect nobody can come between is done at once; one that reads or
// writes what others may touch is a step: RoboTool reads all variables of a statement at one moment and keeps what
// it read until the statement's event happens, so a value read is frozen in a cell of its own.
#include <algorithm>

#include "checker/cspm/syntax/build.hpp"
#include "csp_emit/machine/machine.hpp"
#include "csp_emit/base/types.hpp"

namespace robochart::csp_emit {

namespace b = cspm::build;
using cspm::ExprPtr;
using ir::CommKind;
using ir::StmtKind;

namespace {

const char* const received = "in__";

bool atomic(const ExprPtr& value) {
    return value->kind == cspm::ExprKind::name || value->kind == cspm::ExprKind::integer ||
           value->kind == cspm::ExprKind::boolean;
}

Item statement(const ir::StmtPtr& stmt, const std::string& label) {
    Item item;
    item.stmt = stmt.get();
    item.label = label;
    return item;
}

Thread running(Program rest) {
    return {std::move(rest), nullptr};
}

}  // namespace

/// The expressions that a statement evaluates, without those of its parts.
std::vector<const ir::Expr*> MachineEmitter::reads(const ir::Stmt& stmt) const {
    std::vector<const ir::Expr*> result;
    for (const auto& expr :
         {stmt.condition, stmt.value, stmt.upper, stmt.communication.value, stmt.communication.predicate})
        if (expr) result.push_back(expr.get());
    for (const auto& expr : stmt.args) result.push_back(expr.get());
    for (const auto& expr : stmt.path) result.push_back(expr.get());
    return result;
}

/// Whether nobody else can write what the statement reads.
bool MachineEmitter::stable(std::uint32_t frame, const ir::Stmt& stmt, bool alone) const {
    const auto unsteady = [&](const ir::Expr& part) {
        if (part.kind != ir::ExprKind::variable) return false;
        const Cell& cell = cells_[frames_[frame].variables.at(part.variable.index)];
        return cell.shared || (!alone && !cell.parameter);
    };
    const auto expressions = reads(stmt);
    return std::none_of(expressions.begin(), expressions.end(),
                        [&](const ir::Expr* expr) { return mentions(*expr, unsteady); });
}

/// Whether what the statement reads is held in names and literals, so that using it twice does not copy expressions.
bool MachineEmitter::light(std::uint32_t frame, const ir::Stmt& stmt, const Values& values) const {
    const auto heavy = [&](const ir::Expr& part) {
        if (part.kind != ir::ExprKind::variable) return false;
        const auto found = values.find(frames_[frame].variables.at(part.variable.index));
        return found != values.end() && !atomic(found->second);
    };
    auto expressions = reads(stmt);
    return std::none_of(expressions.begin(), expressions.end(),
                        [&](const ir::Expr* expr) { return mentions(*expr, heavy); });
}

/// Whether the statement is an event of the machine's alphabet.
bool MachineEmitter::visible(const Place& place, const ir::Stmt& stmt) const {
    const Frame& frame = frames_[place.owner->frame];
    if (stmt.kind == StmtKind::communicate) return true;
    if (stmt.kind == StmtKind::call) return !defined(place, stmt);
    if (stmt.kind == StmtKind::clock_reset) return announced(place.owner->frame, stmt.clock) != nullptr;
    return stmt.kind == StmtKind::assign && cells_[frame.variables.at(stmt.variable.index)].shared;
}

/// Does the first thing that needs no event, if there is one.
std::optional<ExprPtr> MachineEmitter::silent(const Activation& config, const Values& values) {
    if (config.frame != 0 && is_final(config)) return return_from(config.frame, values);
    const View now = view(config);
    for (const Place& call : now.calls)  // a called operation in its final state returns (semantics 3.8)
        if (is_final(*call.thread->callee)) return go(call.put(running(call.thread->rest)), values);
    for (const Place& place : now.places)
        if (auto result = silent_item(place, config, values, now.places.size() == 1)) return result;
    return std::nullopt;
}

std::optional<ExprPtr> MachineEmitter::silent_item(const Place& place, const Activation& config, const Values& values,
                                                   bool alone) {
    const Item& item = place.head();
    switch (item.kind) {
        case ItemKind::statement:
            return silent_statement(place, config, values, alone);
        case ItemKind::deadline_end:
            return go(place.put(running(place.thread->rest->tail)), values);
        case ItemKind::join: {
            const auto& beside = place.owner->durings;
            const bool done = std::none_of(beside.begin(), beside.end(),
                                           [&](const During& during) { return during.node == item.node; });
            if (done) return go(place.put(running(place.thread->rest->tail)), values);
            return std::nullopt;
        }
        case ItemKind::enter:
            return perform_enter(place, item, values);
        case ItemKind::entered:
            // States of called operations are not seen outside.
            if (place.owner->frame != 0) return perform_entered(place, item, values);
            return std::nullopt;
        case ItemKind::store: {
            const CellId target = frames_[place.owner->frame].variables.at(item.variable.index);
            if (cells_[target].shared || !alone || place.during) return std::nullopt;
            Values changed = values;
            changed[target] = value_of(item.cells.at(0), values);
            return go(place.put(running(place.thread->rest->tail)), changed);
        }
        default:
            return std::nullopt;
    }
}

std::optional<ExprPtr> MachineEmitter::silent_statement(const Place& place, const Activation& config,
                                                        const Values& values, bool alone) {
    const ir::Stmt& stmt = *place.head().stmt;
    const bool effect = stmt.kind == StmtKind::assign || stmt.kind == StmtKind::clock_reset;
    if (visible(place, stmt)) return std::nullopt;
    const bool about_time = stmt.kind == StmtKind::clock_reset || stmt.kind == StmtKind::wait ||
                            stmt.kind == StmtKind::wait_interval || stmt.kind == StmtKind::deadline;
    if (about_time && !timed()) return perform(place, values);  // dropped: semantics 3.11
    if (effect && (place.during || !alone)) return std::nullopt;
    if (!stable(place.owner->frame, stmt, alone)) return std::nullopt;
    // A second conditional after a first one would double the text each time: it gets a function of its own.
    const bool again = stmt.kind == StmtKind::if_then_else && branching_ > 0;
    if (again || !light(place.owner->frame, stmt, values)) return call_point(config, values);
    return perform(place, values);
}

/// The effect of the head statement, which is no event of the alphabet, and what follows.
ExprPtr MachineEmitter::perform(const Place& place, const Values& values) {
    const ir::Stmt& stmt = *place.head().stmt;
    const ExprPtr then = perform_statement(place, stmt, place.thread->rest->tail, values);
    const b::Exprs conditions = asked(place.owner->frame, stmt, values);
    if (conditions.empty()) return then;
    return b::if_(b::all_of(conditions), then, go(stuck(place), values));
}

/// The preconditions of the functions that the statement uses (semantics 3.5).
b::Exprs MachineEmitter::asked(std::uint32_t frame, const ir::Stmt& stmt, const Values& values) const {
    b::Exprs conditions;
    for (const ir::Expr* expr : reads(stmt))
        for (auto& condition : preconditions(project(), scope(frame, values), *expr)) conditions.push_back(condition);
    return conditions;
}

/// The thread does nothing more; deadlines around what it should do run out (semantics 3.10: `S <{d}` is interrupted
/// after d by a process in which time stops, whatever S does).
Activation MachineEmitter::stuck(const Place& place) {
    Item blocked = place.head();
    blocked.kind = ItemKind::stuck;
    blocked.cells.clear();
    std::vector<Item> items = {blocked};
    for (const Link* link = place.thread->rest->tail.get(); link != nullptr; link = link->tail.get())
        if (link->head.kind == ItemKind::deadline_end) items.push_back(link->head);
    Program program;
    for (auto item = items.rbegin(); item != items.rend(); ++item) program = push(*item, program);
    return place.put(running(program));
}

ExprPtr MachineEmitter::perform_statement(const Place& place, const ir::Stmt& stmt, const Program& rest,
                                          const Values& values) {
    const std::string& label = place.head().label;
    switch (stmt.kind) {
        case StmtKind::sequence: {
            Program all = rest;
            for (auto part = stmt.body.rbegin(); part != stmt.body.rend(); ++part)
                all = push(statement(*part, label), all);
            return go(place.put(running(all)), values);
        }
        case StmtKind::if_then_else: {
            const ExprPtr condition = expression(project(), scope(place.owner->frame, values), *stmt.condition);
            ++branching_;
            const ExprPtr then = go(place.put(running(push(statement(stmt.body.at(0), label), rest))), values);
            const Program other = stmt.body.size() > 1 ? push(statement(stmt.body[1], label), rest) : rest;
            const ExprPtr otherwise = go(place.put(running(other)), values);
            --branching_;
            return b::if_(condition, then, otherwise);
        }
        case StmtKind::assign:
            return perform_assignment(place, stmt, rest, values);
        case StmtKind::call:
            return perform_call(place, stmt, rest, values);
        case StmtKind::wait:
        case StmtKind::wait_interval:
            return start_wait(place, stmt, rest, values);
        case StmtKind::clock_reset: {
            Values changed = values;
            note_reset(frames_[place.owner->frame], stmt.clock, changed);
            if (timed() && frames_[place.owner->frame].clocks.at(stmt.clock.index))
                changed[*frames_[place.owner->frame].clocks[stmt.clock.index]] = b::number(0);
            return go(place.put(running(rest)), changed);
        }
        case StmtKind::deadline: {
            if (!timed()) return go(place.put(running(push(statement(stmt.body.at(0), label), rest))), values);
            const CellId cell = cell_for(place.owner->frame, stmt, 0, CellKind::deadline, "d__");
            Item end = place.head();
            end.kind = ItemKind::deadline_end;
            end.cells = {cell};
            Values changed = values;
            changed[cell] = expression(project(), scope(place.owner->frame, values), *stmt.value);
            return go(place.put(running(push(statement(stmt.body.at(0), label), push(end, rest)))), changed);
        }
        default:
            return go(place.put(running(rest)), values);
    }
}

ExprPtr MachineEmitter::perform_assignment(const Place& place, const ir::Stmt& stmt, const Program& rest,
                                           const Values& values) {
    Values changed = values;
    changed[frames_[place.owner->frame].variables.at(stmt.variable.index)] = assigned(place.owner->frame, stmt, values);
    return go(place.put(running(rest)), changed);
}

/// The new value of the assigned variable, of which the statement may give one part.
ExprPtr MachineEmitter::assigned(std::uint32_t frame, const ir::Stmt& stmt, const Values& values) const {
    const Scope names = scope(frame, values);
    const ir::Variable& variable = frames_[frame].machine->variables.at(stmt.variable.index);
    if (stmt.path.empty()) return expression_as(project(), names, *stmt.value, variable.type);
    const ExprPtr old = value_of(frames_[frame].variables.at(stmt.variable.index), values);
    b::Exprs path;
    for (const auto& step : stmt.path) path.push_back(expression(project(), names, *step));
    return component(project(), variable.type, old, path, expression(project(), names, *stmt.value));
}

void MachineEmitter::item_branches(const Place& place, bool alone, std::vector<ExprPtr>& out) {
    const Item& item = place.head();
    switch (item.kind) {
        case ItemKind::statement:
            statement_branches(place, alone, out);
            break;
        case ItemKind::frozen: {
            b::Exprs values;
            for (const CellId cell : item.cells) values.push_back(b::name(cells_[cell].name));
            const ir::Stmt& stmt = *item.stmt;
            const CellId target =
                stmt.kind == StmtKind::assign ? frames_[place.owner->frame].variables.at(stmt.variable.index) : 0;
            if (stmt.kind == StmtKind::communicate)
                out.push_back(communication(place, stmt, values.at(0)));
            else if (stmt.kind == StmtKind::call)
                out.push_back(call_event(place, stmt, values));
            else
                out.push_back(write(place, target, values.at(0), &stmt));
            break;
        }
        case ItemKind::store: {
            const CellId target = frames_[place.owner->frame].variables.at(item.variable.index);
            out.push_back(write(place, target, b::name(cells_[item.cells.at(0)].name), item.stmt));
            break;
        }
        case ItemKind::entered:
            entered_branch(place, out);
            break;
        case ItemKind::left:
            left_branch(place, out);
            break;
        default:
            break;  // a wait moves with time, a stuck thread never
    }
}

void MachineEmitter::statement_branches(const Place& place, bool alone, std::vector<ExprPtr>& out) {
    const ir::Stmt& stmt = *place.head().stmt;
    const std::uint32_t frame = place.owner->frame;
    const bool steady = stable(frame, stmt, alone) && !reads_in_turn(place, stmt);
    const bool input = stmt.kind == StmtKind::communicate && stmt.communication.kind == CommKind::input;
    if (!visible(place, stmt)) {
        out.push_back(step(frame, stmt, "", perform(place, {})));
    } else if (input) {
        out.push_back(reception(place, stmt));
    } else if (stmt.kind == StmtKind::clock_reset) {
        Values changed;
        const auto& cell = frames_[frame].clocks.at(stmt.clock.index);
        if (cell && cells_[*cell].reading.empty()) changed[*cell] = b::number(0);
        note_reset(frames_[frame], stmt.clock, changed);
        const ExprPtr event = b::dot({b::name("clockReset"), b::name(*announced(frame, stmt.clock))});
        out.push_back(b::prefix(event, go(place.put(running(place.thread->rest->tail)), changed)));
    } else if (!steady) {
        out.push_back(step(frame, stmt, "read ", freeze(place, stmt)));
    } else if (stmt.kind == StmtKind::communicate) {
        const ExprPtr value =
            stmt.communication.value
                ? expression_as(project(), scope(frame, {}), *stmt.communication.value,
                                *frames_[frame].machine->events.at(stmt.communication.event.index).type)
                : nullptr;
        out.push_back(guarded(frame, stmt, communication(place, stmt, value)));
    } else if (stmt.kind == StmtKind::call) {
        b::Exprs arguments;
        const auto& signature = frames_[frame].machine->operations.at(stmt.operation.index);
        for (std::size_t i = 0; i < stmt.args.size(); ++i)
            arguments.push_back(expression_as(project(), scope(frame, {}), *stmt.args[i], signature.parameters.at(i)));
        out.push_back(guarded(frame, stmt, call_event(place, stmt, arguments)));
    } else {
        const CellId target = frames_[frame].variables.at(stmt.variable.index);
        out.push_back(guarded(frame, stmt, write(place, target, assigned(frame, stmt, {}), &stmt)));
    }
}

/// `pre & process` for the functions that the statement uses (semantics 3.5).
ExprPtr MachineEmitter::guarded(std::uint32_t frame, const ir::Stmt& stmt, const ExprPtr& process) const {
    const b::Exprs conditions = asked(frame, stmt, {});
    return conditions.empty() ? process : b::guard(b::all_of(conditions), process);
}

/// All expressions of the statement are read at one moment and kept.
ExprPtr MachineEmitter::freeze(const Place& place, const ir::Stmt& stmt) {
    const std::uint32_t frame = place.owner->frame;
    Item item = place.head();
    item.kind = ItemKind::frozen;
    Values values;
    const auto keep = [&](const ExprPtr& value) {
        const CellId cell = cell_for(frame, stmt, item.cells.size(), CellKind::frozen, "x__");
        item.cells.push_back(cell);
        values[cell] = value;
    };
    const auto& target = *frames_[frame].machine;
    if (stmt.kind == StmtKind::assign) keep(assigned(frame, stmt, {}));
    if (stmt.kind == StmtKind::communicate)
        keep(expression_as(project(), scope(frame, {}), *stmt.communication.value,
                           *target.events.at(stmt.communication.event.index).type));
    for (std::size_t i = 0; i < stmt.args.size(); ++i)
        keep(expression_as(project(), scope(frame, {}), *stmt.args[i],
                           target.operations.at(stmt.operation.index).parameters.at(i)));
    const ExprPtr then = go(place.put(running(push(item, place.thread->rest->tail))), values);
    const b::Exprs conditions = asked(frame, stmt, {});
    if (conditions.empty()) return then;
    return b::if_(b::all_of(conditions), then, go(stuck(place), {}));
}

/// `e.out`, `e.out!v`.
ExprPtr MachineEmitter::communication(const Place& place, const ir::Stmt& stmt, const ExprPtr& value) {
    const Frame& frame = frames_[place.owner->frame];
    const std::string& channel = frame.events.at(stmt.communication.event.index);
    const ExprPtr next = go(place.put(running(place.thread->rest->tail)), {});
    const ExprPtr event = b::dot({b::name(channel), b::name("out")});
    if (value) return b::prefix(event, {b::output(value)}, next);
    return b::prefix(event, next);
}

/// `e.in?x`, then the value is stored (semantics 3.5).
ExprPtr MachineEmitter::reception(const Place& place, const ir::Stmt& stmt) {
    const std::uint32_t frame = place.owner->frame;
    const ir::Communication& input = stmt.communication;
    const ir::TypeId type = *frames_[frame].machine->events.at(input.event.index).type;
    const CellId cell = cell_for(frame, stmt, 0, CellKind::frozen, "x__");
    Item store = place.head();
    store.kind = ItemKind::store;
    store.variable = input.variable;
    store.cells = {cell};
    const ExprPtr next = go(place.put(running(push(store, place.thread->rest->tail))), {{cell, b::name(received)}});
    ExprPtr from;
    if (input.predicate) {
        const Scope names = scope(frame, {}, b::name(received));
        b::Exprs conditions = preconditions(project(), names, *input.predicate);
        conditions.push_back(expression(project(), names, *input.predicate));
        from = b::set_comprehension({b::name(received)}, {b::generator(received, type_set(project(), type)),
                                                          b::condition(b::all_of(conditions))});
    }
    const ExprPtr event = b::dot({b::name(frames_[frame].events.at(input.event.index)), b::name("in")});
    return b::prefix(event, {b::input(received, from)}, next);
}

/// Writes a variable: `set_x!v` if it is shared, a hidden step otherwise (semantics 3.7).
ExprPtr MachineEmitter::write(const Place& place, CellId cell, const ExprPtr& value, const ir::Stmt* stmt) {
    const ExprPtr next = go(place.put(running(place.thread->rest->tail)), {{cell, value}});
    if (cells_[cell].shared) return b::prefix(b::name("set_" + cells_[cell].channel), {b::output(value)}, next);
    if (stmt != nullptr) return step(place.owner->frame, *stmt, "", next);
    EventMeaning meaning{MeaningKind::assignment, "store the received value in " + cells_[cell].meaning, {}, {}};
    return b::prefix(step_event("store " + cells_[cell].name, meaning), next);
}

/// A hidden step of a statement: `step__.n -> then`.
ExprPtr MachineEmitter::step(std::uint32_t frame, const ir::Stmt& stmt, const std::string& what, const ExprPtr& then) {
    EventMeaning meaning;
    meaning.kind = what.empty() && stmt.kind == StmtKind::assign ? MeaningKind::assignment : MeaningKind::step;
    const std::string text = project().text(stmt.origin.span);
    meaning.text = what + (text.empty() ? stmt.origin.element : text);
    meaning.origin = stmt.origin;
    const std::string place = what + std::to_string(frame) + ":" + std::to_string(stmt.point);
    return b::prefix(step_event(place, meaning), then);
}

ExprPtr MachineEmitter::step_event(const std::string& place, const EventMeaning& meaning) {
    const auto [found, added] = step_of_.try_emplace(place, step_of_.size());
    const std::string number = std::to_string(found->second);
    if (added) mean("step__." + number, meaning);
    return b::dot({b::name("step__"), b::number(static_cast<std::int64_t>(found->second))});
}

}  // namespace robochart::csp_emit
