// States (semantics 3.3): entering runs the entry action, then the inner initial node, then `entered`, innermost
// first; `entered` starts the during action and makes the state interruptible.
#include <algorithm>

#include "checker/cspm/syntax/build.hpp"
#include "csp_emit/machine/machine.hpp"

namespace robochart::csp_emit {

namespace b = cspm::build;
using cspm::ExprPtr;
using ir::NodeId;
using ir::NodeKind;

bool MachineEmitter::settled(const Activation& activation) const {
    return activation.control.done() && activation.at.valid();
}

bool MachineEmitter::is_final(const Activation& activation) const {
    if (!settled(activation)) return false;
    const ir::Node& node = frames_[activation.frame].machine->nodes[activation.at.index];
    return node.kind == NodeKind::final && !node.parent.valid();
}

/// Composite states around the node that have not been entered yet, innermost first.
static std::vector<NodeId> pending(const ir::Machine& machine, const Activation& activation, NodeId node) {
    std::vector<NodeId> result;
    for (NodeId above = machine.nodes[node.index].parent; above.valid(); above = machine.nodes[above.index].parent)
        if (std::find(activation.entered.begin(), activation.entered.end(), above) == activation.entered.end())
            result.push_back(above);
    return result;
}

ExprPtr MachineEmitter::perform_enter(const Place& place, const Item& item, const Values& values) {
    const ir::Machine& entered = *frames_[place.owner->frame].machine;
    const ir::Node& node = entered.nodes[item.node.index];
    // The thread that enters is the activation's control thread, so the change of `at` goes with it. A composite
    // state stands at its initial node once its entry action is done.
    Program rest = place.thread->rest->tail;
    const auto say = [&](NodeId which) {
        Item event = item;
        event.kind = ItemKind::entered;
        event.node = which;
        event.label = "entering " + entered.nodes[which.index].path;
        return event;
    };
    const bool stops_here = node.kind == NodeKind::final || (node.kind == NodeKind::state && !node.composite());
    if (stops_here) {
        const std::vector<NodeId> outer = pending(entered, *place.owner, item.node);
        for (auto above = outer.rbegin(); above != outer.rend(); ++above) rest = push(say(*above), rest);
        rest = push(say(item.node), rest);
    }
    if (node.kind == NodeKind::state && node.composite()) {
        Item inside = item;
        inside.node = node.initial;
        rest = push(inside, rest);
    }
    if (node.kind == NodeKind::state && node.entry) {
        Item entry;
        entry.stmt = node.entry.get();
        entry.label = "entry action of " + node.path;
        rest = push(entry, rest);
    }
    Activation changed = place.put({rest, nullptr});
    // Find the owner again in the changed configuration: it is the running machine of the same frame.
    const View now = view(changed);
    for (const Spot& spot : now.spots) {
        if (spot.activation->frame != place.owner->frame) continue;
        Activation moved = *spot.activation;
        moved.at = item.node;
        return go(spot.put(moved), values);
    }
    return go(changed, values);
}

/// Puts a state among those entered, outermost first, starts its during action and its clock.
ExprPtr MachineEmitter::perform_entered(const Place& place, const Item& item, const Values& values) {
    const Frame& frame = frames_[place.owner->frame];
    const ir::Node& node = frame.machine->nodes[item.node.index];
    const Activation changed = place.put({place.thread->rest->tail, nullptr});
    const View now = view(changed);
    Values after = values;
    for (const Spot& spot : now.spots) {
        if (spot.activation->frame != place.owner->frame) continue;
        Activation moved = *spot.activation;
        const auto outer = [&](NodeId other) {
            for (NodeId above = node.parent; above.valid(); above = frame.machine->nodes[above.index].parent)
                if (above == other) return true;
            return false;
        };
        const auto after_outer = std::find_if_not(moved.entered.begin(), moved.entered.end(), outer);
        moved.entered.insert(after_outer, item.node);
        if (node.kind == NodeKind::state && node.during) {
            Item first;
            first.stmt = node.during.get();
            first.label = "during action of " + node.path;
            const auto place_of = std::find_if_not(moved.durings.begin(), moved.durings.end(),
                                                   [&](const During& d) { return outer(d.node); });
            moved.durings.insert(place_of, {item.node, {push(first, nullptr), nullptr}});
        }
        for (std::size_t i = 0; i < frame.clocks.size(); ++i)
            if (frame.clocks[i] && frame.machine->clocks[i].entry_of == item.node)
                after[*frame.clocks[i]] = b::number(0);
        for (const auto& [transition, cell] : frame.monitors)
            if (frame.machine->transitions[transition].source == item.node)
                after[cell] = expression(project(), scope(place.owner->frame, values),
                                         *frame.machine->transitions[transition].deadline);
        return go(spot.put(moved), after);
    }
    return go(changed, after);
}

void MachineEmitter::entered_branch(const Place& place, std::vector<ExprPtr>& out) {
    const Item& item = place.head();
    const std::string& path = frames_[place.owner->frame].machine->nodes[item.node.index].path;
    out.push_back(b::prefix(b::name(path + "::entered"), perform_entered(place, item, {})));
}

}  // namespace robochart::csp_emit
