// Control and during threads: entry, exit and transition actions in the order of semantics 3.4:
// exits innermost first, transition action, target's entry, initial transition and first child, `entered`.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cpp_emit/expression.hpp"
#include "cpp_emit/machine_writer.hpp"
#include "cpp_emit/seeded.hpp"
#include "cpp_emit/types.hpp"
#include "cpp_emit/walk.hpp"

namespace robochart::cpp_emit {

using ir::NodeId;
using ir::NodeKind;

void MachineWriter::control_places() {
    const ir::Machine& machine = plan_.machine();
    for (std::uint32_t index = 0; index < machine.nodes.size(); ++index) {
        const NodeId id{index};
        const ir::Node& node = machine.nodes[index];
        if (node.kind == NodeKind::initial || node.kind == NodeKind::junction) choose_place(id);
        if (node.kind == NodeKind::probabilistic) draw_place(id);
        if (plan_.target(id) != plan_.label(id)) enter_place(id);
        if (plan_.shared_exit(id)) exit_place(id);
        for (const ir::TransitionId transition : node.outgoing)
            if (plan_.acts(machine.transitions[transition.index])) take_place(transition);
    }
}

/// Initial nodes and junctions: the first transition whose guard holds; none: control stays (semantics 3.3, 3.4).
void MachineWriter::choose_place(NodeId id) {
    ProgramWriter program(generation_, unit_, control_, plan_.node(id).parent);
    program.begin(plan_.label(id), generation_.place(plan_.node(id).origin));
    bool stays = true;
    const auto& ways = plan_.node(id).outgoing;
    for (const std::size_t way : order(generation_, ways.size(), Fault::junction_reversed)) {
        const ir::Transition& transition = plan_.machine().transitions[ways[way].index];
        program.code().comment(generation_.place(transition.origin));
        const std::string condition = guard(transition, "");
        if (!condition.empty()) program.code().open(fmt::format("if ({}) {{", condition));
        for (const ir::ClockId clock : transition.resets) program.line(clock_reset(generation_, unit_, clock));
        program.line(tell_taken(ways[way]));
        program.jump(after_exit(transition));
        if (condition.empty()) {
            stays = false;
            break;
        }
        program.code().close();
    }
    if (stays) program.code().line("return moved;");
}

/// Probabilistic junctions: a free choice in the semantics, drawn by the platform.
void MachineWriter::draw_place(NodeId id) {
    ProgramWriter program(generation_, unit_, control_, plan_.node(id).parent);
    program.begin(plan_.label(id), generation_.place(plan_.node(id).origin));
    const auto& ways = plan_.node(id).outgoing;
    if (ways.empty()) return program.code().line("return moved;");
    const ExpressionWriter expressions(generation_, unit_, "f");
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
        const std::size_t taken = generation_.mutation.hits(Fault::way_exchanged) ? (way + 1) % ways.size() : way;
        const ir::Transition& transition = plan_.machine().transitions[ways[taken].index];
        program.code().comment(generation_.place(transition.origin));
        program.code().line(way + 1 == ways.size() ? "default:" : fmt::format("case {}:", way));
        for (const ir::ClockId clock : transition.resets) program.line(clock_reset(generation_, unit_, clock));
        program.line(tell_taken(ways[way]));
        program.jump(after_exit(transition));
    }
    program.code().close();
    program.code().close();
    program.code().line("break;");
}

void MachineWriter::enter_place(NodeId id) {
    const bool state = plan_.node(id).kind == NodeKind::state;
    ProgramWriter program(generation_, unit_, control_, state ? id : plan_.node(id).parent);
    const ir::Node& node = plan_.node(id);
    const std::string label = plan_.enter_label(id);
    program.begin(label, "enters " + generation_.place(node.origin));
    if (enters_child_first(id)) return enter_child_first(program, id);
    if (node.entry && !generation_.mutation.hits(Fault::entry_dropped)) program.statement(node.entry, label);
    if (!node.composite()) {
        note_entry(id);
        return program.jump(plan_.label(id));
    }
    if (plan_.notes_entry(id)) program.code().line(fmt::format("f.entering_{} = true;", plan_.label(id)));
    if (generation_.mutation.hits(Fault::composite_resumed)) {
        histories_.push_back(id);
        const std::string history = fmt::format("f.history_{}", plan_.label(id));
        program.code().open(fmt::format("if ({} != {}{{}}) {{", history, unit_.points));
        program.code().line(fmt::format("f.at = {};", history));
        program.code().line("break;");
        program.code().close();
    }
    program.jump(plan_.label(node.initial));
}

/// Fault::entry_inner_first at a composite whose initial node leads to a child without more ado.
bool MachineWriter::enters_child_first(NodeId id) {
    return plan_.node(id).entry != nullptr && sole_first_child(id).valid() &&
           generation_.mutation.hits(Fault::entry_inner_first);
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
    note_entry(child);
    program.jump(plan_.label(child));
}

