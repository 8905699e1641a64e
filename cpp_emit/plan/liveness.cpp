// SPDX-License-Identifier: Apache-2.0
// Computes the live variables. A cycle ends in a state, in a junction without an enabled transition, or inside an
// action that waits. A variable is local if it is dead in all states and at all places that wait. It may be live in a
// junction whose guards read only variables that cannot change while control is in the junction. If no guard of such a
// junction is true when control reaches it, none becomes true later. So generated code leaves the junction only in a
// cycle in which the variable was written.
#include "cpp_emit/plan/liveness.hpp"

#include <algorithm>
#include <iterator>
#include <set>

#include "cpp_emit/plan/types.hpp"
#include "cpp_emit/plan/walk.hpp"

namespace robochart::cpp_emit {

using ir::ExprKind;
using ir::NodeId;
using ir::NodeKind;
using ir::StmtKind;
using ir::VariableId;

namespace {

using Variables = std::set<VariableId>;

void add(Variables& set, const Variables& more) {
    set.insert(more.begin(), more.end());
}

Variables read_by(const ir::ExprPtr& expr) {
    Variables result;
    visit(expr, [&](const ir::Expr& part) {
        if (part.kind == ExprKind::variable) result.insert(part.variable);
    });
    return result;
}

Variables read_by(const std::vector<ir::ExprPtr>& exprs) {
    Variables result;
    for (const ir::ExprPtr& expr : exprs) add(result, read_by(expr));
    return result;
}

/// Returns all variables that the program reads or writes.
Variables used_by(const ir::StmtPtr& program) {
    Variables result;
    visit(program, [&](const ir::Stmt& stmt) {
        for (const auto* expr :
             {&stmt.condition, &stmt.value, &stmt.upper, &stmt.communication.value, &stmt.communication.predicate})
            add(result, read_by(*expr));
        add(result, read_by(stmt.args));
        add(result, read_by(stmt.path));
        for (const VariableId written : {stmt.variable, stmt.communication.variable})
            if (written.is_valid()) result.insert(written);
    });
    return result;
}

class LiveVariables {
public:
    LiveVariables(const Component& component, const Unit& unit)
        : component_(component), unit_(unit), machine_(*unit.machine), at_(machine_.nodes.size()) {}

    /// Computes the variables that are live where a cycle may end, except at junctions that never continue.
    [[nodiscard]] Variables between_cycles() {
        for (bool changed = true; changed;) {
            changed = false;
            for (std::uint32_t index = 0; index < machine_.nodes.size(); ++index) {
                Variables live = on_arrival(NodeId{index});
                changed = changed || live.size() > at_[index].size();
                add(at_[index], live);
            }
        }
        Variables result = in_waiting_;
        for (const ir::Node& node : machine_.nodes) add(result, used_by(node.during));
        for (std::uint32_t index = 0; index < machine_.nodes.size(); ++index) {
            const NodeId id{index};
            if (node(id).kind == NodeKind::state) add(result, live_at_rest(id));
            if (may_block(id) && !blocks_for_ever(id)) add(result, at_[index]);
        }
        if (machine_.initial.is_valid()) add(result, at_[machine_.initial.index]);
        return result;
    }

    /// Returns the variables that are live at the node, if control may have to stay there.
    [[nodiscard]] Variables live_where_blocked(NodeId id) const { return may_block(id) ? at_[id.index] : Variables{}; }

private:
    [[nodiscard]] const ir::Node& node(NodeId id) const { return machine_.nodes[id.index]; }

    /// Returns the variables that are live when control reaches the node.
    Variables on_arrival(NodeId id) {
        const ir::Node& reached = node(id);
        switch (reached.kind) {
            case NodeKind::state:
                if (reached.initial.is_valid()) return before(reached.entry, at_[reached.initial.index]);
                return before(reached.entry, live_at_rest(id));
            case NodeKind::final:
                return live_at_rest(reached.parent);
            case NodeKind::initial:
            case NodeKind::junction:
            case NodeKind::probabilistic:
                break;
        }
        return before_ways(id);
    }

