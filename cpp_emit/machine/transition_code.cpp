// SPDX-License-Identifier: Apache-2.0
#include "cpp_emit/machine/transition_code.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "cpp_emit/code/assignment.hpp"
#include "cpp_emit/code/reception.hpp"

namespace robochart::cpp_emit {

using ir::NodeId;
using ir::NodeKind;

void TransitionCode::transition_functions() {
    const ir::Machine& machine = plan_.machine();
    for (std::uint32_t index = 0; index < machine.nodes.size(); ++index)
        if (machine.nodes[index].kind == NodeKind::state && !machine.nodes[index].outgoing.empty())
            from_function(NodeId{index});
    out_.gap();
    const bool choices = generation_.options.choices;
    if (choices) pick_function();
    out_.doc(choices ? "Starts the transition whose turn it is: inner states first, then textual order."
                     : "Starts the first enabled transition: inner states first, then textual order.");
    out_.open(signature(choices ? "bool attempt" : "bool transition"));
    out_.open("switch (f.at) {");
    for (std::uint32_t index = 0; index < machine.nodes.size(); ++index) {
        const NodeId id{index};
        const std::vector<std::string> calls = plan_.settles(id) ? attempts(id) : std::vector<std::string>{};
        if (calls.empty()) continue;
        out_.line(fmt::format("case {}: return {};", control_.at(plan_.label(id)), fmt::join(calls, " || ")));
    }
    out_.line("default: return false;");
    out_.close();
    out_.close();
}

/// Reference API A6: a first pass counts the choices and takes none of them.
void TransitionCode::pick_function() {
    out_.doc("Starts one of the enabled transitions: the platform picks, or it is the first.");
    out_.open(signature("bool transition"));
    out_.open("if constexpr (robochart::Picks<Platform>::value) {");
    out_.line("turn_.count();");
    out_.line(call("attempt") + ";");
    out_.line("if (turn_.counted() == 0) return false;");
    out_.line("turn_.take(robochart::pick(platform_, turn_.counted()));");
    out_.close();
    out_.line(fmt::format("return {};", call("attempt")));
    out_.close();
    out_.gap();
}

std::vector<std::string> TransitionCode::attempts(NodeId leaf) const {
    std::vector<std::string> calls;
    const std::vector<NodeId> chain = plan_.chain(leaf);
    for (const NodeId state : chain)
        if (!plan_.node(state).outgoing.empty()) calls.push_back(call("from_" + plan_.label(state)));
    return calls;
}

void TransitionCode::from_function(NodeId id) {
    out_.declaration("Transitions of " + generation_.place(plan_.node(id).origin),
                     signature("bool from_" + plan_.label(id)));
    bool certain = false;
    for (const ir::TransitionId way : plan_.node(id).outgoing) {
        if (certain) break;
        certain = try_transition(plan_.machine().transitions[way.index]);
    }
    if (!certain) out_.line("return false;");
    out_.close();
}

bool TransitionCode::try_transition(const ir::Transition& transition) {
    const ir::TransitionId id{static_cast<std::uint32_t>(&transition - plan_.machine().transitions.data())};
    out_.comment(generation_.place(transition.origin));
    reset_too_soon(transition);
    if (transition.trigger) return try_trigger(transition, id);
    const CppExpr condition = steps_.in_turn(steps_.guard(transition, ""));
    out_.when(condition, [&] { begin_transition(transition, id); });
    return condition.empty();
}

/// Fault::reset_before_guard.
void TransitionCode::reset_too_soon(const ir::Transition& transition) {
    for (const ir::ClockId clock : transition.resets)
        if (generation_.mutation.hits(Fault::reset_before_guard)) reset_clocks(generation_, unit_, {clock}, out_);
}

bool TransitionCode::try_trigger(const ir::Transition& transition, ir::TransitionId id) {
    CppExpr late_guard;
    const Condition condition = [&](const std::string& incoming) {
        late_guard = {};
        CppExpr holds = steps_.guard(transition, incoming);
        if (holds.empty() || !generation_.mutation.hits(Fault::guard_after_consume)) return steps_.in_turn(holds);
        late_guard = std::move(holds);
        return steps_.in_turn({});
    };
    return receive(generation_, unit_, *transition.trigger, out_, condition, [&] {
        if (!late_guard.empty()) out_.line(fmt::format("if (!({})) return false;", late_guard.whole()));
        begin_transition(transition, id);
    });
}

void TransitionCode::begin_transition(const ir::Transition& transition, ir::TransitionId id) {
    reset_clocks(generation_, unit_, transition.resets, out_);
    out_.line(steps_.tell_taken(id));
    depart(transition.source, id);
    out_.line(generation_.bound_test().empty() ? "return true;" : "return spend();");
}

/// Interrupts the during actions of the state and of all inner states, and starts the exits.
void TransitionCode::depart(NodeId source, ir::TransitionId id) {
    for (const DuringThread& during : during_) {
        const std::vector<NodeId> around = plan_.chain(during.state);
        const bool left = std::ranges::find(around, source) != around.end();
        if (left) out_.line(fmt::format("cut_{}(f);", during.suffix));
    }
    for (const Watch& watch : watches_) {
        const std::vector<NodeId> around = plan_.chain(watch.state);
        const bool left = std::ranges::find(around, source) != around.end();
        if (left) out_.line(fmt::format("f.{} = 0;", watch.field));
    }
    const ir::Transition& transition = plan_.machine().transitions[id.index];
    const bool composite = plan_.node(source).composite();
    const bool skips = faults_.skips_children(source);
    for (const NodeId history : context_.histories)
        if (history == source) out_.line(fmt::format("f.history_{} = f.at;", plan_.label(source)));
    if (!plan_.notes_leaving(source)) {
        const std::string own = plan_.node(source).exit ? call(plan_.exit_label(source)) + ";" : "";
        const std::string exits = plan_.acts(transition) && !plan_.straight_exits(source) ? ""
                                  : skips                                                 ? own
                                                                                          : steps_.leave(source);
        if (faults_.acts_first(transition) && !plan_.acts(transition))
            out_.raw(steps_.straight_program(transition.action, 3));
        if (!exits.empty()) out_.line(exits);
        return out_.line(steps_.proceed(transition));
    }
    out_.line(fmt::format("f.leaving = {}::{};", context_.leaving, plan_.take_label(id)));
    out_.line(skips || !composite ? control_.go(plan_.exit_label(source)) : "leave(f);");
}

}  // namespace robochart::cpp_emit
