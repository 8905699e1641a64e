// SPDX-License-Identifier: Apache-2.0
#include "cpp_emit/machine/frame_code.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "cpp_emit/expressions/expression.hpp"
#include "cpp_emit/plan/types.hpp"

namespace robochart::cpp_emit {

using ir::NodeId;
using ir::NodeKind;

namespace {

/// Returns the size of an enumeration. With up to 256 values, it takes one byte.
std::size_t enumeration_size(std::size_t values) {
    return values <= 256 ? 1 : 2;
}

}  // namespace

std::vector<Field> FrameCode::variable_fields() const {
    std::vector<Field> fields;
    const auto add = [&](const std::string& name, const ir::Variable& variable, const ir::Value& initial) {
        const Extent extent = cpp_extent(generation_.system, generation_.inst, variable.type);
        fields.push_back({cpp_type(generation_.system, variable.type), name,
                          cpp_value(generation_.system, generation_.inst, variable.type, initial),
                          generation_.place_text(variable.origin), extent.size, extent.alignment, extent.varies});
    };
    const std::size_t home = generation_.component.is_composed() ? unit_.part : no_part;
    for (const auto& stored : generation_.component.variables)
        if (unit_.root && stored.in_state() && stored.home == home) add(stored.field, *stored.variable, stored.initial);
    for (std::size_t index = 0; index < unit_.variable_fields.size(); ++index) {
        if (unit_.variable_fields[index].empty()) continue;
        add(unit_.variable_fields[index], unit_.machine->variables[index], unit_.initials[index]);
    }
    return fields;
}

void FrameCode::thread_field(std::vector<Field>& fields, const Thread& thread, const std::string& wait) const {
    if (thread.waits) fields.push_back({"std::uint32_t", wait, "0", "time units left to wait", 4, 4});
    for (const std::string& deadline : thread.deadlines)
        fields.push_back({"std::uint32_t", deadline, "0", "time left plus one, 0: none", 4, 4});
    for (const CallFrame& call : thread.calls) {
        const FrameLayout& inner = context_.done.at(call.operation);
        fields.push_back({generation_.component.unit_at(call.operation).frame + "<Types>", call.field, "", "",
                          inner.size, inner.alignment, inner.varies});
    }
}

std::vector<Field> FrameCode::thread_fields() const {
    std::vector<Field> fields;
    const std::size_t size = enumeration_size(control_points().values.size());
    const ir::NodeId initial = plan_.machine().initial;
    const std::string first = control_.qualified_label(initial.is_valid() ? plan_.label_of(initial) : "idle");
    fields.push_back({unit_.points, "at", first, "", size, size});
    thread_field(fields, control_, "wait");
    for (const Watch& watch : watches_)
        fields.push_back({"std::uint32_t", watch.field, "0", "time left plus one, 0: not active", 4, 4});
    if (!context_.leaving.empty())
        fields.push_back({context_.leaving, "leaving", context_.leaving + "::nothing", "transition being taken", 1, 1});
    if (!context_.next.empty())
        fields.push_back(
            {context_.next, "next", context_.next + "::nothing", "transition that ended the last cycle", 1, 1});
    for (const DuringThread& during : during_) {
        fields.push_back(
            {during.thread.enumeration, "during_" + during.suffix, during.thread.qualified_label("idle"), "", 1, 1});
        thread_field(fields, during.thread, "wait_" + during.suffix);
    }
    for (std::uint32_t index = 0; index < plan_.machine().nodes.size(); ++index) {
        const NodeId id{index};
        if (plan_.node(id).is_composite() && plan_.notes_entry(id))
            fields.push_back(
                {"bool", "entering_" + plan_.label_of(id), "false", "its first child is still to be entered", 1, 1});
    }
    for (const NodeId id : context_.histories)
        fields.push_back({unit_.points, "history_" + plan_.label_of(id), first, "", size, size});
    return fields;
}

FrameLayout FrameCode::make_layout(const std::vector<Field>& more) {
    std::vector<Field> fields = variable_fields();
    assert(unit_.variable_fields.size() == unit_.initials.size());
    fields.insert(fields.end(), more.begin(), more.end());
    for (std::size_t index = 0; index < unit_.clock_fields.size(); ++index)
        if (unit_.clock_read[index])
            fields.push_back({"std::uint32_t", unit_.clock_fields[index], "0",
                              "clock " + generation_.place_text(unit_.machine->clocks[index].origin), 4, 4});
    const std::vector<Field> threads = thread_fields();
    fields.insert(fields.end(), threads.begin(), threads.end());
    return arrange_fields(std::move(fields), time_.is_timed());
}

/// Returns the target of the transition that begins at the place; invalid if none begins there.
NodeId FrameCode::target_of(const std::string& label) const {
    for (std::uint32_t index = 0; index < plan_.machine().transitions.size(); ++index)
        if (plan_.take_label(ir::TransitionId{index}) == label) return plan_.machine().transitions[index].target;
    return {};
}

/// Returns the values of Frame::at: nodes in which control rests, and places of programs that may wait.
Enumeration FrameCode::control_points() const {
    Enumeration at{
        unit_.points, fmt::format("Where {} is: in a node, or in the middle of a program.", unit_.machine->name), {}};
    const NodeId initial = plan_.machine().initial;
    if (!initial.is_valid()) {
        at.values.push_back({"idle", "no body", {}});
        return at;
    }
    const auto is_place = [&](const std::string& label) {
        return std::ranges::any_of(control_.places, [&](const Place& place) { return place.label == label; });
    };
    const auto node_value = [&](NodeId id) {
        const bool state = plan_.node(id).kind == ir::NodeKind::state;
        at.values.push_back({plan_.label_of(id), generation_.place_text(plan_.node(id).origin),
                             state ? id : plan_.node(id).parent, plan_.is_resting_place(id)});
    };
    node_value(initial);  // zero: the place of a new state struct
    for (std::uint32_t index = 0; index < plan_.machine().nodes.size(); ++index) {
        const NodeId id{index};
        if (id != initial && (plan_.is_resting_place(id) || is_place(plan_.label_of(id)))) node_value(id);
    }
    const std::size_t nodes = at.values.size();
    const auto is_node = [&](const std::string& label) {
        return std::any_of(at.values.begin(), at.values.begin() + static_cast<std::ptrdiff_t>(nodes),
                           [&](const Enumerator& value) { return value.name == label; });
    };
    NodeId target;
    for (const Place& place : control_.places) {
        if (is_node(place.label)) continue;
        if (place.comment != "waits") target = target_of(place.label);
        at.values.push_back({place.label, place.comment, place.state, false, target});
    }
    return at;
}

std::vector<Enumeration> FrameCode::all_enumerations() const {
    const Enumeration at = control_points();
    if (!plan_.machine().initial.is_valid()) return {at};
    std::vector<Enumeration> result = {at};
    for (const DuringThread& during : during_) {
        Enumeration progress{
            during.thread.enumeration, "How far the during action of " + during.suffix + " is.", {{"idle", "", {}}}};
        for (const Place& place : during.thread.places)
            progress.values.push_back({place.label, place.comment, place.state});
        result.push_back(std::move(progress));
    }
    const auto add_transitions = [&](const std::string& name, const char* comment, const auto& holds) {
        if (name.empty()) return;
        Enumeration some{name, comment, {{"nothing", "", {}}}};
        for (std::uint32_t index = 0; index < plan_.machine().transitions.size(); ++index) {
            const ir::Transition& transition = plan_.machine().transitions[index];
            if (holds(transition))
                some.values.push_back(
                    {plan_.take_label(ir::TransitionId{index}), generation_.place_text(transition.origin), {}});
        }
        result.push_back(std::move(some));
    };
    add_transitions(context_.leaving, "The transition whose exits are running.",
                    [&](const ir::Transition& transition) { return plan_.notes_leaving(transition.source); });
    add_transitions(context_.next, "The transition that ended the last cycle and goes on in this one.",
                    [](const ir::Transition& transition) { return transition.exec; });
    return result;
}

}  // namespace robochart::cpp_emit
