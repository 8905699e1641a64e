// Time (semantics 3.10): one tock is one unit. A configuration lets time pass unless something in it is urgent: a
// hidden step, a call of a platform operation, a deadline that has run out. Clocks saturate one above the largest
// value they are compared with, waits and deadlines count down.
#include <algorithm>

#include "checker/cspm/syntax/build.hpp"
#include "csp_emit/machine/machine.hpp"
#include "csp_emit/base/types.hpp"
#include "semantics/ir/query.hpp"

namespace robochart::csp_emit {

namespace b = cspm::build;
using cspm::ExprPtr;
using Op = cspm::ExprKind;

namespace {

bool is_comparison(ir::ExprKind kind) {
    return kind == ir::ExprKind::equal || kind == ir::ExprKind::greater || kind == ir::ExprKind::greater_equal ||
           kind == ir::ExprKind::less || kind == ir::ExprKind::less_equal || kind == ir::ExprKind::not_equal;
}

const ir::Expr& without_casts(const ir::Expr& expr) {
    const ir::Expr* inner = &expr;
    while (inner->kind == ir::ExprKind::cast) inner = inner->args.at(0).get();
    return *inner;
}

/// What the named clock (or the clock of a state) is compared with in the machine's guards.
class ClockBounds {
public:
    ClockBounds(const ir::Machine& machine, std::string clock, ir::NodeId entry_of)
        : machine_(machine), clock_(std::move(clock)), entry_of_(entry_of) {}

