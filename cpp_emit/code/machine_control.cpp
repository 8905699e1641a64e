// Control and during threads: entry, exit and transition actions in the order of semantics 3.4:
// exits innermost first, transition action, target's entry, initial transition and first child, `entered`.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "cpp_emit/code/assignment.hpp"
#include "cpp_emit/code/fault_injection.hpp"
#include "cpp_emit/code/machine_writer.hpp"
#include "cpp_emit/code/suspension.hpp"
#include "cpp_emit/expressions/expression.hpp"
#include "cpp_emit/plan/types.hpp"
#include "cpp_emit/plan/walk.hpp"

namespace robochart::cpp_emit {

using ir::NodeId;
using ir::NodeKind;

void MachineWriter::control_places() {
    const ir::Machine& machine = plan_.machine();
    for (std::uint32_t index = 0; index < machine.nodes.size(); ++index) {
        const NodeId id{index};
        const ir::Node& node = machine.nodes[index];
        if (node.kind == NodeKind::initial || node.kind == NodeKind::junction) choice(id);
        if (node.kind == NodeKind::probabilistic) draw_place(id);
        if (plan_.needs_entry(id)) {
            if (straight(id)) {
                enter_function(id);
            } else {
                enter_place(id);
            }
        }
        exits(id);
        for (const ir::TransitionId transition : node.outgoing) take(transition);
    }
}

/// Initial nodes and junctions.
void MachineWriter::choice(NodeId id) {
    const bool first = id == plan_.machine().initial;
    const bool stays = plan_.straight(id) && !plan_.passes(id) && pass_function(id);
    if (plan_.straight(id) && !first && !stays) return;
    ProgramWriter program(generation_, unit_, control_, plan_.node(id).parent);
    program.begin(plan_.label(id), generation_.place(plan_.node(id).origin));
    if (!plan_.straight(id)) {
        if (ways(id, program.code(), "break;")) program.code().line("return moved;");
        return;
    }
    begin(id, program.code());
    if (stays) program.line(fmt::format("if (f.at == {}) return moved;", control_.at(plan_.label(id))));
    program.line("break;");
}

/// The first transition whose guard holds is taken. True if there may be none: control stays (semantics 3.3, 3.4).
bool MachineWriter::ways(NodeId id, CodeWriter& out, const char* end) {
    const auto& outgoing = plan_.node(id).outgoing;
    if (generation_.options.choices && outgoing.size() > 1) return pick_way(id, out, end);
    for (const ir::TransitionId way : outgoing) {
        const ir::Transition& transition = plan_.machine().transitions[way.index];
        out.comment(generation_.place(transition.origin));
        const CppExpr condition = guard(transition, "");
        if (!condition.empty()) out.open(fmt::format("if ({}) {{", condition.whole()));
        for (const ir::ClockId clock : transition.resets) {
            const std::string reset = clock_reset(generation_, unit_, clock);
            if (!reset.empty()) out.line(reset);
        }
        out.line(tell_taken(way));
        out.line(proceed(transition));
        if (!condition.empty() || *end == 'b') out.line(end);
        if (condition.empty()) return false;
        out.close();
    }
    return true;
}

/// The same where the platform picks one of those whose guards hold.
bool MachineWriter::pick_way(NodeId id, CodeWriter& out, const char* end) {
    const bool function = *end == 'r';
    const auto& outgoing = plan_.node(id).outgoing;
    std::string open;
    for (const ir::TransitionId transition : outgoing) {
        const CppExpr condition = guard(plan_.machine().transitions[transition.index], "");
        open += (open.empty() ? "" : ", ") + (condition.empty() ? "true" : condition.whole());
    }
    out.open("{");
    out.line(fmt::format("const bool open[] = {{{}}};", open));
    out.open("switch (robochart::pick_open(platform_, open)) {");
    for (std::size_t way = 0; way < outgoing.size(); ++way) {
        const ir::Transition& transition = plan_.machine().transitions[outgoing[way].index];
        out.comment(generation_.place(transition.origin));
        out.line(fmt::format("case {}:", way));
        for (const ir::ClockId clock : transition.resets) {
            const std::string reset = clock_reset(generation_, unit_, clock);
            if (!reset.empty()) out.line(reset);
        }
        out.line(tell_taken(outgoing[way]));
        out.line(proceed(transition));
        out.line(end);
    }
    out.line(function ? "default: break;" : "default: return moved;");
    out.close();
    out.close();
    if (!function) out.line("break;");
    return function;
}

/// Probabilistic junctions: a free choice in the semantics, drawn by the platform.
void MachineWriter::draw_place(NodeId id) {
    ProgramWriter program(generation_, unit_, control_, plan_.node(id).parent);
    program.begin(plan_.label(id), generation_.place(plan_.node(id).origin));
    const auto& ways = plan_.node(id).outgoing;
    if (ways.empty()) return program.code().line("return moved;");
    const ExpressionWriter expressions(generation_, unit_);
    std::string chances;
    for (const ir::TransitionId way : ways) {
        const ir::ExprPtr& probability = plan_.machine().transitions[way.index].probability;
        const std::string text = !probability ? "1.0"
                                 : probability->kind == ir::ExprKind::real
                                     ? decimal_text(probability->decimal)
                                     : fmt::format("robochart::chance({})", expressions.write(*probability));
        chances += (chances.empty() ? "" : ", ") + text;
    }
    program.code().open("{");
    program.code().line(fmt::format("const double chances[] = {{{}}};", chances));
    program.code().open("switch (robochart::choose(platform_, chances)) {");
    for (std::size_t way = 0; way < ways.size(); ++way) {
        const ir::Transition& transition = plan_.machine().transitions[ways[way].index];
        program.code().comment(generation_.place(transition.origin));
        program.code().line(way + 1 == ways.size() ? "default:" : fmt::format("case {}:", way));
        for (const ir::ClockId clock : transition.resets) program.line(clock_reset(generation_, unit_, clock));
        program.line(tell_taken(ways[way]));
        program.line(proceed(transition));
        program.line("break;");
    }
    program.code().close();
    program.code().close();
    program.code().line("break;");
}

/// The entry of a node whose entry action may wait.
void MachineWriter::enter_place(NodeId id) {
    const bool state = plan_.node(id).kind == NodeKind::state;
    ProgramWriter program(generation_, unit_, control_, state ? id : plan_.node(id).parent);
    const ir::Node& node = plan_.node(id);
    const std::string label = plan_.enter_label(id);
    program.begin(label, "enters " + generation_.place(node.origin));
    if (enters_child_first(id)) return enter_child_first(program, id);
    if (node.entry) program.statement(node.entry, label);
    settle(id, program.code(), "break;");
    program.line("break;");
}

/// What follows a node's entry action.
void MachineWriter::settle(NodeId id, CodeWriter& out, const char* end) {
    if (!plan_.node(id).composite()) {
        note_entry(id, out);
        out.line(control_.go(plan_.label(id)));
        if (runs_on_entry(id)) out.raw(straight_program(plan_.node(id).during, *end == 'b' ? 5 : 2));
        return;
    }
    if (plan_.notes_entry(id)) out.line(fmt::format("f.entering_{} = true;", plan_.label(id)));
    if (generation_.mutation.hits(Fault::composite_resumed)) {
        histories_.push_back(id);
        const std::string history = fmt::format("f.history_{}", plan_.label(id));
        out.open(fmt::format("if ({} != {}{{}}) {{", history, unit_.points));
        out.line(fmt::format("f.at = {};", history));
        out.line(end);
        out.close();
    }
    begin(plan_.node(id).initial, out);
}

/// Control comes to an initial node, and if it asks for nothing on to where it leads.
void MachineWriter::begin(NodeId initial, CodeWriter& out) {
    if (!plan_.passes(initial)) return out.line(arrive(initial));
    const ir::TransitionId only = plan_.node(initial).outgoing.front();
    out.comment(generation_.place(plan_.machine().transitions[only.index].origin));
    out.line(tell_taken(only));
    out.line(proceed(plan_.machine().transitions[only.index]));
}

/// Fault::entry_inner_first at a composite whose initial node leads to a child without more ado.
bool MachineWriter::enters_child_first(NodeId id) {
    return plan_.node(id).entry != nullptr && sole_first_child(id).valid() &&
           generation_.mutation.hits(Fault::entry_inner_first, &unit_, &plan_.node(id));
}

NodeId MachineWriter::sole_first_child(NodeId id) const {
    const ir::Node& node = plan_.node(id);
    if (!node.composite()) return {};
    const auto& ways = plan_.node(node.initial).outgoing;
    if (ways.size() != 1) return {};
    const ir::Transition& way = plan_.machine().transitions[ways.front().index];
    const bool plain = way.guard == nullptr && way.action == nullptr && way.resets.empty();
    const ir::Node& child = plan_.node(way.target);
    return plain && child.kind == NodeKind::state && !child.composite() && child.entry != nullptr ? way.target
                                                                                                  : NodeId{};
}

void MachineWriter::enter_child_first(ProgramWriter& program, NodeId id) {
    const NodeId child = sole_first_child(id);
    const std::string label = plan_.enter_label(id);
    if (plan_.notes_entry(id)) program.code().line(fmt::format("f.entering_{} = true;", plan_.label(id)));
    program.statement(plan_.node(child).entry, label);
    program.statement(plan_.node(id).entry, label);
    note_entry(child, program.code());
    program.jump(plan_.label(child));
}

/// The state itself is entered, and with its first child each composite around it (semantics 3.3 a).
void MachineWriter::note_entry(NodeId id, CodeWriter& out) {
    if (plan_.notes_entry(id)) mark_entered(id, out);
    for (const NodeId outer : plan_.ancestors(id)) {
        if (!plan_.notes_entry(outer)) continue;
        out.open(fmt::format("if (f.entering_{}) {{", plan_.label(outer)));
        out.line(fmt::format("f.entering_{} = false;", plan_.label(outer)));
        mark_entered(outer, out);
        out.close();
    }
}

void MachineWriter::mark_entered(NodeId id, CodeWriter& out) {
    const ir::ClockId clock = entry_clock(plan_.machine(), id);
    if (clock.valid()) {
        const std::string line = clock_reset(generation_, unit_, clock);
        if (!line.empty() && !generation_.mutation.hits(Fault::clock_not_reset)) out.line(line);
    }
    for (const DuringThread& during : during_)
        if (during.state == id) out.line(during.thread.go("start"));
    for (const Watch& watch : watches_) {
        if (watch.state != id) continue;
        const std::string line = start_of(watch);
        if (!line.empty()) out.line(line);
    }
}

void MachineWriter::exits(NodeId id) {
    const auto left = [&](NodeId state) { return !plan_.node(state).outgoing.empty(); };
    const std::vector<NodeId> around = plan_.chain(id);
    if (plan_.node(id).kind != NodeKind::state || std::none_of(around.begin(), around.end(), left)) return;
    if (plan_.node(id).exit && !suspends(generation_, unit_, plan_.node(id).exit)) exit_function(id);
    if (plan_.straight_exits(id) && plan_.exits_below(id)) leave_function(id);
    if (plan_.shared_exit(id)) exit_place(id);
}

/// A shared exit place: the state's exit action, then the transition that leaves it or the exit around it.
void MachineWriter::exit_place(NodeId id) {
    ProgramWriter program(generation_, unit_, control_, id);
    const ir::Node& node = plan_.node(id);
    const std::string label = plan_.exit_label(id);
    program.begin(label, "leaves " + generation_.place(node.origin));
    exit_outer_before(program, id);
    act_before(program, id);
    const bool waits = suspends(generation_, unit_, node.exit);
    if (node.exit && !waits && !(plan_.notes_leaving(id) && exits_first(id))) program.line(call(label) + ";");
    if (waits) program.statement(node.exit, label);
    for (const ir::TransitionId transition : node.outgoing) {
        if (!plan_.notes_leaving(id)) break;
        program.code().open(fmt::format("if (f.leaving == {}::{}) {{", leaving_, plan_.take_label(transition)));
        program.code().line(fmt::format("f.leaving = {}::nothing;", leaving_));
        program.line(proceed(plan_.machine().transitions[transition.index]));
        program.line("break;");
        program.code().close();
    }
    if (node.parent.valid() && plan_.shared_exit(node.parent)) return program.jump(plan_.exit_label(node.parent));
    program.code().line("return moved;");
}

/// Fault::exit_outer_first: the composite's exit action has run before those below it.
bool MachineWriter::exits_first(NodeId id) {
    const ir::Node& node = plan_.node(id);
    return node.composite() && node.exit != nullptr && !node.outgoing.empty() &&
           !suspends(generation_, unit_, node.exit) &&
           generation_.mutation.hits(Fault::exit_outer_first, &unit_, &node);
}

void MachineWriter::exit_outer_before(ProgramWriter& program, NodeId id) {
    if (plan_.node(id).composite()) return;
    for (const NodeId outer : plan_.ancestors(id)) {
        if (!plan_.notes_leaving(outer) || !exits_first(outer)) continue;
        std::vector<std::string> left;
        for (const ir::TransitionId way : plan_.node(outer).outgoing)
            left.push_back(fmt::format("f.leaving == {}::{}", leaving_, plan_.take_label(way)));
        program.code().open(fmt::format("if ({}) {{", fmt::join(left, " || ")));
        program.statement(plan_.node(outer).exit, plan_.exit_label(id));
        program.code().close();
    }
}

/// Fault::action_before_exit where the exit has a place of its own.
bool MachineWriter::acts_first(const ir::Transition& transition) {
    const ir::Node& source = plan_.node(transition.source);
    return transition.action != nullptr && source.exit != nullptr && !suspends(generation_, unit_, transition.action) &&
           generation_.mutation.hits(Fault::action_before_exit, &unit_, &transition);
}

void MachineWriter::act_before(ProgramWriter& program, NodeId id) {
    for (const ir::TransitionId way : plan_.node(id).outgoing) {
        const ir::Transition& transition = plan_.machine().transitions[way.index];
        if (!plan_.notes_leaving(id) || !acts_first(transition)) continue;
        program.code().open(fmt::format("if (f.leaving == {}::{}) {{", leaving_, plan_.take_label(way)));
        program.statement(transition.action, plan_.exit_label(id));
        program.code().close();
    }
}

/// Fault::action_after_entry.
bool MachineWriter::acts_late(const ir::Transition& transition) {
    const ir::Node& target = plan_.node(transition.target);
    return transition.action != nullptr && target.kind == NodeKind::state && !target.composite() &&
           target.entry != nullptr && generation_.mutation.hits(Fault::action_after_entry, &unit_, &transition);
}

/// During a transition's action the machine shows its source, or the state around an initial node or junction.
ir::NodeId MachineWriter::shown_while_taking(ir::TransitionId id) const {
    const NodeId source = plan_.machine().transitions[id.index].source;
    return plan_.node(source).kind == NodeKind::state ? source : plan_.node(source).parent;
}

void MachineWriter::take(ir::TransitionId id) {
    const ir::Transition& transition = plan_.machine().transitions[id.index];
    if (has_place(transition)) return take_place(id);
    if (transition.action) take_function(id);
}

/// Exit action of the source, unless it has a place of its own, and the transition's action, one of which may wait.
void MachineWriter::take_place(ir::TransitionId id) {
    ProgramWriter program(generation_, unit_, control_, shown_while_taking(id));
    const ir::Transition& transition = plan_.machine().transitions[id.index];
    const std::string label = plan_.take_label(id);
    program.begin(label, "takes " + generation_.place(transition.origin));
    const ir::Node& source = plan_.node(transition.source);
    const bool exits = suspends(generation_, unit_, source.exit) && !plan_.shared_exit(transition.source);
    const bool first = acts_first(transition);
    if (first && exits) program.statement(transition.action, label);
    if (exits) program.statement(source.exit, label);
    if (acts_late(transition)) return act_late(program, transition, label);
    if (transition.action && !first) program.statement(transition.action, label);
    program.line(arrive(transition.target));
    program.line("break;");
}

void MachineWriter::act_late(ProgramWriter& program, const ir::Transition& transition, const std::string& label) {
    program.statement(plan_.node(transition.target).entry, label);
    program.statement(transition.action, label);
    note_entry(transition.target, program.code());
    program.jump(plan_.label(transition.target));
}

void MachineWriter::during_places() {
    for (DuringThread& during : during_) {
        const ir::Node& state = plan_.node(during.state);
        ProgramWriter program(generation_, unit_, during.thread, during.state);
        program.begin("start", "during action of " + generation_.place(state.origin));
        program.statement(state.during, "step");
        program.jump("idle");
    }
}

}  // namespace robochart::cpp_emit