    /// Returns the variables that are live in the state or in one of its enclosing states.
    Variables live_at_rest(NodeId id) {
        Variables result;
        for (; id.is_valid(); id = node(id).parent) add(result, before_ways(id));
        return result;
    }

    Variables before_ways(NodeId id) {
        Variables result;
        for (const ir::TransitionId way : node(id).outgoing) add(result, before(machine_.transitions[way.index]));
        return result;
    }

    Variables before(const ir::Transition& transition) {
        Variables live = before(transition.action, at_[transition.target.index]);
        live = before(node(transition.source).exit, std::move(live));
        add_inner_exits(transition.source, live);
        if (transition.trigger && transition.trigger->variable.is_valid()) live.erase(transition.trigger->variable);
        for (const auto* expr : {&transition.guard, &transition.deadline, &transition.probability})
            add(live, read_by(*expr));
        if (!transition.trigger) return live;
        add(live, read_by(transition.trigger->predicate));
        if (transition.deadline && transition.trigger->variable.is_valid()) live.insert(transition.trigger->variable);
        return live;
    }

    /// Adds the variables that the exit actions of active inner states may use.
    void add_inner_exits(NodeId id, Variables& live) const {
        for (const NodeId child : node(id).children) {
            add(live, used_by(node(child).exit));
            add_inner_exits(child, live);
        }
    }

    Variables before(const ir::StmtPtr& stmt, Variables live) {
        if (!stmt) return live;
        const Variables after = live;
        live = before_statement(*stmt, std::move(live));
        if (!may_wait(*stmt)) return live;
        add(in_waiting_, live);
        // A received value is stored when the statement ends, and the action continues in the same cycle.
        const bool receives = stmt->kind == StmtKind::communicate && stmt->communication.kind == ir::CommKind::input;
        if (!receives) add(in_waiting_, after);
        return live;
    }

    Variables before_statement(const ir::Stmt& stmt, Variables live) {
        switch (stmt.kind) {
            case StmtKind::sequence:
                for (auto part = stmt.body.rbegin(); part != stmt.body.rend(); ++part)
                    live = before(*part, std::move(live));
                return live;
            case StmtKind::if_then_else: {
                Variables result = stmt.body.size() > 1 ? before(stmt.body[1], live) : live;
                add(result, before(stmt.body.at(0), std::move(live)));
                add(result, read_by(stmt.condition));
                return result;
            }
            case StmtKind::assign:
                if (stmt.path.empty()) live.erase(stmt.variable);
                break;
            case StmtKind::communicate:
                if (stmt.communication.variable.is_valid()) live.erase(stmt.communication.variable);
                break;
            case StmtKind::deadline:
                live = before(stmt.body.at(0), std::move(live));
                break;
            case StmtKind::skip:
            case StmtKind::call:
            case StmtKind::wait:
            case StmtKind::wait_interval:
            case StmtKind::clock_reset:
            case StmtKind::exec:  // RoboSim: no code is generated
            case StmtKind::choose:
                break;
        }
        add_own_reads(stmt, live);
        return live;
    }

    static void add_own_reads(const ir::Stmt& stmt, Variables& live) {
        for (const auto* expr : {&stmt.value, &stmt.upper, &stmt.communication.value, &stmt.communication.predicate})
            add(live, read_by(*expr));
        add(live, read_by(stmt.args));
        add(live, read_by(stmt.path));
        if (stmt.kind == StmtKind::assign && !stmt.path.empty()) live.insert(stmt.variable);
    }

    /// Returns whether a cycle may end inside the statement, or after it.
    [[nodiscard]] bool may_wait(const ir::Stmt& stmt) const {
        switch (stmt.kind) {
            case StmtKind::wait:
            case StmtKind::wait_interval:
            case StmtKind::deadline:
                return true;
            case StmtKind::communicate:
                return stmt.communication.kind == ir::CommKind::input ||
                       component_.find_event(unit_, stmt.communication.event).waits_to_send();
            case StmtKind::call:
                return unit_.definitions[stmt.operation.index].is_valid();
            case StmtKind::skip:
            case StmtKind::sequence:
            case StmtKind::if_then_else:
            case StmtKind::assign:
            case StmtKind::clock_reset:
            case StmtKind::exec:  // RoboSim: no code is generated
            case StmtKind::choose:
                break;
        }
        return false;
    }

