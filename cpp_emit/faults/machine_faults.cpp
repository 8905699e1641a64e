// SPDX-License-Identifier: Apache-2.0
#include "cpp_emit/faults/machine_faults.hpp"

#include <algorithm>

#include "cpp_emit/faults/statement_faults.hpp"
#include "cpp_emit/plan/walk.hpp"

namespace robochart::cpp_emit {

using ir::NodeId;
using ir::NodeKind;

namespace {

class MachineFaults {
public:
    MachineFaults(const ir::System& system, const ir::Instantiation& inst, const Component& component, const Unit& unit,
                  Mutation& mutation)
        : component_(component),
          unit_(unit),
          mutation_(mutation),
          statements_(system, inst, component, unit, mutation),
          machine_(*unit.machine) {}

    ir::Machine write_machine() {
        for (ir::Node& node : machine_.nodes) rewrite(node);
        for (ir::Transition& transition : machine_.transitions) rewrite(transition);
        for (const ir::Node& node : machine_.nodes)
            if (node.kind == NodeKind::probabilistic) exchange_ways(node);
        for (ir::ExprPtr& condition : machine_.preconditions) {
            condition = statements_.expressions().rewrite(condition);
            if (mutation_.hits(Fault::precondition_negated)) condition = negate_condition(condition);
        }
        return std::move(machine_);
    }

private:
    void rewrite(ir::Node& node) {
        node.entry = statements_.rewrite(node.entry);
        node.during = statements_.rewrite(node.during);
        node.exit = statements_.rewrite(node.exit);
        if (node.entry && mutation_.hits(Fault::entry_dropped)) node.entry = nullptr;
        if (node.exit && mutation_.hits(Fault::exit_dropped)) node.exit = nullptr;
        if (node.during && mutation_.hits(Fault::during_never)) node.during = nullptr;
        if (node.during && mutation_.hits(Fault::during_again)) node.during = statements_.run_again(node.during);
        if (node.kind == NodeKind::probabilistic || node.outgoing.size() < 2) return;
        const bool state = node.kind == NodeKind::state;
        if (mutation_.hits(state ? Fault::transitions_reversed : Fault::junction_reversed))
            std::ranges::reverse(node.outgoing);
    }

    void rewrite(ir::Transition& transition) {
        rewrite_guard(transition);
        transition.probability = statements_.expressions().rewrite(transition.probability);
        if (transition.trigger) rewrite_trigger(transition);
        rewrite_resets(transition);
        rewrite_deadline(transition);
        transition.action = statements_.rewrite(transition.action);
        if (transition.action && mutation_.hits(Fault::action_dropped)) transition.action = nullptr;
        const NodeId other = next_sibling(transition.target);
        if (other.is_valid() && mutation_.hits(Fault::wrong_target)) transition.target = other;
    }

    void rewrite_guard(ir::Transition& transition) {
        if (!transition.guard) return;
        transition.guard = statements_.expressions().rewrite(transition.guard);
        if (asks_for_value(*transition.guard) && has_place(transition.trigger->variable) &&
            mutation_.hits(Fault::trigger_value_old))
            transition.guard = with_old_value(transition.guard, transition.trigger->variable);
        if (mutation_.hits(Fault::guard_negated)) transition.guard = negate_condition(transition.guard);
        if (mutation_.hits(Fault::guard_dropped)) transition.guard = nullptr;
    }

    /// Rewrites a trigger. If a deadline depends on a guard over the received value, the trigger must name the
    /// variable.
    void rewrite_trigger(ir::Transition& transition) {
        const ir::VariableId stored = transition.trigger->variable;
        statements_.rewrite_reception(*transition.trigger);
        if (transition.deadline && transition.guard && asks_for_value(*transition.guard))
            transition.trigger->variable = stored;
    }

    [[nodiscard]] static bool asks_for_value(const ir::Expr& guard) {
        bool result = false;
        ir::visit_operands(guard,
                           [&](const ir::Expr& part) { result = result || part.kind == ir::ExprKind::trigger_value; });
        return result;
    }

    [[nodiscard]] bool has_place(ir::VariableId variable) const {
        if (!variable.is_valid()) return false;
        const StoredVariable* const stored = component_.stored_variable(unit_, variable);
        return stored == nullptr || stored->has_member();
    }

    /// Returns the guard with the variable in place of the incoming value.
    [[nodiscard]] static ir::ExprPtr with_old_value(const ir::ExprPtr& expr, ir::VariableId variable) {
        if (!expr) return expr;
        ir::Expr changed = *expr;
        if (changed.kind == ir::ExprKind::trigger_value) {
            changed.kind = ir::ExprKind::variable;
            changed.variable = variable;
        }
        for (ir::ExprPtr& part : changed.args) part = with_old_value(part, variable);
        return std::make_shared<ir::Expr>(std::move(changed));
    }

    void rewrite_resets(ir::Transition& transition) {
        std::vector<ir::ClockId> remaining;
        for (const ir::ClockId clock : transition.resets)
            if (!statements_.has_effect(clock) || !mutation_.hits(Fault::clock_not_reset)) remaining.push_back(clock);
        transition.resets = std::move(remaining);
    }

    void rewrite_deadline(ir::Transition& transition) {
        transition.deadline = statements_.expressions().rewrite(transition.deadline);
        const bool watched = machine_.nodes[transition.source.index].kind == NodeKind::state;
        if (!transition.deadline || !watched) return;
        transition.deadline =
            mutation_.hits(Fault::deadline_ignored) ? nullptr : statements_.rewrite_bound(transition.deadline);
    }

    /// Returns the next state after a node in the same parent, cyclically; invalid if there is no other state.
    [[nodiscard]] NodeId next_sibling(NodeId target) const {
        const NodeId parent = machine_.nodes[target.index].parent;
        const auto& siblings = parent.is_valid() ? machine_.nodes[parent.index].children : machine_.top;
        std::vector<NodeId> others;
        for (const NodeId id : siblings)
            if (id != target && machine_.nodes[id.index].kind == NodeKind::state) others.push_back(id);
        if (others.empty()) return {};
        const auto next = std::ranges::find_if(others, [&](NodeId id) { return id > target; });
        return next == others.end() ? others.front() : *next;
    }

    /// Gives one alternative of a probabilistic junction the effect of the next one.
    void exchange_ways(const ir::Node& node) {
        const std::vector<ir::Transition> right = machine_.transitions;
        for (std::size_t way = 0; way < node.outgoing.size(); ++way) {
            if (!mutation_.hits(Fault::way_exchanged)) continue;
            const ir::Transition& other = right[node.outgoing[(way + 1) % node.outgoing.size()].index];
            ir::Transition& changed = machine_.transitions[node.outgoing[way].index];
            changed.target = other.target;
            changed.resets = other.resets;
            changed.action = other.action;
        }
    }

    const Component& component_;
    const Unit& unit_;
    Mutation& mutation_;
    StatementFaults statements_;
    ir::Machine machine_;
};

}  // namespace

ir::Machine faulty_machine(const ir::System& system, const ir::Instantiation& inst, const Component& component,
                           const Unit& unit, Mutation& mutation) {
    return MachineFaults(system, inst, component, unit, mutation).write_machine();
}

}  // namespace robochart::cpp_emit
