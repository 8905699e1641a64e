// SPDX-License-Identifier: Apache-2.0
#include "semantics/data/uses.hpp"

#include <algorithm>
#include <utility>

#include "semantics/data/inlining.hpp"
#include "semantics/ir/visit.hpp"

namespace robochart::ir {
namespace {

class UseCollector {
public:
    UseCollector(const System& system, const Sampling& sampling, Places& places, Computed computed)
        : system_(system), sampling_(sampling), places_(places), computed_(computed) {}

    std::map<PlaceId, Uses> collect() {
        for (std::uint32_t m = 0; m < system_.machines.size(); ++m) collect_machine(MachineId{m});
        std::map<PlaceId, Uses> result;
        for (auto& [place, uses] : uses_) merge(result[places_.class_of(place)], std::move(uses));
        return result;
    }

private:
    void collect_machine(MachineId id);
    void collect_transition(const Transition& transition);
    void collect_statement(const Stmt& stmt);
    void collect_communication(const Communication& communication);
    void write(PlaceId target, const ExprPtr& expr, bool initial = false);
    void write_part(const Stmt& stmt);
    void read_guard(const ExprPtr& expr);
    void read_condition(const ExprPtr& expr);
    void read_values(const ExprPtr& expr, KeepReason why);
    void needs_values(PlaceId place, KeepReason why, const Expr& expr) {
        if (!uses_[place].needs_values) uses_[place].needs_values = Keep{why, expr.span};
    }
    [[nodiscard]] std::set<PlaceId> places_read(const Expr& expr) const;
    [[nodiscard]] bool may_be_undefined(const ExprPtr& expr) const {
        return sampling_.may_be_undefined(machine_, expr);
    }
    [[nodiscard]] PlaceId place_of(const Expr& expr) const { return places_.read_by(machine_, trigger_, expr); }
    static void merge(Uses& all, Uses&& more);

