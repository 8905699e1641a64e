// SPDX-License-Identifier: Apache-2.0
#include "cpp_emit/machine/machine_context.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <set>

#include "cpp_emit/code/suspension.hpp"
#include "cpp_emit/expressions/expression.hpp"

namespace robochart::cpp_emit {

using ir::NodeId;
using ir::NodeKind;

namespace {

std::set<std::string> taken_fields(const Generation& generation, const Unit& unit) {
    std::set<std::string> taken = never_members(generation.system, generation.component);
    taken.insert(unit.clock_fields.begin(), unit.clock_fields.end());
    taken.insert(unit.variable_fields.begin(), unit.variable_fields.end());
    if (!unit.root) return taken;
    for (const auto& variable : generation.component.variables) taken.insert(variable.field);
    for (const auto& buffer : generation.component.buffers) taken.insert(buffer.field);
    return taken;
}

}  // namespace

MachineContext::MachineContext(const Generation& owner, const Unit& described, const Layouts& layouts,
                               NameScope& type_names)
    : generation(owner),
      unit(described),
      done(layouts),
      plan(owner, described),
      fields(taken_fields(owner, described)) {
    const std::string& prefix = unit.prefix;
    control.variable = "f.at";
    control.enumeration = unit.points;
    control.wait = "f.wait";
    control.labels = &plan.place_labels();
    control.fields = &fields;
    leaving = plan.has_noted_leaving() ? type_names.unique_name(prefix + "Leaving") : "";
    next = plan.has_exec() ? type_names.unique_name(prefix + "Next") : "";
    for (std::uint32_t index = 0; index < unit.machine->transitions.size(); ++index) {
        const ir::Transition& transition = unit.machine->transitions[index];
        const bool state = plan.node(transition.source).kind == ir::NodeKind::state;
        if (transition.deadline && state)
            watches.push_back(
                {ir::TransitionId{index}, transition.source, fields.unique_name("deadline_of_" + transition.name)});
    }
    std::size_t durings = 0;
    for (const auto& node : unit.machine->nodes) durings += node.during ? 1U : 0U;
    during.reserve(durings);  // no reallocation, because threads have pointers to their own labels
    for (std::uint32_t index = 0; index < unit.machine->nodes.size(); ++index) {
        const NodeId id{index};
        if (!plan.node(id).during || runs_on_entry(id)) continue;
        DuringThread& added = during.emplace_back();
        assert(during.size() <= durings);
        added.state = id;
        added.suffix = plan.label_of(id);
        added.labels = NameScope(std::set<std::string>{"idle", "start"});
        added.thread.variable = "f.during_" + added.suffix;
        added.thread.enumeration = type_names.unique_name(prefix + "During_" + added.suffix);
        added.thread.wait = "f.wait_" + added.suffix;
        added.thread.prefix = added.suffix + "_";
        added.thread.labels = &added.labels;
        added.thread.fields = &fields;
    }
}

/// Returns whether the during action is executed when the state is entered. This is so if the state has no children,
/// and the action never waits and runs alone. It then has the same effect as a separate thread.
bool MachineContext::runs_on_entry(NodeId id) const {
    const ir::Node& node = plan.node(id);
    const std::vector<NodeId> around = plan.ancestors(id);
    return node.during && !node.is_composite() && faultless_cycle(generation.options) &&
           !may_suspend(generation, unit, node.during) &&
           std::ranges::none_of(around, [&](NodeId outer) { return plan.node(outer).during != nullptr; });
}

std::string MachineContext::function_head(const std::string& name) const {
    return fmt::format("{}({}) noexcept {{", name, frame_parameters(generation.component, unit));
}

std::string MachineContext::function_call(const std::string& name) const {
    return fmt::format("{}({})", name, frame_arguments(generation.component, unit));
}

std::string MachineContext::in_call(const Thread& thread, const CallFrame& call) {
    std::vector<std::string> places;
    for (const auto& label : call.live)
        places.push_back(fmt::format("{} == {}", thread.variable, thread.qualified_label(label)));
    return fmt::format("{}", fmt::join(places, " || "));
}

std::string MachineContext::call_inside(const CallFrame& call, const std::string& name) const {
    const Unit& operation = generation.component.unit_at(call.operation);
    return fmt::format("{}({})", name, frame_arguments(generation.component, operation, unit, "f." + call.field));
}

}  // namespace robochart::cpp_emit
