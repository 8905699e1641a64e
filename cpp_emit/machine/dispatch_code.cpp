// SPDX-License-Identifier: Apache-2.0
#include "cpp_emit/machine/dispatch_code.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cassert>

#include "cpp_emit/code/assignment.hpp"
#include "cpp_emit/code/dispatch.hpp"
#include "cpp_emit/code/reception.hpp"
#include "cpp_emit/code/suspension.hpp"

namespace robochart::cpp_emit {

using ir::NodeId;
using ir::NodeKind;

namespace {

constexpr std::size_t leaves_for_table = 5;

}  // namespace

/// Returns whether every transition is one straight effect, so that control rests only in states (or in a junction
/// without an enabled transition).
bool DispatchCode::is_direct() const {
    const auto& nodes = plan_.machine().nodes;
    for (std::uint32_t index = 0; index < nodes.size(); ++index)
        if (!plan_.is_straight(NodeId{index})) return false;
    const auto waits = [&](const ir::Transition& transition) {
        if (plan_.acts_after_trigger(transition) || !plan_.straight_exits(transition.source)) return true;
        if (!transition.trigger) return false;
        const EventUse& use = generation_.component.find_event(unit_, transition.trigger->event);
        return !from_register(use) && !use.is_spontaneous();
    };
    const auto& transitions = plan_.machine().transitions;
    return unit_.root && !generation_.component.is_composed() && during_.empty() && !guards_deadlines(*unit_.machine) &&
           faultless_cycle(generation_.options) && !generation_.options.choices &&
           generation_.options.order.drops.empty() && plan_.machine().initial.is_valid() &&
           std::ranges::none_of(transitions, waits);
}

/// Returns whether the transition waits for no event of the platform.
bool DispatchCode::is_urgent(const ir::Transition& transition) const {
    return !transition.trigger || generation_.component.find_event(unit_, transition.trigger->event).is_spontaneous();
}

bool DispatchCode::asks_for(const ir::Transition& transition, const EventPort& port) const {
    if (is_urgent(transition)) return false;
    const EventUse& use = generation_.component.find_event(unit_, transition.trigger->event);
    assert(!use.ports.empty());
    return &generation_.component.events[use.ports.front()] == &port;
}

/// Returns whether a transition of the node or its parents needs no event, or control may continue from a junction.
bool DispatchCode::goes_on(NodeId rest) const {
    if (!plan_.is_resting_place(rest)) return true;
    const std::vector<NodeId> chain = plan_.state_chain(rest);
    return std::ranges::any_of(chain, [&](NodeId state) {
        const auto& ways = plan_.node(state).outgoing;
        return std::ranges::any_of(
            ways, [&](ir::TransitionId way) { return is_urgent(plan_.machine().transitions[way.index]); });
    });
}

/// Returns whether transitions without events must be tried after entering a node.
bool DispatchCode::look_after(NodeId target) const {
    std::vector<bool> seen(plan_.machine().nodes.size(), false);
    std::vector<NodeId> open = {target};
    while (!open.empty()) {
        const NodeId at = open.back();
        open.pop_back();
        if (seen[at.index]) continue;
        seen[at.index] = true;
        const ir::Node& node = plan_.node(at);
        const bool chooses = !plan_.is_resting_place(at) && node.kind != NodeKind::state;
        if (chooses) {
            const bool rests = std::ranges::any_of(
                control_.places, [&](const Place& place) { return place.label == plan_.label_of(at); });
            if (rests) return true;
            for (const ir::TransitionId way : node.outgoing)
                open.push_back(plan_.machine().transitions[way.index].target);
        } else if (node.is_composite()) {
            open.push_back(node.initial);
        } else if (goes_on(at)) {
            return true;
        }
    }
    return false;
}

std::string DispatchCode::rest_result() const {
    if (generation_.component.lists) return "return this->result(finished(f));";
    return plan_.final_nodes().empty() ? "return robochart::StepResult::quiescent;"
                                       : "return finished(f) ? robochart::StepResult::terminated : "
                                         "robochart::StepResult::quiescent;";
}

/// Returns whether the declared order tries the transition before all others.
bool DispatchCode::is_first(const ir::Transition& transition) const {
    const auto& first = generation_.options.order.first;
    const auto found = first.find(unit_.id.index);
    return found != first.end() && std::ranges::find(found->second, transition.trigger->event) != found->second.end();
}

/// Writes the effect of a transition from a leaf. The transition is taken on the event of `port`, or without an event
/// if `port` is null.
void DispatchCode::case_effect(const ir::Transition& transition, const EventPort* port, CodeWriter& out) {
    const ir::TransitionId id{static_cast<std::uint32_t>(&transition - plan_.machine().transitions.data())};
    assert(id.index < unit_.machine->transitions.size());
    const bool consumes = !is_urgent(transition);
    const auto hits = [&](Fault fault) { return generation_.mutation.hits(fault, port, &transition); };
    if (transition.trigger) {
        const std::string line = store_received(generation_, unit_, *transition.trigger, incoming_value(transition));
        if (!line.empty() && !hits(Fault::dispatch_value_lost)) out.line(line);
    }
    for (const ir::ClockId clock : transition.resets) {
        const std::string line = clock_reset(generation_, unit_, clock);
        if (!line.empty() && !hits(Fault::dispatch_reset_dropped)) out.line(line);
    }
    out.line(steps_.tell_taken(id));
    for (const Watch& watch : watches_) {
        const std::vector<NodeId> around = plan_.state_chain(watch.state);
        const bool left = std::ranges::find(around, transition.source) != around.end();
        if (left) out.line(fmt::format("f.{} = 0;", watch.field));
    }
    const std::string exits = steps_.leave_statement(transition.source);
    if (!exits.empty()) out.line(exits);
    out.line(steps_.proceed_statement(transition));
    const bool again = port != nullptr && !consumes ? true : look_after(transition.target);
    if (!again || hits(Fault::dispatch_look_dropped)) return out.line(rest_result());
    if (consumes) out.line("event = nothing;");
    out.line("break;");
}

std::string DispatchCode::incoming_value(const ir::Transition& transition) const {
    const EventUse& use = generation_.component.find_event(unit_, transition.trigger->event);
    if (use.is_spontaneous()) return use.type ? default_text(generation_, *use.type) : "";
    assert(!use.ports.empty());
    return "inputs_." + generation_.component.events[use.ports.front()].input + ".get()";
}

/// Returns the transitions of a leaf and its parents that an event (or, for null, no event) may trigger, in the order
/// in which they are tried.
std::vector<const ir::Transition*> DispatchCode::candidate_transitions(NodeId leaf, const EventPort* port) const {
    std::vector<NodeId> chain = plan_.state_chain(leaf);
    std::vector<std::vector<const ir::Transition*>> by_state;
    for (const NodeId state : chain) {
        std::vector<const ir::Transition*> own;
        for (const ir::TransitionId way : plan_.node(state).outgoing) {
            const ir::Transition& transition = plan_.machine().transitions[way.index];
            if (is_urgent(transition) || (port != nullptr && asks_for(transition, *port))) own.push_back(&transition);
        }
        if (!own.empty()) by_state.push_back(std::move(own));
    }
    if (by_state.size() > 1 && generation_.mutation.hits(Fault::dispatch_outer_first, port, &plan_.node(leaf)))
        std::ranges::reverse(by_state);
    std::vector<const ir::Transition*> all;
    for (const auto& own : by_state) all.insert(all.end(), own.begin(), own.end());
    std::stable_partition(all.begin(), all.end(), [&](const ir::Transition* transition) {
        return port != nullptr && !is_urgent(*transition) && is_first(*transition);
    });
    return all;
}

/// Returns the condition for a transition in a case; empty if there is none.
CppExpr DispatchCode::case_condition(const ir::Transition& transition) const {
    const std::string value = transition.trigger ? incoming_value(transition) : "";
    const CppExpr predicate =
        transition.trigger ? value_predicate(generation_, unit_, *transition.trigger, value) : CppExpr();
    return conjunction(predicate, steps_.guard_condition(transition, value));
}

/// Writes the code for control that does not rest in a state. This is so at the beginning, and in a junction without an
/// enabled transition.
void DispatchCode::place_body(NodeId place, CodeWriter& out) {
    out.comment("from " + generation_.place_text(plan_.node(place).origin));
    if (place == plan_.machine().initial) {
        if (generation_.mutation.hits(Fault::dispatch_not_begun, nullptr, &plan_.node(place)))
            return out.line(rest_result());
        begin_machine(out);
    } else {
        steps_.begin(place, out);
    }
    if (!plan_.is_passed_through(place))
        out.line(fmt::format("if (f.at == {}) {}", control_.qualified_label(plan_.label_of(place)), rest_result()));
    out.line("break;");
}

/// Returns the code for the effect of an event in a leaf; "" if it has none.
std::string DispatchCode::case_body(NodeId leaf, const EventPort* port, std::size_t depth) {
    CodeWriter out(depth);
    if (!plan_.is_resting_place(leaf)) {
        place_body(leaf, out);
        return out.text();
    }
    const std::vector<const ir::Transition*> tried = candidate_transitions(leaf, port);
    for (const ir::Transition* transition : tried) {
        out.comment(generation_.place_text(transition->origin));
        const CppExpr condition = case_condition(*transition);
        if (!condition.empty()) out.open(fmt::format("if ({}) {{", condition.whole_text()));
        case_effect(*transition, port, out);
        if (condition.empty()) return out.text();
        if (transition != tried.back() &&
            generation_.mutation.hits(Fault::dispatch_guard_ends, &plan_.node(leaf), transition)) {
            out.reopen_block("} else {");
            out.line(rest_result());
        }
        out.close();
    }
    if (!out.empty()) out.line(rest_result());
    return out.text();
}

void DispatchCode::dispatch_function() {
    std::vector<NodeId> rows;
    for (const Enumerator& value : frame_.control_points().values)
        for (std::uint32_t index = 0; index < plan_.machine().nodes.size(); ++index)
            if (plan_.label_of(NodeId{index}) == value.name) rows.push_back(NodeId{index});
    std::vector<const EventPort*> columns = input_events(generation_.component);
    assert(!columns.empty());  // the class has this function only if there are events
    std::size_t leaves = 0;
    bool quiet = false;
    for (const NodeId row : rows) {
        leaves += plan_.is_resting_place(row) ? 1U : 0U;
        quiet = quiet || (plan_.is_resting_place(row) && goes_on(row));
    }
    // One row is for the machine before it has started. It does not consume the event.
    const bool places = std::ranges::any_of(
        rows, [&](NodeId row) { return !plan_.is_resting_place(row) && row != plan_.machine().initial; });
    if (quiet || places) columns.push_back(nullptr);
    const Strategy strategy = generation_.options.strategy;
    const bool table = strategy == Strategy::table || (strategy == Strategy::automatic && leaves >= leaves_for_table);
    const std::string type = event_type(generation_);
    out_.open(fmt::format("robochart::StepResult dispatch({} event) noexcept {{", type));
    out_.line(fmt::format("{}& f = state_;", frame_type()));
    if (columns.back() == nullptr)
        out_.line(
            fmt::format("[[maybe_unused]] constexpr auto nothing = static_cast<{}>({});", type, columns.size() - 1));
    if (table) {
        dispatch_table(rows, columns);
    } else {
        dispatch_switch(rows, columns);
    }
    // Without this column, the loop repeats only after the start of the machine. The machine starts once, so the loop
    // needs no bound.
    if (columns.back() == nullptr) out_.line("if (!spend()) return this->result(false);");
    out_.close();
    out_.close();
    begin_function(columns);
    pass_function_of_time(columns);
}

/// Resets the clocks, because they start with the machine: the time before the start does not count.
void DispatchCode::begin_machine(CodeWriter& out) {
    for (std::uint32_t index = 0; index < unit_.clock_fields.size(); ++index)
        if (unit_.clock_read[index] &&
            !generation_.mutation.hits(Fault::dispatch_clock_early, &unit_, &unit_.clock_fields[index]))
            out.line(fmt::format("f.{} = 0;", unit_.clock_fields[index]));
    steps_.begin(plan_.machine().initial, out);
}

void DispatchCode::begin_function(const std::vector<const EventPort*>& columns) {
    out_.open_declaration("What the machine does before the first event. It does nothing later.",
                          "robochart::StepResult begin() noexcept {");
    if (columns.back() == nullptr) {
        out_.line(fmt::format("return dispatch(static_cast<{}>({}));", event_type(generation_), columns.size() - 1));
    } else {
        out_.line(fmt::format("[[maybe_unused]] {}& f = state_;", frame_type()));
        out_.open(fmt::format("if (f.at == {}) {{", control_.qualified_label(plan_.label_of(plan_.machine().initial))));
        begin_machine(out_);
        out_.close();
        out_.line(rest_result());
    }
    out_.close();
}

/// Writes a cycle without inputs: transitions that need no event are taken, then time passes.
void DispatchCode::pass_function_of_time(const std::vector<const EventPort*>& columns) {
    out_.open_declaration("A cycle without inputs, once the machine has begun.",
                          "robochart::StepResult pass() noexcept {");
    out_.line(fmt::format("[[maybe_unused]] {}& f = state_;", frame_type()));
    if (columns.back() == nullptr) {
        out_.line("const robochart::StepResult result = begin();");
    } else {
        const bool quiescent = plan_.final_nodes().empty() && !generation_.component.lists;
        out_.line(fmt::format("const robochart::StepResult result = {};",
                              quiescent ? "robochart::StepResult::quiescent" : "this->result(finished(f))"));
    }
    if (time_.is_timed()) {
        out_.line("if (result == robochart::StepResult::quiescent) advance(f);");
        if (!watches_.empty()) out_.line("if (late()) return robochart::StepResult::deadline;");
    }
    out_.line("return result;");
    out_.close();
}

/// Returns the event of the case. With Fault::dispatch_shifted, returns the next event instead, if its case has a
/// different body.
const EventPort* DispatchCode::taken_for(NodeId row, const EventPort& port,
                                         const std::vector<const EventPort*>& columns) {
    const auto place = static_cast<std::size_t>(std::ranges::find(columns, &port) - columns.begin());
    assert(place < columns.size());
    const EventPort* const beside = columns[(place + 1) % columns.size()];
    const bool other = generation_.mutation.is_seeded(Fault::dispatch_shifted) &&
                       case_body(row, &port, 7) != case_body(row, beside, 7);
    return other && generation_.mutation.hits(Fault::dispatch_shifted) ? beside : &port;
}

void DispatchCode::dispatch_switch(const std::vector<NodeId>& rows, const std::vector<const EventPort*>& columns) {
    const std::string type = event_type(generation_);
    out_.open("for (;;) {");
    out_.open("switch (f.at) {");
    const NodeId initial = plan_.machine().initial;
    for (const NodeId row : rows) {
        if (row == initial) continue;
        out_.line(fmt::format("case {}:", control_.qualified_label(plan_.label_of(row))));
        if (!plan_.is_resting_place(row)) {
            out_.write_raw(case_body(row, nullptr, 5));
            continue;
        }
        const bool alone = goes_on(row);
        out_.line("    switch (event) {");
        for (const EventPort* port : columns) {
            if (port == nullptr) continue;
            const std::string body = case_body(row, taken_for(row, *port, columns), 7);
            if (body.empty()) continue;
            if (body == case_body(row, nullptr, 7)) continue;
            out_.line(fmt::format("        case {}::{}:", type, port->input));
            out_.write_raw(body);
        }
        out_.line("        default:");
        if (alone) {
            out_.write_raw(case_body(row, nullptr, 7));
        } else {
            out_.line("            " + rest_result());
        }
        out_.line("    }");
        out_.line("    break;");
    }
    out_.line(fmt::format("ROBOCHART_UNLIKELY default:  // {}", control_.qualified_label(plan_.label_of(initial))));
    out_.write_raw(case_body(initial, nullptr, 5));
    out_.close();
}

void DispatchCode::dispatch_table(const std::vector<NodeId>& rows, const std::vector<const EventPort*>& columns) {
    std::vector<std::string> bodies;
    std::vector<std::string> lines;
    for (const NodeId row : rows) {
        std::vector<std::string> numbers;
        for (const EventPort* port : columns) {
            const EventPort* const taken = port == nullptr ? nullptr : taken_for(row, *port, columns);
            const std::string body = case_body(row, taken, 5);
            const auto known = std::ranges::find(bodies, body);
            const auto number = static_cast<std::size_t>(known - bodies.begin()) + 1;
            if (!body.empty() && known == bodies.end()) bodies.push_back(body);
            numbers.push_back(body.empty() ? "0" : fmt::format("{}", number));
        }
        lines.push_back(fmt::format("{{{}}},  // {}", fmt::join(numbers, ", "), plan_.label_of(row)));
    }
    std::vector<std::string> names;
    assert(lines.size() == rows.size());
    for (const EventPort* port : columns) names.push_back(port == nullptr ? "nothing" : port->input);
    out_.comment("What a place does on an event, by the number of the case below; 0: nothing.");
    out_.comment(fmt::format("{}", fmt::join(names, ", ")));
    out_.open(fmt::format("static constexpr {} cases[{}][{}] = {{",
                          bodies.size() < 256 ? "std::uint8_t" : "std::uint16_t", rows.size(), columns.size()));
    for (const std::string& line : lines) out_.line(line);
    out_.close("};");
    out_.open("for (;;) {");
    out_.line("const auto chosen = cases[static_cast<std::size_t>(f.at)][static_cast<std::size_t>(event)];");
    out_.line("if (chosen == 0) " + rest_result());
    out_.open("switch (chosen) {");
    for (std::size_t number = 0; number < bodies.size(); ++number) {
        out_.line(fmt::format("case {}:", number + 1));
        out_.write_raw(bodies[number]);
    }
    out_.line("default: " + rest_result());
    out_.close();
}

}  // namespace robochart::cpp_emit
