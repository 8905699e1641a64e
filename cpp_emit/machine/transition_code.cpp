// SPDX-License-Identifier: Apache-2.0
#include "cpp_emit/machine/transition_code.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "cpp_emit/code/assignment.hpp"
#include "cpp_emit/code/cycles.hpp"
#include "cpp_emit/code/reception.hpp"

namespace robochart::cpp_emit {

using ir::NodeId;
using ir::NodeKind;

void TransitionCode::transition_functions() {
    const ir::Machine& machine = plan_.machine();
    for (std::uint32_t index = 0; index < machine.nodes.size(); ++index)
        if (machine.nodes[index].kind == NodeKind::state && has_others(NodeId{index})) from_function(NodeId{index});
    if (!first_events().empty()) {
        first_functions();
        choosing_function("first",
                          "Starts the first enabled transition that an event of the declared order triggers, before "
                          "all others.",
                          &TransitionCode::first_calls);
    }
    if (!context_.next.empty()) next_function();
    choosing_function("transition", "Starts the first enabled transition: inner states first, then textual order.",
                      &TransitionCode::attempt_calls);
}

const std::vector<ir::EventId>& TransitionCode::first_events() const {
    static const std::vector<ir::EventId> none;
    const auto& first = generation_.options.order.first;
    const auto found = first.find(unit_.id.index);
    return found == first.end() || !unit_.root ? none : found->second;
}

bool TransitionCode::comes_first(const ir::Transition& transition) const {
    return transition.trigger && std::ranges::find(first_events(), transition.trigger->event) != first_events().end();
}

/// Writes `first_S_n`: the transitions of state S that the n-th event of the order triggers.
void TransitionCode::first_functions() {
    const ir::Machine& machine = plan_.machine();
    for (std::uint32_t index = 0; index < machine.nodes.size(); ++index)
        for (std::size_t number = 0; number < first_events().size(); ++number) {
            if (!has_first(NodeId{index}, number)) continue;
            const ir::Event& event = machine.events[first_events()[number].index];
            out_.open_declaration(
                "Transitions of " + generation_.place_text(machine.nodes[index].origin) + " that the first event " +
                    event.name + " triggers",
                function_head(fmt::format("bool first_{}_{}", plan_.label_of(NodeId{index}), number)));
            bool certain = false;
            for (const ir::TransitionId way : plan_.node(NodeId{index}).outgoing) {
                const ir::Transition& transition = machine.transitions[way.index];
                const bool own = transition.trigger && transition.trigger->event == first_events()[number];
                if (own && !certain) certain = try_transition(transition);
            }
            if (!certain) out_.line("return false;");
            out_.close();
        }
}

bool TransitionCode::has_first(NodeId state, std::size_t number) const {
    const ir::Machine& machine = plan_.machine();
    return machine.nodes[state.index].kind == NodeKind::state &&
           std::ranges::any_of(machine.nodes[state.index].outgoing, [&](ir::TransitionId way) {
               const auto& trigger = machine.transitions[way.index].trigger;
               return trigger && trigger->event == first_events()[number];
           });
}

std::vector<std::string> TransitionCode::first_calls(NodeId leaf) const {
    std::vector<std::string> calls;
    const std::vector<NodeId> chain = plan_.state_chain(leaf);
    for (std::size_t number = 0; number < first_events().size(); ++number)
        for (const NodeId state : chain)
            if (has_first(state, number))
                calls.push_back(function_call(fmt::format("first_{}_{}", plan_.label_of(state), number)));
    return calls;
}

/// Writes the function that calls the functions of the active states.
void TransitionCode::choosing_function(const std::string& name, const char* comment, Calls calls_of) {
    const ir::Machine& machine = plan_.machine();
    out_.gap();
    const bool choices = generation_.options.choices;
    const std::string attempt = choices ? "attempt_" + name : name;
    if (choices) pick_function(name, attempt);
    const bool outer = !choices;
    out_.doc(choices ? "Starts the transition whose turn it is: inner states first, then textual order." : comment);
    out_.open(function_head("bool " + attempt));
    if (outer) write_begin_of_cycle();
    out_.open("switch (f.at) {");
    for (std::uint32_t index = 0; index < machine.nodes.size(); ++index) {
        const NodeId id{index};
        const std::vector<std::string> calls =
            plan_.is_resting_place(id) ? (this->*calls_of)(id) : std::vector<std::string>{};
        if (calls.empty()) continue;
        out_.line(
            fmt::format("case {}: return {};", control_.qualified_label(plan_.label_of(id)), fmt::join(calls, " || ")));
    }
    out_.line("default: return false;");
    out_.close();
    out_.close();
}

/// For RoboSim: no transition is taken after the end of the cycle. If a transition ended the last cycle, it continues
/// first.
void TransitionCode::write_begin_of_cycle() {
    if (!generation_.component.robosim) return;
    if (!generation_.mutation.hits(Fault::cycle_moves_on))
        out_.line(fmt::format("if ({}) return false;", ended_member(generation_.component, unit_)));
    if (!context_.next.empty())
        out_.line(fmt::format("if (f.next != {}::nothing) return {};", context_.next, function_call("go_on")));
}

/// For RoboSim: writes the rest of a transition with `exec`: resets, exits, its action, and the entry of its target.
void TransitionCode::next_function() {
    out_.open_declaration("The transition that ended the last cycle goes on.", function_head("bool go_on"));
    out_.open("switch (f.next) {");
    for (std::uint32_t index = 0; index < plan_.machine().transitions.size(); ++index) {
        const ir::Transition& transition = plan_.machine().transitions[index];
        if (!transition.exec) continue;
        const ir::TransitionId id{index};
        out_.line(fmt::format("case {}::{}:", context_.next, plan_.take_label(id)));
        if (stores_late(transition)) write_stores(transition);
        out_.line(fmt::format("f.next = {}::nothing;", context_.next));
        reset_clocks(generation_, unit_, transition.resets, out_);
        write_departure(transition.source, id);
        out_.line("return spend();");
    }
    out_.line("default: return false;");
    out_.close();
    out_.close();
}

/// Returns whether the transition has Fault::cycle_store_late.
bool TransitionCode::stores_late(const ir::Transition& transition) const {
    return transition.exec && !transition.stores.empty() &&
           generation_.mutation.hits(Fault::cycle_store_late, &unit_, &transition);
}

/// For RoboSim: writes the code that stores the values of each `$e?v` in the condition, in textual order.
void TransitionCode::write_stores(const ir::Transition& transition) {
    for (const ir::StmtPtr& store : transition.stores) out_.write_raw(steps_.straight_program(store, 3));
}

/// For RoboSim: a transition with `exec` ends the cycle now and continues in the next one (docs/robosim.md). In
/// between, no other action runs that could see the stored values (unsupported.cpp).
void TransitionCode::end_cycle(const ir::Transition& transition, ir::TransitionId id) {
    cut_durings(transition.source);
    out_.line(steps_.tell_taken(id));
    out_.line(fmt::format("f.next = {}::{};", context_.next, plan_.take_label(id)));
    if (!generation_.mutation.hits(Fault::cycle_effect_early))
        out_.line(fmt::format("{} = true;", ended_member(generation_.component, unit_)));
    out_.line(generation_.bound_test().empty() ? "return true;" : "return spend();");
}

/// Writes a function that takes one of several enabled transitions. A first pass counts the enabled transitions without
/// taking one. Then the platform picks.
void TransitionCode::pick_function(const std::string& name, const std::string& attempt) {
    out_.doc("Starts one of the enabled transitions: the platform picks, or it is the first.");
    out_.open(function_head("bool " + name));
    write_begin_of_cycle();
    out_.open("if constexpr (robochart::Picks<Platform>::value) {");
    out_.line("turn_.count();");
    out_.line(function_call(attempt) + ";");
    out_.line("if (turn_.counted() == 0) return false;");
    out_.line("turn_.take(robochart::pick(platform_, turn_.counted()));");
    out_.close();
    out_.line(fmt::format("return {};", function_call(attempt)));
    out_.close();
    out_.gap();
}

std::vector<std::string> TransitionCode::attempt_calls(NodeId leaf) const {
    std::vector<std::string> calls;
    const std::vector<NodeId> chain = plan_.state_chain(leaf);
    for (const NodeId state : chain)
        if (has_others(state)) calls.push_back(function_call("from_" + plan_.label_of(state)));
    return calls;
}

/// Returns whether the state has transitions that are not tried first.
bool TransitionCode::has_others(NodeId state) const {
    return std::ranges::any_of(plan_.node(state).outgoing, [&](ir::TransitionId way) {
        return !comes_first(plan_.machine().transitions[way.index]);
    });
}

void TransitionCode::from_function(NodeId id) {
    out_.open_declaration("Transitions of " + generation_.place_text(plan_.node(id).origin),
                          function_head("bool from_" + plan_.label_of(id)));
    bool certain = false;
    for (const ir::TransitionId way : plan_.node(id).outgoing) {
        if (certain) break;
        if (comes_first(plan_.machine().transitions[way.index])) continue;
        certain = try_transition(plan_.machine().transitions[way.index]);
    }
    if (!certain) out_.line("return false;");
    out_.close();
}

bool TransitionCode::try_transition(const ir::Transition& transition) {
    const ir::TransitionId id{static_cast<std::uint32_t>(&transition - plan_.machine().transitions.data())};
    out_.comment(generation_.place_text(transition.origin));
    reset_too_soon(transition);
    if (transition.trigger) return try_trigger(transition, id);
    const CppExpr condition = steps_.picked_guard(steps_.guard_condition(transition, ""));
    out_.write_if(condition, [&] { begin_transition(transition, id); });
    return condition.empty();
}

/// Writes resets too early, with Fault::reset_before_guard.
void TransitionCode::reset_too_soon(const ir::Transition& transition) {
    for (const ir::ClockId clock : transition.resets)
        if (generation_.mutation.hits(Fault::reset_before_guard)) reset_clocks(generation_, unit_, {clock}, out_);
}

bool TransitionCode::try_trigger(const ir::Transition& transition, ir::TransitionId id) {
    CppExpr late_guard;
    const Condition condition = [&](const std::string& incoming) {
        late_guard = {};
        CppExpr holds = steps_.guard_condition(transition, incoming);
        if (holds.empty() || !generation_.mutation.hits(Fault::guard_after_consume)) return steps_.picked_guard(holds);
        late_guard = std::move(holds);
        return steps_.picked_guard({});
    };
    return write_reception(generation_, unit_, *transition.trigger, out_, condition, [&] {
        if (!late_guard.empty()) out_.line(fmt::format("if (!({})) return false;", late_guard.whole_text()));
        begin_transition(transition, id);
    });
}

void TransitionCode::begin_transition(const ir::Transition& transition, ir::TransitionId id) {
    if (!stores_late(transition)) write_stores(transition);
    if (transition.exec) return end_cycle(transition, id);
    if (generation_.component.robosim && generation_.mutation.hits(Fault::cycle_end_early))
        out_.line(fmt::format("{} = true;", ended_member(generation_.component, unit_)));
    reset_clocks(generation_, unit_, transition.resets, out_);
    out_.line(steps_.tell_taken(id));
    write_departure(transition.source, id);
    out_.line(generation_.bound_test().empty() ? "return true;" : "return spend();");
}

void TransitionCode::cut_durings(NodeId source) {
    for (const DuringThread& during : during_) {
        const std::vector<NodeId> around = plan_.state_chain(during.state);
        const bool left = std::ranges::find(around, source) != around.end();
        if (left) out_.line(fmt::format("cut_{}(f);", during.suffix));
    }
}

/// Interrupts the during actions of the state and of all inner states, and starts the exits.
void TransitionCode::write_departure(NodeId source, ir::TransitionId id) {
    cut_durings(source);
    for (const Watch& watch : watches_) {
        const std::vector<NodeId> around = plan_.state_chain(watch.state);
        const bool left = std::ranges::find(around, source) != around.end();
        if (left) out_.line(fmt::format("f.{} = 0;", watch.field));
    }
    const ir::Transition& transition = plan_.machine().transitions[id.index];
    const bool composite = plan_.node(source).is_composite();
    const bool skips = faults_.skips_children(source);
    for (const NodeId history : context_.histories)
        if (history == source) out_.line(fmt::format("f.history_{} = f.at;", plan_.label_of(source)));
    if (!plan_.notes_leaving(source)) {
        const std::string own = plan_.node(source).exit ? function_call(plan_.exit_label(source)) + ";" : "";
        std::string exits;
        if (!plan_.acts_after_trigger(transition) || plan_.straight_exits(source))
            exits = skips ? own : steps_.leave_statement(source);
        if (faults_.acts_first(transition) && !plan_.acts_after_trigger(transition))
            out_.write_raw(steps_.straight_program(transition.action, 3));
        if (!exits.empty()) out_.line(exits);
        return out_.line(steps_.proceed_statement(transition));
    }
    out_.line(fmt::format("f.leaving = {}::{};", context_.leaving, plan_.take_label(id)));
    out_.line(skips || !composite ? control_.go_statement(plan_.exit_label(source)) : "leave(f);");
}

}  // namespace robochart::cpp_emit
