// The choice of transitions: active states from the inside out, in each the textual order. Triggers are looked at
// before they are consumed, guards see the incoming value (semantics 3.4 "Guards").
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "cpp_emit/code/assignment.hpp"
#include "cpp_emit/code/fault_injection.hpp"
#include "cpp_emit/code/machine_writer.hpp"
#include "cpp_emit/code/reception.hpp"
#include "cpp_emit/code/transition_numbers.hpp"
#include "cpp_emit/expressions/expression.hpp"

namespace robochart::cpp_emit {

using ir::NodeId;
using ir::NodeKind;

void MachineWriter::transition_functions() {
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

/// Reference API A6: the choices are counted by going through them once without taking any.
void MachineWriter::pick_function() {
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

/// With choices: the guard, and that it is the transition's turn.
CppExpr MachineWriter::in_turn(const CppExpr& guard) const {
    return generation_.options.choices ? conjunction(guard, CppExpr("in_turn()")) : guard;
}

std::vector<std::string> MachineWriter::attempts(NodeId leaf) const {
    std::vector<std::string> calls;
    const std::vector<NodeId> chain = plan_.chain(leaf);
    for (const NodeId state : chain)
        if (!plan_.node(state).outgoing.empty()) calls.push_back(call("from_" + plan_.label(state)));
    return calls;
}

void MachineWriter::from_function(NodeId id) {
    out_.gap();
    out_.doc("Transitions of " + generation_.place(plan_.node(id).origin));
    out_.open(signature("bool from_" + plan_.label(id)));
    bool certain = false;
    for (const ir::TransitionId way : plan_.node(id).outgoing) {
        if (certain) break;
        certain = try_transition(plan_.machine().transitions[way.index]);
    }
    if (!certain) out_.line("return false;");
    out_.close();
}

bool MachineWriter::try_transition(const ir::Transition& transition) {
    const ir::TransitionId id{static_cast<std::uint32_t>(&transition - plan_.machine().transitions.data())};
    out_.comment(generation_.place(transition.origin));
    reset_too_soon(transition);
    if (transition.trigger) return try_trigger(transition, id);
    const CppExpr condition = in_turn(guard(transition, ""));
    if (!condition.empty()) out_.open(fmt::format("if ({}) {{", condition.whole()));
    begin_transition(transition, id);
    if (!condition.empty()) out_.close();
    return condition.empty();
}

/// Fault::reset_before_guard.
void MachineWriter::reset_too_soon(const ir::Transition& transition) {
    for (const ir::ClockId clock : transition.resets) {
        if (!generation_.mutation.hits(Fault::reset_before_guard)) continue;
        const std::string line = clock_reset(generation_, unit_, clock);
        if (!line.empty()) out_.line(line);
    }
}

bool MachineWriter::try_trigger(const ir::Transition& transition, ir::TransitionId id) {
    CppExpr late_guard;
    const Condition condition = [&](const std::string& incoming) {
        late_guard = {};
        CppExpr holds = guard(transition, incoming);
        if (holds.empty() || !generation_.mutation.hits(Fault::guard_after_consume)) return in_turn(holds);
        late_guard = std::move(holds);
        return in_turn({});
    };
    return receive(generation_, unit_, *transition.trigger, out_, condition, [&] {
        if (!late_guard.empty()) out_.line(fmt::format("if (!({})) return false;", late_guard.whole()));
        begin_transition(transition, id);
    });
}

void MachineWriter::begin_transition(const ir::Transition& transition, ir::TransitionId id) {
    for (const ir::ClockId clock : transition.resets) {
        const std::string line = clock_reset(generation_, unit_, clock);
        if (!line.empty()) out_.line(line);
    }
    out_.line(tell_taken(id));
    depart(transition.source, id);
    out_.line(bound_test(generation_).empty() ? "return true;" : "return spend();");
}

std::string MachineWriter::tell_taken(ir::TransitionId id) const {
    return fmt::format("taken({});", transition_number(unit_, id));
}

CppExpr MachineWriter::guard(const ir::Transition& transition, const std::string& incoming) const {
    if (!transition.guard) return {};
    ExpressionWriter expressions(generation_, unit_);
    if (transition.trigger) expressions.set_incoming(incoming);
    return expressions.expression_asked(*transition.guard);
}

/// Cuts the during actions of the state and of all below it, and starts the exits.
void MachineWriter::depart(NodeId source, ir::TransitionId id) {
    for (const DuringThread& during : during_) {
        const std::vector<NodeId> around = plan_.chain(during.state);
        const bool left = std::find(around.begin(), around.end(), source) != around.end();
        if (left) out_.line(fmt::format("cut_{}(f);", during.suffix));
    }
    for (const Watch& watch : watches_) {
        const std::vector<NodeId> around = plan_.chain(watch.state);
        const bool left = std::find(around.begin(), around.end(), source) != around.end();
        if (left) out_.line(fmt::format("f.{} = 0;", watch.field));
    }
    const ir::Transition& transition = plan_.machine().transitions[id.index];
    const bool composite = plan_.node(source).composite();
    const bool skips = composite && generation_.mutation.hits(Fault::children_not_exited);
    for (const NodeId history : histories_)
        if (history == source) out_.line(fmt::format("f.history_{} = f.at;", plan_.label(source)));
    if (!plan_.notes_leaving(source)) {
        const std::string own = plan_.node(source).exit ? call(plan_.exit_label(source)) + ";" : "";
        const std::string exits = plan_.acts(transition) && !plan_.straight_exits(source) ? ""
                                  : skips                                                 ? own
                                                                                          : leave(source);
        if (acts_first(transition) && !plan_.acts(transition)) out_.raw(straight_program(transition.action, 3));
        if (!exits.empty()) out_.line(exits);
        return out_.line(proceed(transition));
    }
    out_.line(fmt::format("f.leaving = {}::{};", leaving_, plan_.take_label(id)));
    out_.line(skips || !composite ? control_.go(plan_.exit_label(source)) : "leave(f);");
}

}  // namespace robochart::cpp_emit
