// SPDX-License-Identifier: Apache-2.0
#include "cpp_emit/machine/order_faults.hpp"

#include "cpp_emit/code/suspension.hpp"

namespace robochart::cpp_emit {

using ir::NodeId;
using ir::NodeKind;

/// Returns whether a composite state has Fault::entry_inner_first. Its initial node must lead unconditionally to a
/// child.
bool OrderFaults::enters_child_first(NodeId id) {
    return plan_.node(id).entry != nullptr && sole_first_child(id).is_valid() &&
           generation_.mutation.hits(Fault::entry_inner_first, &unit_, &plan_.node(id));
}

NodeId OrderFaults::sole_first_child(NodeId id) const {
    const ir::Node& node = plan_.node(id);
    if (!node.is_composite()) return {};
    const auto& ways = plan_.node(node.initial).outgoing;
    if (ways.size() != 1) return {};
    const ir::Transition& way = plan_.machine().transitions[ways.front().index];
    const bool plain = way.guard == nullptr && way.action == nullptr && way.resets.empty();
    const ir::Node& child = plan_.node(way.target);
    return plain && child.kind == NodeKind::state && !child.is_composite() && child.entry != nullptr ? way.target
                                                                                                     : NodeId{};
}

/// Returns whether a state has Fault::exit_outer_first: the composite's exit action runs before those of its inner
/// states.
bool OrderFaults::exits_first(NodeId id) {
    const ir::Node& node = plan_.node(id);
    return node.is_composite() && node.exit != nullptr && !node.outgoing.empty() &&
           !may_suspend(generation_, unit_, node.exit) &&
           generation_.mutation.hits(Fault::exit_outer_first, &unit_, &node);
}

/// Returns whether a transition has Fault::action_before_exit: its action runs before the exit, if the exit has a
/// separate place.
bool OrderFaults::acts_first(const ir::Transition& transition) {
    const ir::Node& source = plan_.node(transition.source);
    return transition.action != nullptr && source.exit != nullptr &&
           !may_suspend(generation_, unit_, transition.action) &&
           generation_.mutation.hits(Fault::action_before_exit, &unit_, &transition);
}

/// Returns whether a transition has Fault::action_after_entry.
bool OrderFaults::acts_late(const ir::Transition& transition) {
    const ir::Node& target = plan_.node(transition.target);
    return transition.action != nullptr && target.kind == NodeKind::state && !target.is_composite() &&
           target.entry != nullptr && generation_.mutation.hits(Fault::action_after_entry, &unit_, &transition);
}

bool OrderFaults::resumes_composite(NodeId composite) {
    if (!generation_.mutation.hits(Fault::composite_resumed)) return false;
    context_.histories.push_back(composite);
    return true;
}

bool OrderFaults::skips_children(NodeId left) {
    return plan_.node(left).is_composite() && generation_.mutation.hits(Fault::children_not_exited);
}

}  // namespace robochart::cpp_emit
