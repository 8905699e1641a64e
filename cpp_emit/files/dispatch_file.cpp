// SPDX-License-Identifier: Apache-2.0
// Writes the event API of the core: `Event`, `begin`, `dispatch` and `pass`. If no action waits, they use a switch or a
// table.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "cpp_emit/code/dispatch.hpp"
#include "cpp_emit/plan/types.hpp"

namespace robochart::cpp_emit {

std::vector<const EventPort*> input_events(const Component& component) {
    std::vector<const EventPort*> result;
    if (component.robosim) return result;  // a cycle reads all its registers
    for (const EventPort& port : component.events)
        if (port.received) result.push_back(&port);
    return result;
}

std::vector<std::string> list_inputs(const Generation& generation) {
    std::vector<std::string> result;
    for (const EventPort& event : generation.component.events)
        if (event.received && event.type && has_lists(generation.system, *event.type)) result.push_back(event.input);
    for (const StoredVariable& variable : generation.component.variables)
        if (!variable.input.empty() && !variable.copy && has_lists(generation.system, variable.variable->type))
            result.push_back(variable.input);
    return result;
}

std::string event_type(const Generation& generation) {
    std::set<std::string> taken;
    for (const ir::TypeId id : generation.component.enumerations)
        taken.insert(declared_name(generation.system.type(id)));
    for (const Unit& unit : generation.component.units) {
        taken.insert(unit.frame);
        taken.insert(unit.points);
    }
    NameScope scope(taken);
    return scope.unique_name("Event");
}

std::vector<const EventPort*> dropping_events(const Generation& generation) {
    const auto events = input_events(generation.component);
    std::vector<const EventPort*> result;
    for (const EventOrder::Drop& drop : generation.options.order.drops)
        if (std::ranges::find(result, events[drop.event_input]) == result.end())
            result.push_back(events[drop.event_input]);
    return result;
}

void write_drops(const Generation& generation, CodeWriter& out) {
    const auto events = input_events(generation.component);
    for (const EventOrder::Drop& drop : generation.options.order.drops) {
        if (generation.mutation.hits(Fault::order_ignored)) continue;
        const EventPort& event = *events[drop.event_input];
        out.comment(fmt::format("the declared order of events: {} drops {}", drop.event, drop.dropped));
        out.line(fmt::format("if (inputs_.{}.present || state_.{}) inputs_.{}.present = false;", event.input,
                             event.raised, events[drop.dropped_input]->input));
    }
}

void forget_raised(const Generation& generation, CodeWriter& out) {
    for (const EventPort* event : dropping_events(generation))
        out.line(fmt::format("state_.{} = false;", event->raised));
}

void write_event_type(const Generation& generation, CodeWriter& out) {
    const auto events = input_events(generation.component);
    if (events.empty()) return;
    out.open_declaration("The events received, for dispatch().",
                         fmt::format("enum class {} : {} {{", event_type(generation),
                                     events.size() < 256 ? "std::uint8_t" : "std::uint16_t"));
    for (const EventPort* event : events) out.line(event->input + ",");
    out.close("};");
}

void write_dispatch(const Generation& generation, const std::string& direct, CodeWriter& out) {
    const auto events = input_events(generation.component);
    if (events.empty()) return;
    out.gap();
    out.doc("What a cycle with this event and no other input does before time passes.");
    if (!direct.empty()) return out.write_raw(direct);
    const std::string type = event_type(generation);
    out.open(fmt::format("robochart::StepResult dispatch({} event) noexcept {{", type));
    out.line("[[maybe_unused]] const Inputs<Types> values = inputs_;");
    out.line("inputs_ = {};");
    out.open("switch (event) {");
    for (const EventPort* event : events) {
        out.line(fmt::format("case {}::{}:", type, event->input));
        if (event->type) out.line(fmt::format("    inputs_.{0}.value = values.{0}.value;", event->input));
        out.line(fmt::format("    inputs_.{}.present = true;", event->input));
        out.line("    break;");
    }
    out.close();
    write_drops(generation, out);
    for (const EventPort* event : dropping_events(generation))
        out.line(fmt::format("state_.{0} = state_.{0} || inputs_.{1}.present;", event->raised, event->input));
    const char* const state = generation.component.is_composed() ? "" : "state_";
    out.line(fmt::format("run({});", state));
    out.line(fmt::format("return this->result(finished({}));", state));
    out.close();
    out.open_declaration("What needs no event.", "robochart::StepResult begin() noexcept {");
    out.line("inputs_ = {};");
    out.line(fmt::format("run({});", state));
    out.line(fmt::format("return this->result(finished({}));", state));
    out.close();
    out.open_declaration("A cycle without inputs.", "robochart::StepResult pass() noexcept {");
    out.line("inputs_ = {};");
    out.line("return cycle();");
    out.close();
}

void write_dispatch_functions(const Generation& generation, CodeWriter& out) {
    if (input_events(generation.component).empty()) return;
    const std::string type = event_type(generation);
    out.gap();
    out.doc("What the controller does before the first event; a first dispatch() does it too.");
    out.line("template <class Types, class Platform>");
    out.open("robochart::StepResult begin(State<Types>& state, Platform& platform) noexcept {");
    out.line("return Step<Types, Platform>(state, Inputs<Types>{}, platform).begin();");
    out.close();
    out.gap();
    out.doc("One event that carries a value: that in `values`, where nothing else is read.");
    out.line("template <class Types, class Platform>");
    out.line(fmt::format("robochart::StepResult dispatch(State<Types>& state, {} event, const Inputs<Types>& values,",
                         type));
    out.open("                               Platform& platform) noexcept {");
    if (!list_inputs(generation).empty()) out.line("if (overflowed(values)) return robochart::StepResult::capacity;");
    out.line("return Step<Types, Platform>(state, values, platform).dispatch(event);");
    out.close();
    out.gap();
    out.doc("One event, without time passing.");
    out.line("template <class Types, class Platform>");
    out.open(fmt::format(
        "robochart::StepResult dispatch(State<Types>& state, {} event, Platform& platform) noexcept {{", type));
    out.line("return Step<Types, Platform>(state, Inputs<Types>{}, platform).dispatch(event);");
    out.close();
    out.gap();
    out.doc("A cycle without inputs, after begin(): what needs no event, then time passes.");
    out.line("template <class Types, class Platform>");
    out.open("robochart::StepResult pass(State<Types>& state, Platform& platform) noexcept {");
    out.line("return Step<Types, Platform>(state, Inputs<Types>{}, platform).pass();");
    out.close();
}

}  // namespace robochart::cpp_emit
