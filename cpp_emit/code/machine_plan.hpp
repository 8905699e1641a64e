// SPDX-License-Identifier: Apache-2.0
// Plans the control points of a machine. Chooses names for its nodes and transitions, and decides which of them need a
// separate piece of code (semantics 3.3, 3.4).
#pragma once

#include <cassert>
#include <string>
#include <vector>

#include "cpp_emit/expressions/generation.hpp"
#include "cpp_emit/plan/names.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::cpp_emit {

class MachinePlan {
public:
    MachinePlan(const Generation&, const Unit&);

    [[nodiscard]] const ir::Machine& machine() const { return *unit_.machine; }
    [[nodiscard]] const ir::Node& node(ir::NodeId id) const {
        assert(id.index < unit_.machine->nodes.size());
        return machine().nodes[id.index];
    }

    /// Returns the label of a node. Control rests at the label of a state or final node. At the label of an initial
    /// node or junction, it chooses a transition.
    [[nodiscard]] const std::string& label_of(ir::NodeId id) const { return labels_[id.index]; }
    [[nodiscard]] const std::string& enter_label(ir::NodeId id) const { return enter_[id.index]; }
    [[nodiscard]] const std::string& exit_label(ir::NodeId id) const { return exit_[id.index]; }
    [[nodiscard]] const std::string& take_label(ir::TransitionId id) const { return take_[id.index]; }
    /// Returns true if an action must run before control, on entering the node, reaches this label.
    [[nodiscard]] bool needs_entry(ir::NodeId) const;
    /// Returns true if control always runs from the entry of the node to the end of its program without waiting. The
    /// entry is then a function. False if the program may wait, or if the node is a junction in a loop, which takes one
    /// step in each round.
    [[nodiscard]] bool is_straight(ir::NodeId id) const { return straight_[id.index]; }
    /// Returns true if no exit action of the state, or of a state inside it, can wait.
    [[nodiscard]] bool straight_exits(ir::NodeId id) const { return straight_exits_[id.index]; }
    /// Returns whether some inner state of the composite state has an exit action.
    [[nodiscard]] bool exits_below(ir::NodeId) const;
    /// Returns true if the node is an initial node with a single transition that has no trigger, no guard and no reset
    /// of a clock. The code then takes the transition together with the entry.
    [[nodiscard]] bool is_passed_through(ir::NodeId) const;

    /// For RoboSim: returns true if transitions from junctions may have to wait, because a during action may have ended
    /// the cycle.
    [[nodiscard]] bool awaits_registers() const;
    /// For RoboSim: returns true if a transition ends the cycle. Frame::next then stores this transition until the next
    /// cycle.
    [[nodiscard]] bool has_exec() const;

    /// Returns whether control rests in the node between transitions.
    [[nodiscard]] bool is_resting_place(ir::NodeId id) const {
        return node(id).kind == ir::NodeKind::final ||
               (node(id).kind == ir::NodeKind::state && !node(id).is_composite());
    }
    /// Returns true if several transitions share one place for the state's exits, because an exit action may wait.
    [[nodiscard]] bool shared_exit(ir::NodeId) const;
    /// Returns true if Frame::leaving must store which transition of the state continues after the exits.
    [[nodiscard]] bool notes_leaving(ir::NodeId id) const { return shared_exit(id) && !straight_exits(id); }
    /// Returns true if the transition's action may wait, or an exit action of its source that has no shared place
    /// (shared_exit). The code then runs these actions at take_label.
    [[nodiscard]] bool acts_after_trigger(const ir::Transition&) const;
    /// Returns true if entering the state does something: it starts a during action, a clock of sinceEntry, or a
    /// deadline.
    [[nodiscard]] bool notes_entry(ir::NodeId) const;
    /// Returns true if an outgoing transition has a deadline, by which the state must be left.
    [[nodiscard]] bool is_watched(ir::NodeId) const;
    /// Returns the state and its enclosing states, innermost first.
    [[nodiscard]] std::vector<ir::NodeId> state_chain(ir::NodeId) const;
    /// Returns the enclosing states of a node, innermost first.
    [[nodiscard]] std::vector<ir::NodeId> ancestors(ir::NodeId) const;
    /// Returns the nodes in which control rests: the state itself, or the leaves inside a composite state.
    [[nodiscard]] std::vector<ir::NodeId> resting_leaves(ir::NodeId) const;
    [[nodiscard]] bool has_noted_leaving() const;
    /// Returns the final nodes at the top level. In these nodes, the machine has terminated.
    [[nodiscard]] std::vector<ir::NodeId> final_nodes() const;
    [[nodiscard]] NameScope& place_labels() { return places_; }

private:
    [[nodiscard]] bool may_wait(const ir::StmtPtr&) const;
    [[nodiscard]] bool is_choice(ir::NodeId) const;
    [[nodiscard]] bool in_loop(ir::NodeId) const;
    [[nodiscard]] bool enters_straight(ir::NodeId) const;

    const Generation& generation_;
    const Unit& unit_;
    NameScope places_;
    std::vector<std::string> labels_, enter_, exit_, take_;
    std::vector<bool> straight_, straight_exits_;
};

}  // namespace robochart::cpp_emit
