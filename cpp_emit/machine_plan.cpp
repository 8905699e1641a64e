#include "cpp_emit/machine_plan.hpp"

#include <algorithm>

#include "cpp_emit/walk.hpp"

namespace robochart::cpp_emit {

using ir::NodeId;
using ir::NodeKind;

MachinePlan::MachinePlan(const Generation&, const Unit& unit) : unit_(unit) {
    for (const auto& node : machine().nodes) labels_.push_back(places_.unique(node.path));
    for (const auto& node : machine().nodes) {
        const bool state = node.kind == NodeKind::state || node.kind == NodeKind::final;
        enter_.push_back(state ? places_.unique("enter_" + node.path) : "");
        exit_.push_back(node.kind == NodeKind::state ? places_.unique("exit_" + node.path) : "");
    }
    for (const auto& transition : machine().transitions) {
        const NodeId parent = node(transition.source).parent;
        const std::string scope = parent.valid() ? node(parent).path + "_" : "";
        take_.push_back(places_.unique("take_" + scope + transition.name));
    }
}

std::vector<NodeId> MachinePlan::chain(NodeId id) const {
    std::vector<NodeId> result;
    for (NodeId at = id; at.valid(); at = node(at).parent) result.push_back(at);
    return result;
}

std::vector<NodeId> MachinePlan::ancestors(NodeId id) const {
    return chain(node(id).parent);
}

bool MachinePlan::notes_entry(NodeId id) const {
    if (node(id).kind != NodeKind::state) return false;
    const ir::ClockId clock = entry_clock(machine(), id);
    return node(id).during != nullptr || watched(id) || (clock.valid() && unit_.clock_read[clock.index]);
}

bool MachinePlan::watched(NodeId id) const {
    const auto& outgoing = node(id).outgoing;
    return std::any_of(outgoing.begin(), outgoing.end(), [&](ir::TransitionId transition) {
        return machine().transitions[transition.index].deadline != nullptr;
    });
}

bool MachinePlan::needs_entry(NodeId id) const {
    if (!settles(id)) return node(id).kind == NodeKind::state;
    const std::vector<NodeId> around = chain(id);
    const auto noted = [&](NodeId state) { return notes_entry(state); };
    return node(id).entry != nullptr || std::any_of(around.begin(), around.end(), noted);
}

const std::string& MachinePlan::target(NodeId id) const {
    return needs_entry(id) ? enter_label(id) : label(id);
}

bool MachinePlan::shared_exit(NodeId id) const {
    const ir::Node& state = node(id);
    if (state.kind != NodeKind::state) return false;
    const std::vector<NodeId> around = ancestors(id);
    if (std::any_of(around.begin(), around.end(), [&](NodeId outer) { return !node(outer).outgoing.empty(); }))
        return true;
    return (state.composite() && !state.outgoing.empty()) || (state.exit != nullptr && state.outgoing.size() > 1);
}

bool MachinePlan::acts(const ir::Transition& transition) const {
    const bool exits_here = node(transition.source).exit != nullptr && !shared_exit(transition.source);
    return transition.action != nullptr || exits_here;
}

std::vector<NodeId> MachinePlan::leaves(NodeId id) const {
    if (!node(id).composite()) return settles(id) ? std::vector<NodeId>{id} : std::vector<NodeId>{};
    std::vector<NodeId> result;
    for (const NodeId child : node(id).children) {
        const std::vector<NodeId> below = leaves(child);
        result.insert(result.end(), below.begin(), below.end());
    }
    return result;
}

bool MachinePlan::has_shared_exits() const {
    for (std::uint32_t index = 0; index < machine().nodes.size(); ++index)
        if (shared_exit(NodeId{index})) return true;
    return false;
}

std::vector<NodeId> MachinePlan::finals() const {
    std::vector<NodeId> result;
    for (const NodeId id : machine().top)
        if (node(id).kind == NodeKind::final) result.push_back(id);
    return result;
}

}  // namespace robochart::cpp_emit
