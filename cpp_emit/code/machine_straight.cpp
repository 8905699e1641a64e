// Programs that never wait, as functions: a transition whose exits, action and entries are of this kind is one straight
// effect, in the order of semantics 3.4 (exits from the innermost out, action, entries). What follows a program is one
// statement: the next function, or the place where control goes on later.
#include <fmt/format.h>

#include <algorithm>

#include "cpp_emit/code/machine_writer.hpp"
#include "cpp_emit/code/suspension.hpp"

namespace robochart::cpp_emit {

using ir::NodeId;

bool MachineWriter::straight(NodeId id) {
    return plan_.straight(id) && !enters_child_first(id);
}

bool MachineWriter::has_place(const ir::Transition& transition) {
    return plan_.acts(transition) || acts_late(transition);
}

/// The during action of a state without children never waits, and no other runs beside it: it is run once the state is
/// entered, which is what a thread of its own would do.
bool MachineWriter::runs_on_entry(NodeId id) const {
    const ir::Node& node = plan_.node(id);
    const std::vector<NodeId> around = plan_.ancestors(id);
    return node.during && !node.composite() && faultless_cycle(generation_.options) &&
           !suspends(generation_, unit_, node.during) && std::none_of(around.begin(), around.end(), [&](NodeId outer) {
               return plan_.node(outer).during != nullptr;
           });
}

/// The lines of a program that never waits.
std::string MachineWriter::straight_program(const ir::StmtPtr& program, std::size_t depth) {
    Thread lines;
    ProgramWriter writer(generation_, unit_, lines, {});
    writer.begin("", "");
    writer.code() = CodeWriter(depth);
    writer.statement(program, "");
    return writer.code().text();
}

void MachineWriter::straight_function(const std::string& name, const diagnostics::ForeignText& comment) {
    out_.gap();
    out_.doc(comment);
    out_.open(signature("void " + name));
}

void MachineWriter::enter_function(NodeId id) {
    const ir::Node& node = plan_.node(id);
    straight_function(plan_.enter_label(id), "Enters " + generation_.place(node.origin));
    if (node.entry) out_.raw(straight_program(node.entry, 2));
    settle(id, out_, "return;");
    out_.close();
}

void MachineWriter::exit_function(NodeId id) {
    straight_function(plan_.exit_label(id), "Exit action of " + generation_.place(plan_.node(id).origin));
    out_.raw(straight_program(plan_.node(id).exit, 2));
    out_.close();
}

/// The exits of a composite state begin at the innermost active state.
void MachineWriter::leave_function(NodeId id) {
    straight_function("leave_" + plan_.label(id),
                      "Leaves " + generation_.place(plan_.node(id).origin) + ", from the innermost active state out.");
    const std::string own = plan_.node(id).exit ? call(plan_.exit_label(id)) + ";" : "";
    const bool outer_first = exits_first(id);
    if (outer_first) out_.line(own);
    out_.open("switch (f.at) {");
    for (const NodeId child : plan_.node(id).children) {
        const std::string exits = leave(child);
        if (exits.empty()) continue;
        for (const NodeId leaf : plan_.leaves(child))
            out_.line(fmt::format("case {}:", control_.at(plan_.label(leaf))));
        out_.line("    " + exits);
        out_.line("    break;");
    }
    out_.line("default: break;");
    out_.close();
    if (!own.empty() && !outer_first) out_.line(own);
    out_.close();
}

/// The statement that runs the exits of a state and of what is active in it; "" if there are none.
std::string MachineWriter::leave(NodeId id) const {
    if (plan_.exits_below(id)) return call("leave_" + plan_.label(id)) + ";";
    return plan_.node(id).exit ? call(plan_.exit_label(id)) + ";" : "";
}

void MachineWriter::take_function(ir::TransitionId id) {
    const ir::Transition& transition = plan_.machine().transitions[id.index];
    straight_function(plan_.take_label(id), "Action of " + generation_.place(transition.origin));
    if (!acts_first(transition)) out_.raw(straight_program(transition.action, 2));
    out_.line(arrive(transition.target));
    out_.close();
}

/// Initial nodes and junctions; true if control may have to stay there.
bool MachineWriter::pass_function(NodeId id) {
    straight_function("pass_" + plan_.label(id), "Chooses at " + generation_.place(plan_.node(id).origin));
    const bool stays = ways(id, out_, "return;");
    if (stays) out_.line(control_.go(plan_.label(id)));
    out_.close();
    return stays;
}

/// The statement that brings control into a node.
std::string MachineWriter::arrive(NodeId id) {
    if (plan_.needs_entry(id))
        return straight(id) ? call(plan_.enter_label(id)) + ";" : control_.go(plan_.enter_label(id));
    const bool rests = plan_.settles(id) || !plan_.straight(id);
    return rests ? control_.go(plan_.label(id)) : call("pass_" + plan_.label(id)) + ";";
}

/// The statement that goes on with a transition after the exits.
const std::string& MachineWriter::proceed(const ir::Transition& transition) {
    const ir::TransitionId id{static_cast<std::uint32_t>(&transition - plan_.machine().transitions.data())};
    std::string& text = proceeds_[id.index];
    if (!text.empty()) return text;
    const std::string& label = plan_.take_label(id);
    if (has_place(transition)) return text = control_.go(label);
    return text = transition.action ? call(label) + ";" : arrive(transition.target);
}

}  // namespace robochart::cpp_emit
