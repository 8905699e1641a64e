// SPDX-License-Identifier: Apache-2.0
// Determines which transitions can fire, and the programs that they run.
#include "csp_emit/machine/rules/transitions.hpp"

#include <algorithm>
#include <functional>
#include <utility>

#include "checker/cspm/syntax/build.hpp"
#include "csp_emit/base/types.hpp"
#include "csp_emit/machine/rules/shared_variables.hpp"
#include "semantics/ir/untimed_guards.hpp"

namespace robochart::csp_emit {

namespace b = cspm::build;
using cspm::ExprPtr;
using ir::CommKind;
using ir::NodeId;
using ir::NodeKind;

namespace {

const char* const incoming = "in__";  ///< the value that a trigger receives

bool has_kind(const ir::Expr& expr, ir::ExprKind kind) {
    return has_part(expr, [&](const ir::Expr& part) { return part.kind == kind; });
}

/// Calls `visit` on the statement and all its parts.
void walk_statements(const ir::Stmt& stmt, const std::function<void(const ir::Stmt&)>& visit) {
    visit(stmt);
    for (const auto& part : stmt.body) walk_statements(*part, visit);
}

bool is_inside(const ir::Machine& machine, NodeId node, NodeId composite) {
    for (NodeId above = machine.nodes[node.index].parent; above.is_valid(); above = machine.nodes[above.index].parent)
        if (above == composite) return true;
    return false;
}

/// True if the transition leaves a state below `source` that has an exit action.
bool has_inner_exit(const ir::Machine& machine, NodeId active, NodeId source) {
    for (NodeId node = active; node.is_valid() && node != source; node = machine.nodes[node.index].parent)
        if (machine.nodes[node.index].exit) return true;
    return false;
}

bool is_true(const ExprPtr& guard) {
    return guard->kind == cspm::ExprKind::boolean && guard->number != 0;
}

ExprPtr unless_true(const ExprPtr& guard) {
    return is_true(guard) ? nullptr : guard;
}

/// True if the order of the store of a trigger's value and an exit action matters. It matters if the store is visible
/// or the action uses the variable. A call of any defined operation counts as a use.
bool order_matters(const MachineTables& tables, std::uint32_t index, ir::VariableId variable, const ir::Stmt& exit) {
    bool found = tables.cells[tables.frames[index].variables.at(variable.index)].shared;
    const auto uses = [&](const ir::Expr& part) {
        return part.kind == ir::ExprKind::variable && part.variable == variable;
    };
    walk_statements(exit, [&](const ir::Stmt& stmt) {
        if (stmt.kind == ir::StmtKind::assign || stmt.kind == ir::StmtKind::communicate)
            found = found || stmt.variable == variable || stmt.communication.variable == variable;
        if (stmt.kind == ir::StmtKind::call)
            found = found || tables.frames.find_definition(index, stmt.operation) != nullptr;
        for (const ir::Expr* expr : expressions_of(stmt)) found = found || has_part(*expr, uses);
    });
    return found;
}

/// True if the store of the transition races with exit actions of states inside its source (semantics 3.4, step 4).
bool store_races(const MachineTables& tables, std::uint32_t index, const ir::Transition& transition) {
    const ir::Machine& machine = *tables.frames[index].machine;
    for (std::uint32_t i = 0; i < machine.nodes.size(); ++i)
        if (machine.nodes[i].exit && is_inside(machine, NodeId{i}, transition.source) &&
            order_matters(tables, index, transition.trigger->variable, *machine.nodes[i].exit))
            return true;
    return false;
}

Values reset_clocks(const MachineTables& tables, std::uint32_t index, const ir::Transition& transition) {
    const Frame& frame = tables.frames[index];
    Values result;
    for (const ir::ClockId clock : transition.resets) tables.watch.note_reset(frame, clock, result);
    for (const ir::ClockId clock : transition.resets)
        if (frame.clocks.at(clock.index) && tables.frames.reset_constructor(index, clock) == nullptr)
            result[*frame.clocks[clock.index]] = b::number(0);
    return result;
}

/// Returns an item for a part of the transition's effect. Apart from its kind, the item contains only a label.
Item item_of(const ir::Transition& transition, ItemKind kind) {
    Item item;
    item.kind = kind;
    item.label = "transition " + transition.name;
    return item;
}

Item statement_item(const ir::StmtPtr& stmt, const std::string& label) {
    Item item;
    item.stmt = stmt.get();
    item.label = label;
    return item;
}

/// Adds the exits of the active nodes up to the source, innermost first. If `join` is true, the source's exit waits for
/// the store that runs in parallel.
void add_exits(const MachineTables& tables, const Activation& activation, const ir::Transition& transition, bool join,
               std::vector<Item>& items) {
    const ir::Machine& left = *tables.frames[activation.frame].machine;
    for (NodeId node = activation.at; node.is_valid(); node = left.nodes[node.index].parent) {
        if (node == transition.source && join) {
            items.push_back(item_of(transition, ItemKind::join));
            items.back().node = transition.source;
        }
        const ir::StmtPtr& exit = left.nodes[node.index].exit;
        left_before(tables, exit, node, transition, items);
        if (exit) items.push_back(statement_item(exit, "exit action of " + left.nodes[node.index].path));
        if (node == transition.source) break;
    }
}

/// Returns the configuration in which the transition runs: `first`, resets, exits innermost first, action, target. If
/// exits of inner states race with `first`, the store of the trigger's value, the store is a separate thread, and the
/// exit of the source waits for it (semantics 3.4, step 4).
Activation leave_source(MachineTables& tables, const Activation& activation, ir::TransitionId id, Program first) {
    const ir::Machine& left = *tables.frames[activation.frame].machine;
    const ir::Transition& transition = left.transitions[id.index];
    const NodeId source = transition.source;
    std::vector<Item> items;
    const bool race = first && transition.trigger && has_inner_exit(left, activation.at, source) &&
                      store_races(tables, activation.frame, transition);
    for (; first; first = first->tail) items.push_back(first->head);
    for (const ir::ClockId clock : transition.resets) {
        if (tables.frames.reset_constructor(activation.frame, clock) == nullptr && !transition.exec) continue;
        items.push_back(item_of(transition, ItemKind::statement));
        items.back().stmt = tables.frames.reset_statement(activation.frame, id, clock);
    }
    const std::vector<Item> beside = race ? std::exchange(items, {}) : std::vector<Item>{};
    left_and_shown(tables, activation.frame, transition, items);
    add_exits(tables, activation, transition, race, items);
    left_before(tables, transition.action ? transition.action : left.nodes[transition.target.index].entry, source,
                transition, items);
    if (transition.action) items.push_back(statement_item(transition.action, "action of " + transition.name));
    items.push_back(item_of(transition, ItemKind::enter));
    items.back().node = transition.target;

    Activation result = activation;
    result.at = {};
    const auto is_left = [&](NodeId node) { return node == source || is_inside(left, node, source); };
    std::erase_if(result.entered, is_left);
    std::erase_if(result.durings, [&](const During& during) { return is_left(during.node); });
    if (race) result.durings.push_back({source, {program_of(beside), nullptr}});
    result.control = {program_of(items), nullptr};
    return result;
}

/// Returns the condition in this semantics (untimed or timed), or null if the transition has none.
ir::ExprPtr condition_in_time(const MachineTables& tables, const ir::Transition& transition) {
    return tables.timed() || !transition.guard_timed ? transition.guard : ir::untimed_guard(transition.guard).kept;
}

/// Fires a transition with a trigger: `g & e.in?x`. The received value is stored first.
Branch fire_trigger(MachineTables& tables, const RunningMachine& running, ir::TransitionId id) {
    const std::uint32_t index = running.activation->frame;
    const Project& project = tables.project();
    const ir::Machine& active = *tables.frames[index].machine;
    const ir::Transition& transition = active.transitions[id.index];
    const ir::Communication& trigger = *transition.trigger;
    const bool input = trigger.kind == CommKind::input;
    Branch result;
    result.event = b::dot({b::name(tables.frames[index].events.at(trigger.event.index)), b::name("in")});
    Values values = reset_clocks(tables, index, transition);
    Program first;
    ExprPtr value = b::name(incoming);
    if (input) {
        const ir::TypeId from = active.events.at(trigger.event.index).type.value();
        const ir::TypeId to = active.variables.at(trigger.variable.index).type;
        value = received_as(project, value, from, to, transition.origin.span);
    }
    const ir::ExprPtr stated = condition_in_time(tables, transition);
    const bool on_value = (stated && has_kind(*stated, ir::ExprKind::trigger_value)) || (trigger.predicate && input);
    if (input) {
        Item store = item_of(transition, ItemKind::store);
        store.variable = trigger.variable;
        store.cells = {tables.cells.of_trigger(index, id)};
        first = push_item(store, nullptr);
        values[store.cells[0]] = value;
    } else if (trigger.kind == CommKind::output) {
        project.report_unsupported("an output as trigger of " + transition.name, transition.origin.span);
    }
    result.next = next_configuration(running.replace(leave_source(tables, *running.activation, id, first)), values);
    if (!on_value) result.guard = unless_true(guard_of(tables, index, transition, {}, nullptr));
    if (!input && !trigger.value) return result;
    const ir::TypeId type = active.events.at(trigger.event.index).type.value();
    if (!input) {
        const Scope names = tables.frames.make_scope(index, {});
        result.fields = {b::output(expression_as(project, names, *trigger.value, type))};
        return result;
    }
    const ExprPtr condition = on_value ? guard_of(tables, index, transition, {}, value) : b::boolean(true);
    const ExprPtr from =
        is_true(condition) ? nullptr
                           : b::set_comprehension({b::name(incoming)}, {b::generator(incoming, type_set(project, type)),
                                                                        b::condition(condition)});
    result.fields = {b::input(incoming, from)};
    return result;
}

/// RoboSim: fires a transition. Without `exec` it is a hidden step. With `exec` it is `endexec`, and its effect follows
/// in the next cycle. The values of `$e?v` are those that made the condition true (docs/robosim.md).
Branch fire_in_cycle(MachineTables& tables, const RunningMachine& running, ir::TransitionId id) {
    const std::uint32_t index = running.activation->frame;
    const ir::Transition& transition = tables.frames[index].machine->transitions[id.index];
    Values values = transition.exec ? Values{} : reset_clocks(tables, index, transition);
    std::vector<Item> first;
    if (transition.exec) first.push_back(item_of(transition, ItemKind::resume));
    for (const ir::StmtPtr& stmt : transition.stores) {
        Item store = item_of(transition, ItemKind::store);
        store.variable = stmt->variable;
        store.cells = {tables.cells.of_statement(index, *stmt, 0, CellKind::frozen, "x__")};
        values[store.cells[0]] =
            translate_expression(tables.project(), tables.frames.make_scope(index, {}), *stmt->value);
        first.push_back(std::move(store));
    }
    return {unless_true(guard_of(tables, index, transition, {}, nullptr)),
            transition.exec ? b::name("endexec") : tables.events.transition_event(index, id),
            {},
            next_configuration(running.replace(leave_source(tables, *running.activation, id, program_of(first))),
                               std::move(values))};
}

}  // namespace

std::vector<ir::TransitionId> outgoing_transitions(const MachineTables& tables, const Activation& activation) {
    std::vector<ir::TransitionId> result;
    if (!is_settled(activation)) return result;
    const ir::Machine& active = *tables.frames[activation.frame].machine;
    const ir::Node& node = active.nodes[activation.at.index];
    result = node.outgoing;
    // While the active node is an initial node or a junction, the enclosing states cannot be left (semantics 3.3).
    const bool transient = node.kind != NodeKind::state && node.kind != NodeKind::final;
    for (NodeId above = node.parent; !transient && above.is_valid(); above = active.nodes[above.index].parent)
        for (const ir::TransitionId id : active.nodes[above.index].outgoing) result.push_back(id);
    return result;
}

bool has_urgent_transition(const MachineTables& tables, const Activation& activation) {
    const auto enabled = outgoing_transitions(tables, activation);
    return std::ranges::any_of(enabled, [&](ir::TransitionId id) {
        const ir::Transition& transition = tables.frames[activation.frame].machine->transitions[id.index];
        return !transition.trigger && !transition.guard;
    });
}

ExprPtr guard_of(const MachineTables& tables, std::uint32_t frame, const ir::Transition& transition,
                 const Values& values, const ExprPtr& trigger_value) {
    b::Exprs conditions;
    const Scope names = tables.frames.make_scope(frame, values, trigger_value);
    const auto add = [&](const ir::Expr& expr) {
        for (auto& condition : translate_preconditions(tables.project(), names, expr)) conditions.push_back(condition);
        conditions.push_back(translate_expression(tables.project(), names, expr));
    };
    if (const ir::ExprPtr condition = condition_in_time(tables, transition)) add(*condition);
    if (transition.trigger && transition.trigger->predicate && trigger_value) add(*transition.trigger->predicate);
    return b::all_of(conditions);
}

Branch fire_transition(MachineTables& tables, const RunningMachine& running, ir::TransitionId id) {
    const std::uint32_t index = running.activation->frame;
    const ir::Transition& transition = tables.frames[index].machine->transitions[id.index];
    if (transition.trigger) return fire_trigger(tables, running, id);
    if (tables.machine().robosim) return fire_in_cycle(tables, running, id);
    return {unless_true(guard_of(tables, index, transition, {}, nullptr)),
            tables.events.transition_event(index, id),
            {},
            next_configuration(running.replace(leave_source(tables, *running.activation, id, nullptr)),
                               reset_clocks(tables, index, transition))};
}

}  // namespace robochart::csp_emit
