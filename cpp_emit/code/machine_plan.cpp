// SPDX-License-Identifier: Apache-2.0
#include "cpp_emit/code/machine_plan.hpp"

#include <algorithm>
#include <cassert>

#include "cpp_emit/code/cycles.hpp"
#include "cpp_emit/code/suspension.hpp"
#include "cpp_emit/plan/walk.hpp"

namespace robochart::cpp_emit {

using ir::NodeId;
using ir::NodeKind;

MachinePlan::MachinePlan(const Generation& generation, const Unit& unit) : generation_(generation), unit_(unit) {
    for (const auto& node : machine().nodes) labels_.push_back(places_.unique_name(node.path));
    for (const auto& node : machine().nodes) {
        const bool state = node.kind == NodeKind::state || node.kind == NodeKind::final;
        enter_.push_back(state ? places_.unique_name("enter_" + node.path) : "");
        exit_.push_back(node.kind == NodeKind::state ? places_.unique_name("exit_" + node.path) : "");
    }
    for (const auto& transition : machine().transitions) {
        const NodeId parent = node(transition.source).parent;
        const std::string scope = parent.is_valid() ? node(parent).path + "_" : "";
        take_.push_back(places_.unique_name("take_" + scope + transition.name));
    }
    assert(labels_.size() == unit_.machine->nodes.size() && take_.size() == unit_.machine->transitions.size());
    assert(enter_.size() == labels_.size() && exit_.size() == labels_.size());
    straight_exits_.assign(machine().nodes.size(), true);
    for (std::uint32_t index = 0; index < machine().nodes.size(); ++index) {
        straight_.push_back(enters_straight(NodeId{index}));
        if (!may_wait(machine().nodes[index].exit)) continue;
        for (const NodeId around : state_chain(NodeId{index})) straight_exits_[around.index] = false;
    }
}

bool MachinePlan::may_wait(const ir::StmtPtr& program) const {
    return may_suspend(generation_, unit_, program);
}

bool MachinePlan::is_choice(NodeId id) const {
    return !is_resting_place(id) && node(id).kind != NodeKind::state;
}

/// Searches for a path from this junction through other junctions back to it.
bool MachinePlan::in_loop(NodeId id) const {
    std::vector<bool> seen(machine().nodes.size(), false);
    std::vector<NodeId> open = {id};
    while (!open.empty()) {
        const NodeId at = open.back();
        open.pop_back();
        for (const ir::TransitionId way : node(at).outgoing) {
            const NodeId next = machine().transitions[way.index].target;
            if (next == id) return true;
            if (!is_choice(next) || seen[next.index]) continue;
            seen[next.index] = true;
            open.push_back(next);
        }
    }
    return false;
}

bool MachinePlan::enters_straight(NodeId id) const {
    if (node(id).kind == NodeKind::probabilistic) return false;
    if (is_choice(id) && awaits_registers()) return false;
    return is_choice(id) ? !in_loop(id) : !may_wait(node(id).entry);
}

bool MachinePlan::is_passed_through(NodeId id) const {
    if (node(id).kind != NodeKind::initial || node(id).outgoing.size() != 1 || awaits_registers()) return false;
    const ir::Transition& only = machine().transitions[node(id).outgoing.front().index];
    return !only.guard && only.resets.empty();
}

bool MachinePlan::awaits_registers() const {
    return generation_.component.robosim && has_parallel_actions(generation_.component, unit_);
}

bool MachinePlan::has_exec() const {
    return std::ranges::any_of(machine().transitions, &ir::Transition::exec);
}

bool MachinePlan::exits_below(NodeId id) const {
    const auto& children = node(id).children;
    return std::ranges::any_of(children,
                               [&](NodeId child) { return node(child).exit != nullptr || exits_below(child); });
}

std::vector<NodeId> MachinePlan::state_chain(NodeId id) const {
    std::vector<NodeId> result;
    for (NodeId at = id; at.is_valid(); at = node(at).parent) result.push_back(at);
    return result;
}

std::vector<NodeId> MachinePlan::ancestors(NodeId id) const {
    return state_chain(node(id).parent);
}

bool MachinePlan::notes_entry(NodeId id) const {
    if (node(id).kind != NodeKind::state) return false;
    const ir::ClockId clock = entry_clock(machine(), id);
    return node(id).during != nullptr || is_watched(id) || (clock.is_valid() && unit_.clock_read[clock.index]);
}

bool MachinePlan::is_watched(NodeId id) const {
    const auto& outgoing = node(id).outgoing;
    return std::ranges::any_of(outgoing, [&](ir::TransitionId transition) {
        return machine().transitions[transition.index].deadline != nullptr;
    });
}

bool MachinePlan::needs_entry(NodeId id) const {
    if (!is_resting_place(id)) return node(id).kind == NodeKind::state;
    const std::vector<NodeId> around = state_chain(id);
    const auto noted = [&](NodeId state) { return notes_entry(state); };
    return node(id).entry != nullptr || std::ranges::any_of(around, noted);
}

bool MachinePlan::shared_exit(NodeId id) const {
    const ir::Node& state = node(id);
    if (state.kind != NodeKind::state) return false;
    const auto waits_while_left = [&](NodeId left) { return !node(left).outgoing.empty() && !straight_exits(left); };
    const std::vector<NodeId> around = ancestors(id);
    if (std::ranges::any_of(around, waits_while_left)) return true;
    return waits_while_left(id) && (state.is_composite() || state.outgoing.size() > 1);
}

bool MachinePlan::acts_after_trigger(const ir::Transition& transition) const {
    const bool exits_here = may_wait(node(transition.source).exit) && !shared_exit(transition.source);
    return may_wait(transition.action) || exits_here;
}

std::vector<NodeId> MachinePlan::resting_leaves(NodeId id) const {
    if (!node(id).is_composite()) return is_resting_place(id) ? std::vector<NodeId>{id} : std::vector<NodeId>{};
    std::vector<NodeId> result;
    for (const NodeId child : node(id).children) {
        const std::vector<NodeId> below = resting_leaves(child);
        result.insert(result.end(), below.begin(), below.end());
    }
    return result;
}

bool MachinePlan::has_noted_leaving() const {
    for (std::uint32_t index = 0; index < machine().nodes.size(); ++index)
        if (notes_leaving(NodeId{index})) return true;
    return false;
}

std::vector<NodeId> MachinePlan::final_nodes() const {
    std::vector<NodeId> result;
    for (const NodeId id : machine().top)
        if (node(id).kind == NodeKind::final) result.push_back(id);
    return result;
}

}  // namespace robochart::cpp_emit