    /// Returns whether control may have to stay in the node, because all outgoing transitions have guards.
    [[nodiscard]] bool may_block(NodeId id) const {
        const bool chooses = node(id).kind == NodeKind::initial || node(id).kind == NodeKind::junction;
        return chooses && std::ranges::all_of(node(id).outgoing, [&](ir::TransitionId way) {
                   return machine_.transitions[way.index].guard != nullptr;
               });
    }

    /// Returns whether all guards keep their values while control is in the node.
    [[nodiscard]] bool blocks_for_ever(NodeId id) const {
        bool result = true;
        for (const ir::TransitionId way : node(id).outgoing)
            visit(machine_.transitions[way.index].guard,
                  [&](const ir::Expr& part) { result = result && keeps_value(part); });
        return result;
    }

    [[nodiscard]] bool keeps_value(const ir::Expr& part) const {
        if (part.kind == ExprKind::variable)
            return machine_.variables[part.variable.index].scope == ir::VariableScope::local &&
                   std::ranges::none_of(machine_.nodes, [&](const ir::Node& other) {
                       return used_by(other.during).contains(part.variable);
                   });
        return part.kind != ExprKind::since && part.kind != ExprKind::since_entry && part.kind != ExprKind::call &&
               part.kind != ExprKind::function_value && part.kind != ExprKind::trigger_value;
    }

    const Component& component_;
    const Unit& unit_;
    const ir::Machine& machine_;
    std::vector<Variables> at_;  ///< by node: the variables that are live when control reaches it
    Variables in_waiting_;       ///< the variables that are live at a place that waits
};

/// Returns whether cycles may end at further places: at a false precondition of an operation, or because writes of
/// shared variables delay a machine.
bool ends_cycles_elsewhere(const Component& component) {
    return std::ranges::any_of(component.units,
                               [](const Unit& unit) { return !unit.machine->preconditions.empty(); }) ||
           std::ranges::any_of(component.variables,
                               [](const StoredVariable& variable) { return variable.memories > 0; });
}

/// Returns whether an operation uses the variable of the unit's machine.
bool is_lent(const Component& component, const Unit& owner, std::uint32_t place) {
    return std::ranges::any_of(component.units, [&](const Unit& unit) {
        return unit.number != owner.number &&
               std::ranges::find(unit.variable_owners, Owner{owner.number, place}) != unit.variable_owners.end();
    });
}

void find_local_variables(Component& component, const ir::System& system, Unit& unit) {
    const ir::Machine& machine = *unit.machine;
    LiveVariables liveness(component, unit);
    const Variables live = liveness.between_cycles();
    Variables local;
    for (std::uint32_t place = 0; place < machine.variables.size(); ++place) {
        const ir::Variable& variable = machine.variables[place];
        if (variable.scope != ir::VariableScope::local || live.contains(VariableId{place}) ||
            is_lent(component, unit, place) || !has_lists(system, variable.type))
            continue;
        local.insert(VariableId{place});
        component.variables[component.part_of(unit).variables.at(variable.name)].local = true;
    }
    unit.awaited_locals.resize(machine.nodes.size());
    for (std::uint32_t index = 0; index < machine.nodes.size(); ++index)
        std::ranges::set_intersection(liveness.live_where_blocked(NodeId{index}), local,
                                      std::back_inserter(unit.awaited_locals[index]));
}

}  // namespace

void find_local_variables(Component& component, const ir::System& system) {
    if (ends_cycles_elsewhere(component)) return;
    for (Unit& unit : component.units)
        if (unit.root) find_local_variables(component, system, unit);
}

}  // namespace robochart::cpp_emit