    /// False if the clock is used otherwise than as a side of a comparison (rule TE4 forbids it).
    bool collect(std::vector<const ir::Expr*>& bounds) const {
        bool direct = true;
        for (const ir::Transition& transition : machine_.transitions)
            if (transition.guard) direct = visit(*transition.guard, bounds) && direct;
        return direct;
    }

private:
    bool is_clock(const ir::Expr& expr) const {
        if (expr.kind == ir::ExprKind::since_entry) return entry_of_.valid() && expr.node == entry_of_;
        return expr.kind == ir::ExprKind::since && machine_.clocks.at(expr.clock.index).name == clock_;
    }
    bool visit(const ir::Expr& expr, std::vector<const ir::Expr*>& bounds) const {
        if (is_clock(expr)) return false;
        bool direct = true;
        for (std::size_t i = 0; i < expr.args.size(); ++i) {
            const bool side = is_comparison(expr.kind) && is_clock(without_casts(*expr.args[i]));
            if (side)
                bounds.push_back(expr.args[1 - i].get());
            else
                direct = visit(*expr.args[i], bounds) && direct;
        }
        return direct;
    }
    const ir::Machine& machine_;
    std::string clock_;
    ir::NodeId entry_of_;
};

ExprPtr plus_one(const ExprPtr& value) {
    if (value->kind == Op::integer) return b::number(value->number + 1);
    return b::binary(Op::plus, value, b::number(1));
}

ExprPtr minus_one(const ExprPtr& value) {
    return b::binary(Op::minus, value, b::number(1));
}

}  // namespace

/// One above the largest value compared with: a number, or a function of the constants for other than literals.
ExprPtr MachineEmitter::clock_limit(const ir::Machine& opened, const std::string& clock, ir::NodeId entry_of) {
    std::int64_t literal = 0;
    b::Exprs sets;
    auto machines = callable();
    std::erase(machines, &opened);
    machines.insert(machines.begin(), &opened);
    for (const ir::Machine* checked : machines) {
        if (checked != &opened && entry_of.valid()) continue;
        std::vector<const ir::Expr*> bounds;
        if (!ClockBounds(*checked, clock, entry_of).collect(bounds))
            project().refuse("since(" + clock + ") outside a comparison", checked->origin.span);
        for (const ir::Expr* bound : bounds) {
            std::vector<cspm::Clause> variables;
            const ExprPtr value = clock_bound(*checked, *bound, variables);
            if (value->kind == Op::integer)
                literal = std::max(literal, value->number);
            else
                sets.push_back(variables.empty() ? b::set({value}) : b::set_comprehension({value}, variables));
        }
    }
    if (sets.empty()) return b::number(literal + 1);
    sets.push_back(b::set({b::number(literal)}));
    const std::string name = context_.names.unique("CLID_" + flatten(clock) + "_max");
    const ExprPtr largest = b::call("clock_type_max", {b::call("Union", {b::set(sets)})});
    clock_limits_.push_back(b::function_decl(name, b::variables(constants_inside()), plus_one(largest),
                                             "where clock " + clock + " saturates"));
    return call_of(name, constants_inside());
}

/// A bound in whole time units, rounded up; variables range over their types.
ExprPtr MachineEmitter::clock_bound(const ir::Machine& checked, const ir::Expr& bound,
                                    std::vector<cspm::Clause>& variables) const {
    Scope names;
    names.variable = [&](ir::VariableId id) {
        const std::string name = "b" + std::to_string(id.index) + "__";
        variables.push_back(b::generator(name, type_set(project(), checked.variables.at(id.index).type)));
        return b::name(name);
    };
    names.constant = [&](ir::ConstantId id) {
        const auto same = [&](const ConstantParameter& c) { return c.owner == &checked && c.id == id; };
        return b::name(std::find_if(constants_.begin(), constants_.end(), same)->inside);
    };
    names.placed = false;  // all values of a type, not those of a state
    names.clock = [](ir::ClockId) { return b::number(0); };
    names.entry_clock = [](ir::NodeId) { return b::number(0); };
    const std::int64_t scale = project().instantiation.scale;
    const ExprPtr value = expression(project(), names, bound);
    const bool real = bound.type.valid() && project().system.type(bound.type).kind == ir::TypeKind::real;
    if (!real || scale == 1) return value;
    if (value->kind == Op::integer) return b::number(value->number / scale + 1);
    return plus_one(b::binary(Op::divide, value, b::number(scale)));
}

/// Whether the thread's next event is hidden or urgent, so that time cannot pass before it.
bool MachineEmitter::stops_time(const Place& place, bool alone) const {
    const Item& item = place.head();
    if (item.kind == ItemKind::entered || item.kind == ItemKind::left) return true;
    if (item.kind == ItemKind::store)
        return !cells_[frames_[place.owner->frame].variables.at(item.variable.index)].shared;
    if (item.kind == ItemKind::frozen) return item.stmt->kind == ir::StmtKind::call;
    if (item.kind != ItemKind::statement) return false;
    const ir::Stmt& stmt = *item.stmt;
    if (!visible(place, stmt)) return true;
    if (stmt.kind == ir::StmtKind::call) return asked_by_call(place, alone).empty();
    const bool input = stmt.kind == ir::StmtKind::communicate && stmt.communication.kind == ir::CommKind::input;
    return !input && !stable(place.owner->frame, stmt, alone);
}

/// What is asked while a platform operation is being called: `pre & opCall`, which is urgent only where it is offered.
std::vector<ExprPtr> MachineEmitter::asked_by_call(const Place& place, bool alone) const {
    const Item& item = place.head();
    if (item.kind != ItemKind::statement || item.stmt->kind != ir::StmtKind::call) return {};
    const bool steady = stable(place.owner->frame, *item.stmt, alone) && !reads_in_turn(place, *item.stmt);
    return steady && visible(place, *item.stmt) ? asked(place.owner->frame, *item.stmt, {}) : std::vector<ExprPtr>{};
}

/// Deadlines still to be met: each must have time left, or time stops. So it does where an operation can be called.
std::vector<ExprPtr> MachineEmitter::time_conditions(const View& view) const {
    std::vector<ExprPtr> result;
    for (const Place& place : view.places)
        if (const auto conditions = asked_by_call(place, view.places.size() == 1); !conditions.empty())
            result.push_back(b::logical_not(b::all_of(conditions)));
    const auto left = [&](CellId cell) { return b::binary(Op::greater, b::name(cells_[cell].name), b::number(0)); };
    const auto deadlines = [&](const Program& program) {
        for (const Link* link = program.get(); link != nullptr; link = link->tail.get())
            if (link->head.kind == ItemKind::deadline_end) result.push_back(left(link->head.cells.at(0)));
    };
    for (const Place& call : view.calls) deadlines(call.thread->rest);
    for (const Place& place : view.places) deadlines(place.thread->rest);
    for (const auto& [cell, condition] : monitors(view, {})) {
        const bool always = condition->kind == Op::boolean && condition->number != 0;
        result.push_back(always ? left(cell) : b::any_of({b::logical_not(condition), left(cell)}));
    }
    return result;
}

/// The deadlines of transitions that run (semantics 3.10): the counter and the transition's guard.
std::vector<std::pair<CellId, ExprPtr>> MachineEmitter::monitors(const View& view, const Values& values) const {
    std::vector<std::pair<CellId, ExprPtr>> result;
    for (const Spot& spot : view.spots) {
        const std::uint32_t index = spot.activation->frame;
        for (const auto& [id, cell] : frames_[index].monitors) {
            const ir::Transition& transition = frames_[index].machine->transitions[id];
            const auto& entered = spot.activation->entered;
            if (std::find(entered.begin(), entered.end(), transition.source) == entered.end()) continue;
            // The monitor has no incoming value: it reads the variable (semantics 3.10).
            const bool receives = transition.trigger && transition.trigger->kind == ir::CommKind::input;
            const ExprPtr known =
                receives ? value_of(frames_[index].variables.at(transition.trigger->variable.index), values) : nullptr;
            result.emplace_back(cell, guard_of(index, transition, values, known));
        }
    }
    return result;
}

/// Whether something happens before time can pass.
bool MachineEmitter::urgent(const View& view) const {
    const bool alone = view.places.size() == 1;
    return std::any_of(view.places.begin(), view.places.end(),
                       [&](const Place& place) { return stops_time(place, alone); }) ||
           std::any_of(view.spots.begin(), view.spots.end(),
                       [&](const Spot& spot) { return has_urgent_transition(*spot.activation); });
}

void MachineEmitter::tock_branch(const Activation& config, const View& view, std::vector<ExprPtr>& out) {
    // Clocks of callers that are not in sight count on too (call_with).
    Values values;
    for (const Spot& spot : view.spots)
        for (const CellId cell : frames_[spot.activation->frame].own)
            if (cells_[cell].kind == CellKind::clock && cells_[cell].reading.empty())
                values[cell] = b::call("clock_step", {b::name(cells_[cell].name), cells_[cell].limit});
    const auto deadlines = [&](const Program& program) {
        for (const Link* link = program.get(); link != nullptr; link = link->tail.get())
            if (link->head.kind == ItemKind::deadline_end)
                values[link->head.cells.at(0)] = minus_one(b::name(cells_[link->head.cells.at(0)].name));
    };
    for (const Place& call : view.calls) deadlines(call.thread->rest);
    for (const Place& place : view.places) deadlines(place.thread->rest);
    for (const auto& [cell, condition] : monitors(view, {})) {
        const ExprPtr left = minus_one(b::name(cells_[cell].name));
        const bool always = condition->kind == Op::boolean && condition->number != 0;
        values[cell] = always ? left : b::if_(condition, left, monitor_bound(cell, {}));
    }
    after_tock_ = true;
    const ExprPtr tock = b::prefix(b::name("tock"), after_tock(config, values));
    after_tock_ = false;
    const std::vector<ExprPtr> conditions = time_conditions(view);
    out.push_back(conditions.empty() ? tock : b::guard(b::all_of(conditions), tock));
}

/// Waits get shorter; one that is over lets its thread go on. Each wait is decided in turn: `values` holds those done.
ExprPtr MachineEmitter::after_tock(const Activation& config, const Values& values) {
    const View now = view(config);
    for (const Place& place : now.places) {
        const Item& item = place.head();
        if (item.kind != ItemKind::waiting) continue;
        const Thread over{place.thread->rest->tail, nullptr};
        if (item.cells.empty()) return after_tock(place.put(over), values);
        if (values.count(item.cells[0]) != 0) continue;
        const ExprPtr left = b::name(cells_[item.cells[0]].name);
        Values shorter = values;
        shorter[item.cells[0]] = minus_one(left);
        return b::if_(b::binary(Op::greater, left, b::number(1)), after_tock(config, shorter),
                      after_tock(place.put(over), values));
    }
    return go(config, values);
}

ExprPtr MachineEmitter::start_wait(const Place& place, const ir::Stmt& stmt, const Program& rest,
                                   const Values& values) {
    if (!timed()) return go(place.put({rest, nullptr}), values);  // semantics 3.11
    const auto units = [&](const ir::Expr& expr) {
        const std::int64_t scale = project().instantiation.scale;
        const ExprPtr value = expression(project(), scope(place.owner->frame, values), expr);
        const bool real = expr.type.valid() && project().system.type(expr.type).kind == ir::TypeKind::real;
        return real && scale != 1 ? b::binary(Op::divide, value, b::number(scale)) : value;
    };
    if (stmt.kind == ir::StmtKind::wait) return wait_for(place, stmt, units(*stmt.value), rest, values);
    // The place is told where the interval is empty.
    cspm::Expr chosen = *b::replicated(Op::replicated_internal,
                                       {b::generator("d__", b::set_range(units(*stmt.value), units(*stmt.upper)))},
                                       wait_for(place, stmt, b::name("d__"), rest, values));
    chosen.span = stmt.origin.span;
    return std::make_shared<const cspm::Expr>(std::move(chosen));
}

ExprPtr MachineEmitter::wait_for(const Place& place, const ir::Stmt& stmt, const ExprPtr& units, const Program& rest,
                                 const Values& values) {
    const bool literal = units->kind == Op::integer;
    if (literal && units->number <= 0) return go(place.put({rest, nullptr}), values);
    if (units->kind == Op::negate) return go(place.put({rest, nullptr}), values);
    Item item = place.head();
    item.kind = ItemKind::waiting;
    item.stmt = &stmt;
    Values changed = values;
    if (!literal || units->number > 1) {
        item.cells = {cell_for(place.owner->frame, stmt, 0, CellKind::waiting, "w__")};
        changed[item.cells[0]] = units;
    }
    const ExprPtr waiting = go(place.put({push(item, rest), nullptr}), changed);
    if (literal) return waiting;
    return b::if_(b::binary(Op::greater, units, b::number(0)), waiting, go(place.put({rest, nullptr}), values));
}

/// The full time of a transition's deadline.
ExprPtr MachineEmitter::monitor_bound(CellId cell, const Values& values) const {
    for (std::uint32_t index = 0; index < frames_.size(); ++index)
        for (const auto& [id, monitor] : frames_[index].monitors)
            if (monitor == cell)
                return expression(project(), scope(index, values), *frames_[index].machine->transitions[id].deadline);
    return b::number(0);
}

}  // namespace robochart::csp_emit
