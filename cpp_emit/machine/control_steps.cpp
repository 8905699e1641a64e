// SPDX-License-Identifier: Apache-2.0
#include "cpp_emit/machine/control_steps.hpp"

#include <cassert>

#include <fmt/format.h>

#include "cpp_emit/code/assignment.hpp"
#include "cpp_emit/code/reception.hpp"
#include "cpp_emit/code/suspension.hpp"
#include "cpp_emit/code/transition_numbers.hpp"
#include "cpp_emit/expressions/expression.hpp"
#include "cpp_emit/plan/walk.hpp"

namespace robochart::cpp_emit {

using ir::NodeId;
using ir::NodeKind;

bool ControlSteps::enters_without_waiting(NodeId id) {
    return plan_.is_straight(id) && !faults_.enters_child_first(id);
}

bool ControlSteps::has_place(const ir::Transition& transition) {
    return plan_.acts_after_trigger(transition) || faults_.acts_late(transition);
}

/// Returns the lines of a program that never waits.
std::string ControlSteps::straight_program(const ir::StmtPtr& program, std::size_t depth) {
    Thread lines;
    ProgramWriter writer(generation_, unit_, lines, {});
    writer.begin_place("", "");
    writer.current_code() = CodeWriter(depth);
    writer.write_statement(program, "");
    return writer.current_code().text();
}

/// Returns the statement that runs the exits of a state and of its active inner states; "" if there are none.
std::string ControlSteps::leave_statement(NodeId id) const {
    if (plan_.exits_below(id)) return function_call("leave_" + plan_.label_of(id)) + ";";
    return plan_.node(id).exit ? function_call(plan_.exit_label(id)) + ";" : "";
}

/// Returns the statement that moves control into a node.
std::string ControlSteps::arrive_statement(NodeId id) {
    assert(id.index < unit_.machine->nodes.size());
    if (plan_.needs_entry(id))
        return enters_without_waiting(id) ? function_call(plan_.enter_label(id)) + ";"
                                          : control_.go_statement(plan_.enter_label(id));
    const bool rests = plan_.is_resting_place(id) || !plan_.is_straight(id);
    return rests ? control_.go_statement(plan_.label_of(id)) : function_call("pass_" + plan_.label_of(id)) + ";";
}

/// Returns the statement that continues a transition after the exits.
const std::string& ControlSteps::proceed_statement(const ir::Transition& transition) {
    const ir::TransitionId id{static_cast<std::uint32_t>(&transition - plan_.machine().transitions.data())};
    assert(id.index < unit_.machine->transitions.size());
    std::string& text = proceeds_[id.index];
    if (!text.empty()) return text;
    const std::string& label = plan_.take_label(id);
    if (has_place(transition)) return text = control_.go_statement(label);
    return text = transition.action ? function_call(label) + ";" : arrive_statement(transition.target);
}

/// Writes the code after a node's entry action.
void ControlSteps::write_settling(NodeId id, CodeWriter& out, const char* end) {
    if (!plan_.node(id).is_composite()) {
        note_entry(id, out);
        out.line(control_.go_statement(plan_.label_of(id)));
        if (context_.runs_on_entry(id)) out.write_raw(straight_program(plan_.node(id).during, *end == 'b' ? 5 : 2));
        return;
    }
    if (plan_.notes_entry(id)) out.line(fmt::format("f.entering_{} = true;", plan_.label_of(id)));
    if (faults_.resumes_composite(id)) {
        const std::string history = fmt::format("f.history_{}", plan_.label_of(id));
        out.open(fmt::format("if ({} != {}{{}}) {{", history, unit_.points));
        out.line(fmt::format("f.at = {};", history));
        out.line(end);
        out.close();
    }
    begin(plan_.node(id).initial, out);
}

/// Writes the code with which control enters an initial node and, if its transition has no condition, moves on to the
/// target.
void ControlSteps::begin(NodeId initial, CodeWriter& out) {
    assert(initial.index < unit_.machine->nodes.size());
    if (!plan_.is_passed_through(initial)) return out.line(arrive_statement(initial));
    const ir::TransitionId only = plan_.node(initial).outgoing.front();
    out.comment(generation_.place_text(plan_.machine().transitions[only.index].origin));
    out.line(tell_taken(only));
    out.line(proceed_statement(plan_.machine().transitions[only.index]));
}

void ControlSteps::note_entry(NodeId id, CodeWriter& out) {
    if (plan_.notes_entry(id)) mark_entered(id, out);
    for (const NodeId outer : plan_.ancestors(id)) {
        if (!plan_.notes_entry(outer)) continue;
        out.open(fmt::format("if (f.entering_{}) {{", plan_.label_of(outer)));
        out.line(fmt::format("f.entering_{} = false;", plan_.label_of(outer)));
        mark_entered(outer, out);
        out.close();
    }
}

void ControlSteps::mark_entered(NodeId id, CodeWriter& out) {
    const ir::ClockId clock = entry_clock(plan_.machine(), id);
    if (clock.is_valid()) {
        const std::string line = clock_reset(generation_, unit_, clock);
        if (!line.empty() && !generation_.mutation.hits(Fault::clock_not_reset)) out.line(line);
    }
    for (const DuringThread& during : during_)
        if (during.state == id) out.line(during.thread.go_statement("start"));
    for (const Watch& watch : watches_) {
        if (watch.state != id) continue;
        const std::string line = start_of(watch);
        if (!line.empty()) out.line(line);
    }
}

/// Writes the code that takes the first transition whose guard holds. Returns true if there may be none; control then
/// stays (semantics 3.3, 3.4).
bool ControlSteps::write_ways(NodeId id, CodeWriter& out, const char* end) {
    const auto& outgoing = plan_.node(id).outgoing;
    write_blocking(id, out, end);
    if (generation_.options.choices && outgoing.size() > 1) return pick_way(id, out, end);
    for (const ir::TransitionId way : outgoing) {
        const ir::Transition& transition = plan_.machine().transitions[way.index];
        out.comment(generation_.place_text(transition.origin));
        const CppExpr condition = guard_condition(transition, "");
        out.write_if(condition, [&] {
            for (const ir::StmtPtr& store : transition.stores) out.write_raw(straight_program(store, 3));
            reset_clocks(generation_, unit_, transition.resets, out);
            out.line(tell_taken(way));
            out.line(proceed_statement(transition));
            if (!condition.empty() || *end == 'b') out.line(end);
        });
        if (condition.empty()) return false;
    }
    return true;
}

/// Writes a test that is true if this cycle has written none of the local variables that the guards read. Then control
/// has been in the node since an earlier cycle, in which the guards had the same values. So no guard is true, and
/// control stays.
void ControlSteps::write_blocking(NodeId id, CodeWriter& out, const char* end) {
    if (unit_.awaited_locals.empty()) return;
    CppExpr written;
    for (const ir::VariableId variable : unit_.awaited_locals.at(id.index))
        written =
            conjunction(written, CppExpr(generation_.component.stored_variable(unit_, variable)->field + ".written"));
    if (written.empty()) return;
    out.open(fmt::format("if ({}) {{", negation(written).whole_text()));
    out.line(control_.go_statement(plan_.label_of(id)));
    out.line(*end == 'b' ? "return moved;" : "return;");
    out.close();
}

/// Like write_ways, but the platform picks one of the transitions whose guards hold.
bool ControlSteps::pick_way(NodeId id, CodeWriter& out, const char* end) {
    const bool function = *end == 'r';
    const auto& outgoing = plan_.node(id).outgoing;
    std::string open;
    for (const ir::TransitionId transition : outgoing) {
        const CppExpr condition = guard_condition(plan_.machine().transitions[transition.index], "");
        open += (open.empty() ? "" : ", ") + (condition.empty() ? "true" : condition.whole_text());
    }
    out.open("{");
    out.line(fmt::format("const bool open[] = {{{}}};", open));
    out.open("switch (robochart::pick_open(platform_, open)) {");
    for (std::size_t way = 0; way < outgoing.size(); ++way) {
        const ir::Transition& transition = plan_.machine().transitions[outgoing[way].index];
        out.comment(generation_.place_text(transition.origin));
        out.line(fmt::format("case {}:", way));
        for (const ir::StmtPtr& store : transition.stores) out.write_raw(straight_program(store, 3));
        reset_clocks(generation_, unit_, transition.resets, out);
        out.line(tell_taken(outgoing[way]));
        out.line(proceed_statement(transition));
        out.line(end);
    }
    out.line(function ? "default: break;" : "default: return moved;");
    out.close();
    out.close();
    if (!function) out.line("break;");
    return function;
}

CppExpr ControlSteps::guard_condition(const ir::Transition& transition, const std::string& incoming) const {
    if (!transition.guard) return {};
    ExpressionWriter expressions(generation_, unit_);
    if (transition.trigger) expressions.set_incoming(as_variable(generation_, unit_, *transition.trigger, incoming));
    return expressions.expression_asked(*transition.guard);
}

std::string ControlSteps::tell_taken(ir::TransitionId id) const {
    assert(id.index < unit_.machine->transitions.size());
    return fmt::format("taken({});", transition_number(unit_, id));
}

/// Returns the guard. If the code has choices, it includes the condition that the platform has picked the transition.
CppExpr ControlSteps::picked_guard(const CppExpr& guard) const {
    return generation_.options.choices ? conjunction(guard, CppExpr("in_turn()")) : guard;
}

std::string ControlSteps::start_of(const Watch& watch) const {
    const ir::Transition& transition = plan_.machine().transitions[watch.transition.index];
    return watch_from(generation_, unit_, watch.field, *transition.deadline);
}

}  // namespace robochart::cpp_emit
