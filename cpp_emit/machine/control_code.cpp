// SPDX-License-Identifier: Apache-2.0
#include "cpp_emit/machine/control_code.hpp"

#include <fmt/format.h>
#include <algorithm>

#include "cpp_emit/code/assignment.hpp"
#include "cpp_emit/code/cycles.hpp"
#include "cpp_emit/code/suspension.hpp"
#include "cpp_emit/expressions/expression.hpp"
#include "cpp_emit/plan/types.hpp"

namespace robochart::cpp_emit {

using ir::NodeId;
using ir::NodeKind;

namespace {

/// Returns the probability of an alternative of a junction, or 1 if the model gives none.
std::string chance_text(const ir::ExprPtr& probability, const ExpressionWriter& expressions) {
    if (!probability) return "1.0";
    if (probability->kind == ir::ExprKind::real) return decimal_text(probability->decimal);
    return fmt::format("robochart::chance({})", expressions.write(*probability));
}

}  // namespace

void ControlCode::control_places() {
    const ir::Machine& machine = plan_.machine();
    for (std::uint32_t index = 0; index < machine.nodes.size(); ++index) {
        const NodeId id{index};
        const ir::Node& node = machine.nodes[index];
        if (node.kind == NodeKind::initial || node.kind == NodeKind::junction) write_choice(id);
        if (node.kind == NodeKind::probabilistic) draw_place(id);
        if (plan_.needs_entry(id)) {
            if (steps_.enters_without_waiting(id)) {
                straight_.enter_function(id);
            } else {
                enter_place(id);
            }
        }
        write_exits(id);
        for (const ir::TransitionId transition : node.outgoing) write_taking(transition);
    }
}

/// Writes the place of an initial node or junction.
void ControlCode::write_choice(NodeId id) {
    const bool first = id == plan_.machine().initial;
    const bool stays = plan_.is_straight(id) && !plan_.is_passed_through(id) && straight_.pass_function(id);
    if (plan_.is_straight(id) && !first && !stays) return;
    ProgramWriter program(generation_, unit_, control_, plan_.node(id).parent);
    program.begin_place(plan_.label_of(id), generation_.place_text(plan_.node(id).origin));
    if (!plan_.is_straight(id)) {
        await_cycle(program);
        if (steps_.write_ways(id, program.current_code(), "break;")) program.current_code().line("return moved;");
        return;
    }
    steps_.begin(id, program.current_code());
    if (stays)
        program.write_line(fmt::format("if (f.at == {}) return moved;", control_.qualified_label(plan_.label_of(id))));
    program.write_line("break;");
}

/// For RoboSim: ensures that no transition is taken after the end of the cycle.
void ControlCode::await_cycle(ProgramWriter& program) {
    if (plan_.awaits_registers())
        program.write_line(fmt::format("if ({}) return moved;", ended_member(generation_.component, unit_)));
}

/// Writes the place of a probabilistic junction. In the semantics the junction is a nondeterministic choice; the
/// platform draws an alternative.
void ControlCode::draw_place(NodeId id) {
    ProgramWriter program(generation_, unit_, control_, plan_.node(id).parent);
    program.begin_place(plan_.label_of(id), generation_.place_text(plan_.node(id).origin));
    const auto& ways = plan_.node(id).outgoing;
    if (ways.empty()) return program.current_code().line("return moved;");
    await_cycle(program);
    const ExpressionWriter expressions(generation_, unit_);
    std::string chances;
    for (const ir::TransitionId way : ways) {
        const ir::ExprPtr& probability = plan_.machine().transitions[way.index].probability;
        chances += (chances.empty() ? "" : ", ") + chance_text(probability, expressions);
    }
    program.current_code().open("{");
    program.current_code().line(fmt::format("const double chances[] = {{{}}};", chances));
    program.current_code().open("switch (robochart::choose(platform_, chances)) {");
    for (std::size_t way = 0; way < ways.size(); ++way) {
        const ir::Transition& transition = plan_.machine().transitions[ways[way].index];
        program.current_code().comment(generation_.place_text(transition.origin));
        program.current_code().line(way + 1 == ways.size() ? "default:" : fmt::format("case {}:", way));
        reset_clocks(generation_, unit_, transition.resets, program.current_code());
        program.write_line(steps_.tell_taken(ways[way]));
        program.write_line(steps_.proceed_statement(transition));
        program.write_line("break;");
    }
    program.current_code().close();
    program.current_code().close();
    program.current_code().line("break;");
}

/// Writes the place for entering a node whose entry action may wait.
void ControlCode::enter_place(NodeId id) {
    const bool state = plan_.node(id).kind == NodeKind::state;
    ProgramWriter program(generation_, unit_, control_, state ? id : plan_.node(id).parent);
    const ir::Node& node = plan_.node(id);
    const std::string label = plan_.enter_label(id);
    program.begin_place(label, "enters " + generation_.place_text(node.origin));
    if (faults_.enters_child_first(id)) return order_.enter_child_first(program, id);
    if (node.entry) program.write_statement(node.entry, label);
    steps_.write_settling(id, program.current_code(), "break;");
    program.write_line("break;");
}

void ControlCode::write_exits(NodeId id) {
    const auto left = [&](NodeId state) { return !plan_.node(state).outgoing.empty(); };
    const std::vector<NodeId> around = plan_.state_chain(id);
    if (plan_.node(id).kind != NodeKind::state || std::ranges::none_of(around, left)) return;
    if (plan_.node(id).exit && !may_suspend(generation_, unit_, plan_.node(id).exit)) straight_.exit_function(id);
    if (plan_.straight_exits(id) && plan_.exits_below(id)) straight_.leave_function(id);
    if (plan_.shared_exit(id)) exit_place(id);
}

/// Writes a shared exit place: the state's exit action, followed by the transition that leaves the state, or by the
/// exit of its parent.
void ControlCode::exit_place(NodeId id) {
    ProgramWriter program(generation_, unit_, control_, id);
    const ir::Node& node = plan_.node(id);
    const std::string label = plan_.exit_label(id);
    program.begin_place(label, "leaves " + generation_.place_text(node.origin));
    order_.exit_outer_before(program, id);
    order_.act_before(program, id);
    const bool waits = may_suspend(generation_, unit_, node.exit);
    if (node.exit && !waits && !(plan_.notes_leaving(id) && faults_.exits_first(id)))
        program.write_line(function_call(label) + ";");
    if (waits) program.write_statement(node.exit, label);
    for (const ir::TransitionId transition : node.outgoing) {
        if (!plan_.notes_leaving(id)) break;
        program.current_code().open(
            fmt::format("if (f.leaving == {}::{}) {{", context_.leaving, plan_.take_label(transition)));
        program.current_code().line(fmt::format("f.leaving = {}::nothing;", context_.leaving));
        program.write_line(steps_.proceed_statement(plan_.machine().transitions[transition.index]));
        program.write_line("break;");
        program.current_code().close();
    }
    if (node.parent.is_valid() && plan_.shared_exit(node.parent))
        return program.write_jump(plan_.exit_label(node.parent));
    program.current_code().line("return moved;");
}

void ControlCode::write_taking(ir::TransitionId id) {
    const ir::Transition& transition = plan_.machine().transitions[id.index];
    if (steps_.has_place(transition)) return take_place(id);
    if (transition.action) straight_.take_function(id);
}

/// Writes the place for taking a transition: the exit action of its source, unless that has a separate place, and the
/// transition's action. One of these actions may wait.
void ControlCode::take_place(ir::TransitionId id) {
    ProgramWriter program(generation_, unit_, control_, shown_while_taking(id));
    const ir::Transition& transition = plan_.machine().transitions[id.index];
    const std::string label = plan_.take_label(id);
    program.begin_place(label, "takes " + generation_.place_text(transition.origin));
    const ir::Node& source = plan_.node(transition.source);
    const bool exits = may_suspend(generation_, unit_, source.exit) && !plan_.shared_exit(transition.source);
    const bool first = faults_.acts_first(transition);
    if (first && exits) program.write_statement(transition.action, label);
    if (exits) program.write_statement(source.exit, label);
    if (faults_.acts_late(transition)) return order_.act_late(program, transition, label);
    if (transition.action && !first) program.write_statement(transition.action, label);
    program.write_line(steps_.arrive_statement(transition.target));
    program.write_line("break;");
}

/// Returns the state that the machine shows during a transition's action: the source, or the parent of an initial node
/// or junction.
ir::NodeId ControlCode::shown_while_taking(ir::TransitionId id) const {
    const NodeId source = plan_.machine().transitions[id.index].source;
    return plan_.node(source).kind == NodeKind::state ? source : plan_.node(source).parent;
}

void ControlCode::during_places() {
    for (DuringThread& during : during_) {
        const ir::Node& state = plan_.node(during.state);
        ProgramWriter program(generation_, unit_, during.thread, during.state);
        program.begin_place("start", "during action of " + generation_.place_text(state.origin));
        program.goes_on_from_here();
        program.write_statement(state.during, "step");
        program.write_jump("idle");
    }
}

}  // namespace robochart::cpp_emit
