// SPDX-License-Identifier: Apache-2.0
// Enters nodes and states.
#include "csp_emit/machine/rules/states.hpp"

#include <algorithm>

#include "checker/cspm/syntax/build.hpp"

namespace robochart::csp_emit {

namespace b = cspm::build;
using ir::NodeId;
using ir::NodeKind;

namespace {

/// Returns the enclosing composite states that have not been entered yet, innermost first.
std::vector<NodeId> not_entered_around(const ir::Machine& machine, const Activation& activation, NodeId node) {
    std::vector<NodeId> result;
    for (NodeId above = machine.nodes[node.index].parent; above.is_valid(); above = machine.nodes[above.index].parent)
        if (std::ranges::find(activation.entered, above) == activation.entered.end()) result.push_back(above);
    return result;
}

/// True if the node is the state itself or inside it.
bool is_within(const ir::Machine& machine, NodeId node, NodeId state) {
    while (node.is_valid() && node != state) node = machine.nodes[node.index].parent;
    return node.is_valid();
}

/// Finds the running machine of the frame. This is necessary after each change of the configuration, to find the owner
/// of a thread again.
const RunningMachine* machine_of(const View& view, std::uint32_t frame) {
    const auto found = std::ranges::find_if(
        view.machines, [&](const RunningMachine& running) { return running.activation->frame == frame; });
    return found == view.machines.end() ? nullptr : &*found;
}

/// Adds the state to the entered states and its during action to the running ones.
void put_entered(const ir::Machine& machine, NodeId id, Activation& activation) {
    const ir::Node& node = machine.nodes[id.index];
    const auto outer = [&](NodeId other) {
        for (NodeId above = node.parent; above.is_valid(); above = machine.nodes[above.index].parent)
            if (above == other) return true;
        return false;
    };
    activation.entered.insert(std::ranges::find_if_not(activation.entered, outer), id);
    if (node.kind != NodeKind::state || !node.during) return;
    Item first;
    first.stmt = node.during.get();
    first.label = "during action of " + node.path;
    const auto behind_outer =
        std::ranges::find_if_not(activation.durings, [&](const During& during) { return outer(during.node); });
    activation.durings.insert(behind_outer, {id, {push_item(first, nullptr), nullptr}});
}

}  // namespace

bool is_final(const MachineTables& tables, const Activation& activation) {
    if (!is_settled(activation)) return false;
    const ir::Node& node = tables.frames[activation.frame].machine->nodes[activation.at.index];
    return node.kind == NodeKind::final && !node.parent.is_valid();
}

bool is_in(const MachineTables& tables, const Activation& activation, NodeId state) {
    const ir::Machine& machine = *tables.frames[activation.frame].machine;
    const auto& entered = activation.entered;
    if (std::ranges::find(entered, state) != entered.end()) return true;
    if (is_within(machine, activation.at, state)) return true;
    // After a transition from its initial node the state is entered together with its first inner state.
    for (const Link* link = activation.control.rest.get(); link != nullptr; link = link->tail.get())
        if (link->head.kind == ItemKind::enter && link->head.node != state &&
            is_within(machine, link->head.node, state))
            return true;
    return false;
}

Next enter_node(const MachineTables& tables, const RunningThread& running, const Values& values) {
    const Item& item = running.head();
    const ir::Machine& machine = *tables.frames[running.frame()].machine;
    const ir::Node& node = machine.nodes[item.node.index];
    // The entering thread is the activation's control thread, so `at` changes with it. After its entry action, a
    // composite state continues at its initial node.
    Program rest = running.tail();
    const auto entered_item = [&](NodeId which) {
        Item event = item;
        event.kind = ItemKind::entered;
        event.node = which;
        event.label = "entering " + machine.nodes[which.index].path;
        return event;
    };
    const bool stops_here = node.kind == NodeKind::final || (node.kind == NodeKind::state && !node.is_composite());
    if (stops_here) {
        const std::vector<NodeId> outer = not_entered_around(machine, running.owner(), item.node);
        for (auto above = outer.rbegin(); above != outer.rend(); ++above) rest = push_item(entered_item(*above), rest);
        rest = push_item(entered_item(item.node), rest);
    }
    if (node.kind == NodeKind::state && node.is_composite()) {
        Item inside = item;
        inside.node = node.initial;
        rest = push_item(inside, rest);
    }
    if (node.kind == NodeKind::state && node.entry) {
        Item entry;
        entry.stmt = node.entry.get();
        entry.label = "entry action of " + node.path;
        rest = push_item(entry, rest);
    }
    const Activation changed = running.replace(rest);
    const View now = view_of(changed);
    const RunningMachine* owner = machine_of(now, running.frame());
    if (owner == nullptr) return next_configuration(changed, values);
    Activation moved = *owner->activation;
    moved.at = item.node;
    return next_configuration(owner->replace(moved), values);
}

Next mark_entered(const MachineTables& tables, const RunningThread& running, const Values& values) {
    const NodeId id = running.head().node;
    const Frame& frame = tables.frames[running.frame()];
    const Activation changed = running.replace(running.tail());
    const View now = view_of(changed);
    const RunningMachine* owner = machine_of(now, running.frame());
    if (owner == nullptr) return next_configuration(changed, values);
    Activation moved = *owner->activation;
    put_entered(*frame.machine, id, moved);
    Values after = values;
    for (std::size_t i = 0; i < frame.clocks.size(); ++i)
        if (frame.clocks[i] && frame.machine->clocks[i].entry_of == id) after[*frame.clocks[i]] = b::number(0);
    for (const auto& [transition, cell] : frame.monitors)
        if (frame.machine->transitions[transition].source == id)
            after[cell] = translate_expression(tables.project(), tables.frames.make_scope(running.frame(), values),
                                               *frame.machine->transitions[transition].deadline);
    return next_configuration(owner->replace(moved), after);
}

Branch entered_branch(const MachineTables& tables, const RunningThread& running) {
    const std::string& path = tables.frames[running.frame()].machine->nodes[running.head().node.index].path;
    return {nullptr, b::name(path + "::entered"), {}, mark_entered(tables, running, {})};
}

}  // namespace robochart::csp_emit