/// The state itself is entered, and with its first child each composite around it (semantics 3.3 a).
void MachineWriter::note_entry(NodeId id) {
    CodeWriter& code = control_.places.back().code;
    if (plan_.notes_entry(id)) mark_entered(id);
    for (const NodeId outer : plan_.ancestors(id)) {
        if (!plan_.notes_entry(outer)) continue;
        code.open(fmt::format("if (f.entering_{}) {{", plan_.label(outer)));
        code.line(fmt::format("f.entering_{} = false;", plan_.label(outer)));
        mark_entered(outer);
        code.close();
    }
}

void MachineWriter::mark_entered(NodeId id) {
    CodeWriter& code = control_.places.back().code;
    const ir::ClockId clock = entry_clock(plan_.machine(), id);
    if (clock.valid()) {
        const std::string line = clock_reset(generation_, unit_, clock);
        if (!line.empty()) code.line(line);
    }
    for (const DuringThread& during : during_)
        if (during.state == id && !generation_.mutation.hits(Fault::during_never)) code.line(during.thread.go("start"));
    for (const Watch& watch : watches_) {
        if (watch.state != id) continue;
        const std::string line = start_of(watch);
        if (!line.empty()) code.line(line);
    }
}

/// A shared exit place: the state's exit action, then the transition that leaves it or the exit around it.
void MachineWriter::exit_place(NodeId id) {
    ProgramWriter program(generation_, unit_, control_, id);
    const ir::Node& node = plan_.node(id);
    const std::string label = plan_.exit_label(id);
    program.begin(label, "leaves " + generation_.place(node.origin));
    exit_outer_before(program, id);
    act_before(program, id);
    if (node.exit && !exits_first(id) && !generation_.mutation.hits(Fault::exit_dropped))
        program.statement(node.exit, label);
    for (const ir::TransitionId transition : node.outgoing) {
        program.code().open(fmt::format("if (f.leaving == {}::{}) {{", leaving_, plan_.take_label(transition)));
        program.code().line(fmt::format("f.leaving = {}::nothing;", leaving_));
        program.jump(after_exit(plan_.machine().transitions[transition.index]));
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
        if (!exits_first(outer)) continue;
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
        if (!acts_first(transition)) continue;
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

/// Exit action of the source, unless it has a place of its own, and the transition's action.
void MachineWriter::take_place(ir::TransitionId id) {
    ProgramWriter program(generation_, unit_, control_, shown_while_taking(id));
    const ir::Transition& transition = plan_.machine().transitions[id.index];
    const std::string label = plan_.take_label(id);
    program.begin(label, "takes " + generation_.place(transition.origin));
    const ir::Node& source = plan_.node(transition.source);
    const bool exits = source.exit && !plan_.shared_exit(transition.source);
    const bool first = acts_first(transition);
    if (first && exits) program.statement(transition.action, label);
    if (exits && !generation_.mutation.hits(Fault::exit_dropped)) program.statement(source.exit, label);
    if (acts_late(transition)) return act_late(program, transition, label);
    if (transition.action && !first && !generation_.mutation.hits(Fault::action_dropped))
        program.statement(transition.action, label);
    program.jump(plan_.target(target_of(transition)));
}

void MachineWriter::act_late(ProgramWriter& program, const ir::Transition& transition, const std::string& label) {
    program.statement(plan_.node(transition.target).entry, label);
    program.statement(transition.action, label);
    note_entry(transition.target);
    program.jump(plan_.label(transition.target));
}

std::string MachineWriter::after_exit(const ir::Transition& transition) {
    const ir::TransitionId id{static_cast<std::uint32_t>(&transition - plan_.machine().transitions.data())};
    return plan_.acts(transition) ? plan_.take_label(id) : plan_.target(target_of(transition));
}

/// Fault::during_again: in the next cycle from the start.
void MachineWriter::run_again(ProgramWriter& program, Thread& thread) {
    const std::string label = thread.labels->numbered("again");
    thread.waits = true;
    program.code().line(thread.wait + " = 1;");
    program.jump(label);
    program.begin(label, "again");
    program.code().line(fmt::format("if ({} > 0) return moved;", thread.wait));
    program.jump("start");
    program.begin(thread.labels->numbered("never"), "never");
}

void MachineWriter::during_places() {
    for (DuringThread& during : during_) {
        const ir::Node& state = plan_.node(during.state);
        ProgramWriter program(generation_, unit_, during.thread, during.state);
        program.begin("start", "during action of " + generation_.place(state.origin));
        program.statement(state.during, "step");
        if (generation_.mutation.hits(Fault::during_again)) run_again(program, during.thread);
        program.jump("idle");
    }
}

}  // namespace robochart::cpp_emit
