// Transitions (semantics 3.4): all enabled ones of the active node and of its active ancestors stand in one external
// choice; then trigger, store, clock resets, exits innermost first, action, entry, each in its turn.
#include <algorithm>
#include <utility>

#include "checker/cspm/syntax/build.hpp"
#include "csp_emit/machine/machine.hpp"
#include "csp_emit/base/rules.hpp"
#include "csp_emit/base/types.hpp"

namespace robochart::csp_emit {

namespace b = cspm::build;
using cspm::ExprPtr;
using ir::CommKind;
using ir::NodeId;
using ir::NodeKind;

namespace {

const char* const received = "in__";

bool has_kind(const ir::Expr& expr, ir::ExprKind kind) {
    return mentions(expr, [&](const ir::Expr& part) { return part.kind == kind; });
}

/// Calls `visit` on the statement and all its parts.
void walk_statements(const ir::Stmt& stmt, const std::function<void(const ir::Stmt&)>& visit) {
    visit(stmt);
    for (const auto& part : stmt.body) walk_statements(*part, visit);
}

bool inside(const ir::Machine& machine, NodeId node, NodeId composite) {
    for (NodeId above = machine.nodes[node.index].parent; above.valid(); above = machine.nodes[above.index].parent)
        if (above == composite) return true;
    return false;
}

Program program_of(const std::vector<Item>& items) {
    Program program;
    for (auto item = items.rbegin(); item != items.rend(); ++item) program = push(*item, program);
    return program;
}

/// Whether a state below `source` that is left has an exit action.
bool has_inner_exit(const ir::Machine& machine, NodeId active, NodeId source) {
    for (NodeId node = active; node.valid() && node != source; node = machine.nodes[node.index].parent)
        if (machine.nodes[node.index].exit) return true;
    return false;
}

bool is_true(const ExprPtr& guard) {
    return guard->kind == cspm::ExprKind::boolean && guard->number != 0;
}

}  // namespace

/// The guard with the preconditions of its functions; `true` if there is none, and untimed if it speaks of time.
ExprPtr MachineEmitter::guard_of(std::uint32_t frame, const ir::Transition& transition, const Values& values,
                                 ExprPtr trigger_value) const {
    b::Exprs conditions;
    const Scope names = scope(frame, values, trigger_value);
    const auto add = [&](const ir::Expr& expr) {
        for (auto& condition : preconditions(project(), names, expr)) conditions.push_back(condition);
        conditions.push_back(expression(project(), names, expr));
    };
    const bool counts = transition.guard && (timed() || !transition.guard_timed);
    if (counts) add(*transition.guard);
    if (transition.trigger && transition.trigger->predicate && trigger_value) add(*transition.trigger->predicate);
    return b::all_of(conditions);
}

Values MachineEmitter::reset_clocks(const Frame& frame, const ir::Transition& transition) const {
    Values result;
    for (const ir::ClockId clock : transition.resets) note_reset(frame, clock, result);
    for (const ir::ClockId clock : transition.resets)
        if (frame.clocks.at(clock.index) && (frame.announced.empty() || frame.announced[clock.index].empty()))
            result[*frame.clocks[clock.index]] = b::number(0);
    return result;
}

/// A reset on a transition as a statement, where it is an event.
const ir::Stmt* MachineEmitter::reset_statement(std::uint32_t frame, ir::TransitionId id, ir::ClockId clock) {
    const auto [found, added] = reset_statements_.try_emplace({frame, id.index, clock.index});
    if (added) {
        const ir::Machine& owner = *frames_[frame].machine;
        found->second.kind = ir::StmtKind::clock_reset;
        found->second.clock = clock;
        found->second.origin = owner.transitions[id.index].origin;
        const auto clocks = static_cast<std::uint32_t>(owner.clocks.size());
        found->second.point = owner.points + id.index * clocks + clock.index;  // none of the machine's own
    }
    return &found->second;
}

/// The configuration in which the transition runs: `first`, resets, exits innermost first, action, target. Where exits
/// of inner states race with `first`, the store of the trigger's value, it is a thread of its own that the exit of the
/// source waits for (semantics 3.4, step 4).
Activation MachineEmitter::leave(const Activation& activation, ir::TransitionId id, Program first) {
    const ir::Machine& left = *frames_[activation.frame].machine;
    const ir::Transition& transition = left.transitions[id.index];
    const NodeId source = transition.source;
    std::vector<Item> items;
    const bool race =
        first && frames_[activation.frame].racing.contains(id.index) && has_inner_exit(left, activation.at, source);
    for (; first; first = first->tail) items.push_back(first->head);
    for (const ir::ClockId clock : transition.resets) {
        if (announced(activation.frame, clock) == nullptr) continue;
        Item reset;
        reset.stmt = reset_statement(activation.frame, id, clock);
        reset.label = "transition " + transition.name;
        items.push_back(reset);
    }
    const std::vector<Item> beside = race ? std::exchange(items, {}) : std::vector<Item>{};
    for (NodeId node = activation.at; node.valid(); node = left.nodes[node.index].parent) {
        if (node == source && race) {
            Item join;
            join.kind = ItemKind::join;
            join.node = source;
            join.label = "transition " + transition.name;
            items.push_back(join);
        }
        left_before(left.nodes[node.index].exit, node, transition, items);
        if (left.nodes[node.index].exit) {
            Item exit;
            exit.stmt = left.nodes[node.index].exit.get();
            exit.label = "exit action of " + left.nodes[node.index].path;
            items.push_back(exit);
        }
        if (node == source) break;
    }
    const ir::StmtPtr& next = transition.action ? transition.action : left.nodes[transition.target.index].entry;
    left_before(next, source, transition, items);
    if (transition.action) {
        Item action;
        action.stmt = transition.action.get();
        action.label = "action of " + transition.name;
        items.push_back(action);
    }
    Item enter;
    enter.kind = ItemKind::enter;
    enter.node = transition.target;
    enter.label = "transition " + transition.name;
    items.push_back(enter);

    Activation result = activation;
    result.at = {};
    const auto gone = [&](NodeId node) { return node == source || inside(left, node, source); };
    std::erase_if(result.entered, gone);
    std::erase_if(result.durings, [&](const During& during) { return gone(during.node); });
    if (race) result.durings.push_back({source, {program_of(beside), nullptr}});
    result.control = {program_of(items), nullptr};
    return result;
}

/// The transitions of a running machine that is settled: of its active node and of all states around it.
std::vector<ir::TransitionId> MachineEmitter::candidates(const Activation& activation) const {
    std::vector<ir::TransitionId> result;
    if (!settled(activation)) return result;
    const ir::Machine& active = *frames_[activation.frame].machine;
    const ir::Node& node = active.nodes[activation.at.index];
    result = node.outgoing;
    // While the active node is an initial node or a junction, nothing around it can be left (semantics 3.3).
    const bool transient = node.kind != NodeKind::state && node.kind != NodeKind::final;
    for (NodeId above = node.parent; !transient && above.valid(); above = active.nodes[above.index].parent)
        for (const ir::TransitionId id : active.nodes[above.index].outgoing) result.push_back(id);
    return result;
}

void MachineEmitter::transition_branches(const Spot& spot, std::vector<ExprPtr>& out) {
    for (const ir::TransitionId id : candidates(*spot.activation)) out.push_back(fire(spot, id));
}

/// Whether a transition without trigger and without condition is enabled: it fires before time passes.
bool MachineEmitter::has_urgent_transition(const Activation& activation) const {
    const auto enabled = candidates(activation);
    return std::any_of(enabled.begin(), enabled.end(), [&](ir::TransitionId id) {
        const ir::Transition& transition = frames_[activation.frame].machine->transitions[id.index];
        return !transition.trigger && !transition.guard;
    });
}

ExprPtr MachineEmitter::fire(const Spot& spot, ir::TransitionId id) {
    const std::uint32_t index = spot.activation->frame;
    const ir::Transition& transition = frames_[index].machine->transitions[id.index];
    if (transition.trigger) return fire_trigger(spot, id);
    const ExprPtr guard = guard_of(index, transition, {}, nullptr);
    const ExprPtr event = transition_event(index, id);
    const ExprPtr next = go(spot.put(leave(*spot.activation, id, nullptr)), reset_clocks(frames_[index], transition));
    return is_true(guard) ? b::prefix(event, next) : b::guard(guard, b::prefix(event, next));
}

/// The hidden event of a transition without trigger: `internal__.TID_t`.
ExprPtr MachineEmitter::transition_event(std::uint32_t frame, ir::TransitionId id) {
    const auto [found, added] = transition_of_.try_emplace({frame, id.index});
    const ir::Machine& owner = *frames_[frame].machine;
    const ir::Transition& transition = owner.transitions[id.index];
    if (added) {
        found->second = context_.names.unique("TID_" + frames_[frame].prefix + flatten(transition.name));
        EventMeaning meaning;
        meaning.kind = MeaningKind::transition;
        meaning.text = transition.name + ": " + owner.nodes[transition.source.index].path + " -> " +
                       owner.nodes[transition.target.index].path;
        meaning.origin = transition.origin;
        // Constructors are printed with the module they belong to.
        mean("internal__." + context_.path + "::" + found->second, meaning);
    }
    return b::dot({b::name("internal__"), b::name(found->second)});
}

/// Where the value that a trigger brings waits for its store.
CellId MachineEmitter::trigger_cell(std::uint32_t frame, ir::TransitionId id) {
    const auto [found, added] = trigger_cells_.try_emplace({frame, id.index});
    if (added) {
        Cell cell;
        cell.kind = CellKind::frozen;
        cell.name = "x__";
        cell.meaning = "value received";
        found->second = add_cell(cell);
    }
    return found->second;
}

/// `g & e.in?x:{x | x <- T, guard(x)}`: values that fail the guard are refused, not consumed.
ExprPtr MachineEmitter::fire_trigger(const Spot& spot, ir::TransitionId id) {
    const std::uint32_t index = spot.activation->frame;
    const ir::Machine& active = *frames_[index].machine;
    const ir::Transition& transition = active.transitions[id.index];
    const ir::Communication& trigger = *transition.trigger;
    const ExprPtr event = b::dot({b::name(frames_[index].events.at(trigger.event.index)), b::name("in")});
    Values values = reset_clocks(frames_[index], transition);
    Program first;
    const bool on_value = (transition.guard && has_kind(*transition.guard, ir::ExprKind::trigger_value)) ||
                          (trigger.predicate && trigger.kind == CommKind::input);
    if (trigger.kind == CommKind::input) {
        Item store;
        store.kind = ItemKind::store;
        store.variable = trigger.variable;
        store.label = "transition " + transition.name;
        store.cells = {trigger_cell(index, id)};
        first = push(store, nullptr);
        values[store.cells[0]] = b::name(received);
    } else if (trigger.kind == CommKind::output) {
        project().refuse("an output as trigger of " + transition.name, transition.origin.span);
    }
    const ExprPtr next = go(spot.put(leave(*spot.activation, id, first)), values);
    const ExprPtr guard =
        on_value && (timed() || !transition.guard_timed) ? b::boolean(true) : guard_of(index, transition, {}, nullptr);
    ExprPtr branch;
    if (trigger.kind == CommKind::input) {
        const ir::TypeId type = active.events.at(trigger.event.index).type.value();
        ExprPtr from;
        if (on_value) {
            const ExprPtr condition = guard_of(index, transition, {}, b::name(received));
            if (!is_true(condition))
                from = b::set_comprehension(
                    {b::name(received)}, {b::generator(received, type_set(project(), type)), b::condition(condition)});
        }
        branch = b::prefix(event, {b::input(received, from)}, next);
    } else if (trigger.value) {
        const ir::TypeId type = active.events.at(trigger.event.index).type.value();
        branch = b::prefix(event, {b::output(expression_as(project(), scope(index, {}), *trigger.value, type))}, next);
    } else {
        branch = b::prefix(event, next);
    }
    return is_true(guard) ? branch : b::guard(guard, branch);
}

/// Whether the order of the store of a trigger's value and of an exit action matters: the store is seen, or the action
/// uses the variable; what an operation does with it is not looked at.
bool MachineEmitter::races(const Frame& frame, ir::VariableId variable, const ir::Stmt& exit) const {
    bool found = cells_[frame.variables.at(variable.index)].shared;
    const auto uses = [&](const ir::Expr& part) {
        return part.kind == ir::ExprKind::variable && part.variable == variable;
    };
    walk_statements(exit, [&](const ir::Stmt& stmt) {
        if (stmt.kind == ir::StmtKind::assign || stmt.kind == ir::StmtKind::communicate)
            found = found || stmt.variable == variable || stmt.communication.variable == variable;
        if (stmt.kind == ir::StmtKind::call) found = found || definition_of(frame, stmt.operation) != nullptr;
        for (const ir::Expr* expr : reads(stmt)) found = found || mentions(*expr, uses);
    });
    return found;
}

/// The transitions whose store races with exit actions of states inside their source (semantics 3.4, step 4).
void MachineEmitter::find_races(Frame& frame) {
    const ir::Machine& checked = *frame.machine;
    for (std::uint32_t id = 0; id < checked.transitions.size(); ++id) {
        const ir::Transition& transition = checked.transitions[id];
        if (!transition.trigger || transition.trigger->kind != CommKind::input) continue;
        for (std::uint32_t i = 0; i < checked.nodes.size(); ++i)
            if (checked.nodes[i].exit && inside(checked, NodeId{i}, transition.source) &&
                races(frame, transition.trigger->variable, *checked.nodes[i].exit))
                frame.racing.insert(id);
    }
}

}  // namespace robochart::csp_emit
