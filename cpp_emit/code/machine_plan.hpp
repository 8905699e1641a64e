// The places of a machine's control: what its nodes and transitions are called in code and which of them need
// code of their own (semantics 3.3, 3.4).
#pragma once

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
    [[nodiscard]] const ir::Node& node(ir::NodeId id) const { return machine().nodes[id.index]; }

    /// Where control rests in a state or final node, or chooses in an initial node or junction.
    [[nodiscard]] const std::string& label(ir::NodeId id) const { return labels_[id.index]; }
    [[nodiscard]] const std::string& enter_label(ir::NodeId id) const { return enter_[id.index]; }
    [[nodiscard]] const std::string& exit_label(ir::NodeId id) const { return exit_[id.index]; }
    [[nodiscard]] const std::string& take_label(ir::TransitionId id) const { return take_[id.index]; }
    /// There is something to do when the node is entered, before control rests or chooses there.
    [[nodiscard]] bool needs_entry(ir::NodeId) const;
    /// Control gets into the node, as far as the node's own program goes, in one go: a function does it. Otherwise the
    /// program has places where it may wait, or the junction is part of a loop, which takes a step a round.
    [[nodiscard]] bool straight(ir::NodeId id) const { return straight_[id.index]; }
    /// No exit action of the state and of those below it ever waits.
    [[nodiscard]] bool straight_exits(ir::NodeId id) const { return straight_exits_[id.index]; }
    /// An exit action somewhere below the composite state.
    [[nodiscard]] bool exits_below(ir::NodeId) const;
    /// The only transition of an initial node, without trigger and guard: whoever enters takes it.
    [[nodiscard]] bool passes(ir::NodeId) const;

    /// Control rests here between transitions.
    [[nodiscard]] bool settles(ir::NodeId id) const {
        return node(id).kind == ir::NodeKind::final || (node(id).kind == ir::NodeKind::state && !node(id).composite());
    }
    /// The state has an exit place that several transitions share: some exit action may wait.
    [[nodiscard]] bool shared_exit(ir::NodeId) const;
    /// Frame::leaving says which transition of the state goes on after the exits.
    [[nodiscard]] bool notes_leaving(ir::NodeId id) const { return shared_exit(id) && !straight_exits(id); }
    /// The transition has an exit or an action that may wait, to run after its trigger at take_label.
    [[nodiscard]] bool acts(const ir::Transition&) const;
    /// Something happens when the state is entered: during action, clock of sinceEntry, deadline.
    [[nodiscard]] bool notes_entry(ir::NodeId) const;
    /// The state must be left in time: some transition out of it has a deadline.
    [[nodiscard]] bool watched(ir::NodeId) const;
    /// The state and the states around it, innermost first.
    [[nodiscard]] std::vector<ir::NodeId> chain(ir::NodeId) const;
    /// The states around a node, innermost first.
    [[nodiscard]] std::vector<ir::NodeId> ancestors(ir::NodeId) const;
    /// Nodes in which control rests, below a composite state or the state itself.
    [[nodiscard]] std::vector<ir::NodeId> leaves(ir::NodeId) const;
    [[nodiscard]] bool has_noted_leaving() const;
    /// Final nodes at top level: the machine has terminated.
    [[nodiscard]] std::vector<ir::NodeId> finals() const;
    [[nodiscard]] NameScope& place_labels() { return places_; }

private:
    [[nodiscard]] bool waits(const ir::StmtPtr&) const;
    [[nodiscard]] bool chooses(ir::NodeId) const;
    [[nodiscard]] bool in_loop(ir::NodeId) const;
    [[nodiscard]] bool enters_straight(ir::NodeId) const;

    const Generation& generation_;
    const Unit& unit_;
    NameScope places_;
    std::vector<std::string> labels_, enter_, exit_, take_;
    std::vector<bool> straight_, straight_exits_;
};

}  // namespace robochart::cpp_emit