    const System& system_;
    const Sampling& sampling_;
    Places& places_;
    Computed computed_;
    MachineId machine_;
    PlaceId trigger_ = no_id;  ///< the place whose received value guards and predicates read
    std::map<PlaceId, Uses> uses_;
};

void UseCollector::merge(Uses& all, Uses&& more) {
    all.conditions.insert(all.conditions.end(), more.conditions.begin(), more.conditions.end());
    all.writes.insert(all.writes.end(), more.writes.begin(), more.writes.end());
    all.entries.insert(all.entries.end(), more.entries.begin(), more.entries.end());
    if (!all.needs_values) all.needs_values = more.needs_values;
}

std::set<PlaceId> UseCollector::places_read(const Expr& root) const {
    std::set<PlaceId> result;
    visit_operands(root, [&](const Expr& expr) {
        if (const PlaceId place = place_of(expr); place != no_id) result.insert(place);
    });
    return result;
}

void UseCollector::read_values(const ExprPtr& expr, KeepReason why) {
    if (!expr) return;
    for (const PlaceId place : places_read(*expr)) needs_values(place, why, *expr);
}

/// Reads a condition that is not a guard. If such a condition is undefined, the machine stops.
void UseCollector::read_condition(const ExprPtr& expr) {
    if (expr && may_be_undefined(expr))
        read_values(expr, KeepReason::undefined);
    else
        read_guard(expr);
}

/// Reads a guard. If it reads only one place, it is one condition on that place. Otherwise each operand of a connective
/// is a condition. A guard with a call that may be undefined is not divided, because it is then false as a whole.
void UseCollector::read_guard(const ExprPtr& expr) {
    if (!expr) return;
    const std::set<PlaceId> read = places_read(*expr);
    if (read.empty()) return;
    if (read.size() == 1 && !mentions_clock(*expr)) {
        // `condition else` shares the conditions of the other transitions.
        std::vector<Condition>& conditions = uses_[*read.begin()].conditions;
        if (std::ranges::find(conditions, expr.get(), &Condition::expr) == conditions.end())
            conditions.push_back({expr.get(), machine_, inline_calls(system_, expr)});
        return;
    }
    if (!is_connective(expr->kind) || may_be_undefined(expr))
        return read_values(expr, read.size() == 1 ? KeepReason::clock : KeepReason::other_data);
    for (const ExprPtr& part : expr->args) read_guard(part);
}

void UseCollector::write(PlaceId target, const ExprPtr& expr, bool initial) {
    if (!expr) return;
    if (const PlaceId source = place_of(*expr); source != no_id) {
        places_.unite(source, target);
        return;
    }
    if (system_.type(expr->type).kind == TypeKind::boolean) return read_condition(expr);
    Written written{expr.get(), machine_, sampling_.closed_value(machine_, *expr).has_value(), initial, {}};
    if (!written.closed) written.reads = places_read(*expr);
    const bool exact = computed_ == Computed::exactly && !written.closed;
    if (exact && may_be_undefined(expr)) needs_values(target, KeepReason::undefined, *expr);
    if (exact && mentions_clock(*expr)) needs_values(target, KeepReason::clock, *expr);
    uses_[target].writes.push_back(std::move(written));
}

/// Reads an assignment to a part of a variable. It counts as a computation of the new value from the old
/// one.
void UseCollector::write_part(const Stmt& stmt) {
    const PlaceId target = places_.variable(machine_, stmt.variable);
    if (computed_ == Computed::exactly) {
        for (const ExprPtr& step : stmt.path) read_values(step, KeepReason::selector);
        needs_values(target, KeepReason::part, *stmt.value);
        return read_values(stmt.value, KeepReason::part);
    }
    Written written{stmt.value.get(), machine_, false, false, places_read(*stmt.value)};
    for (const ExprPtr& step : stmt.path) written.reads.merge(places_read(*step));
    uses_[target].writes.push_back(std::move(written));
}

void UseCollector::collect_communication(const Communication& communication) {
    const PlaceId carried = places_.event(machine_, communication.event);
    trigger_ = carried;
    read_condition(communication.predicate);
    trigger_ = no_id;
    if (carried == no_id) return;
    if (communication.variable.is_valid()) places_.unite(carried, places_.variable(machine_, communication.variable));
    write(carried, communication.value);
}

void UseCollector::collect_statement(const Stmt& stmt) {
    read_condition(stmt.condition);
    read_values(stmt.upper, KeepReason::time);
    if (stmt.kind == StmtKind::assign && stmt.path.empty())
        write(places_.variable(machine_, stmt.variable), stmt.value);
    else if (stmt.kind == StmtKind::assign)
        write_part(stmt);
    else
        read_values(stmt.value, KeepReason::time);
    if (stmt.kind == StmtKind::communicate) {
        collect_communication(stmt.communication);
        const PlaceId carried = places_.event(machine_, stmt.communication.event);
        if (stmt.communication.variable.is_valid() && carried != no_id) uses_[carried].entries.push_back(nullptr);
    }
    for (std::size_t i = 0; i < stmt.args.size(); ++i)
        write(places_.parameter(machine_, stmt.operation, i), stmt.args[i]);
}

void UseCollector::collect_transition(const Transition& transition) {
    if (transition.trigger) collect_communication(*transition.trigger);
    trigger_ = places_.trigger(machine_, transition);
    if (transition.trigger) {
        if (transition.trigger->variable.is_valid() && trigger_ != no_id) {
            const bool alone = transition.guard && places_read(*transition.guard) == std::set<PlaceId>{trigger_} &&
                               !mentions_clock(*transition.guard);
            uses_[trigger_].entries.push_back(alone ? transition.guard.get() : nullptr);
        }
    }
    read_guard(transition.guard);
    read_values(transition.probability, KeepReason::probability);
    read_values(transition.deadline, KeepReason::time);
    trigger_ = no_id;
    for (const StmtPtr& store : transition.stores) collect_statement(*store);
    if (transition.action) visit_statements(*transition.action, [&](const Stmt& stmt) { collect_statement(stmt); });
}

void UseCollector::collect_machine(MachineId id) {
    machine_ = id;
    const Machine& machine = system_.machine(id);
    for (std::uint32_t v = 0; v < machine.variables.size(); ++v) {
        const PlaceId place = places_.variable(id, VariableId{v});
        if (machine.variables[v].initial)
            write(place, machine.variables[v].initial, true);
        else
            uses_[place].writes.push_back({nullptr, id, true, true, {}});
    }
    for (const auto* conditions : {&machine.preconditions, &machine.postconditions})
        for (const ExprPtr& condition : *conditions) read_values(condition, KeepReason::contract);
    for (const Node& node : machine.nodes)
        for (const auto* action : {&node.entry, &node.during, &node.exit})
            if (*action) visit_statements(**action, [&](const Stmt& stmt) { collect_statement(stmt); });
    for (const Transition& transition : machine.transitions) collect_transition(transition);
}

}  // namespace

std::map<PlaceId, Uses> collect_uses(const System& system, const Sampling& sampling, Places& places,
                                     Computed computed) {
    return UseCollector(system, sampling, places, computed).collect();
}

}  // namespace robochart::ir
