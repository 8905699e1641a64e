// SPDX-License-Identifier: Apache-2.0
#include "cpp_emit/machine/straight_code.hpp"

#include <fmt/format.h>

namespace robochart::cpp_emit {

using ir::NodeId;
using ir::NodeKind;

void StraightCode::straight_function(const std::string& name, const diagnostics::ForeignText& comment) {
    out_.open_declaration(comment, function_head("void " + name));
}

void StraightCode::enter_function(NodeId id) {
    const ir::Node& node = plan_.node(id);
    straight_function(plan_.enter_label(id), "Enters " + generation_.place_text(node.origin));
    if (node.entry) out_.write_raw(steps_.straight_program(node.entry, 2));
    steps_.write_settling(id, out_, "return;");
    out_.close();
}

void StraightCode::exit_function(NodeId id) {
    straight_function(plan_.exit_label(id), "Exit action of " + generation_.place_text(plan_.node(id).origin));
    out_.write_raw(steps_.straight_program(plan_.node(id).exit, 2));
    out_.close();
}

/// Writes the exits of a composite state. They begin at the innermost active state.
void StraightCode::leave_function(NodeId id) {
    straight_function("leave_" + plan_.label_of(id), "Leaves " + generation_.place_text(plan_.node(id).origin) +
                                                         ", from the innermost active state out.");
    const std::string own = plan_.node(id).exit ? function_call(plan_.exit_label(id)) + ";" : "";
    const bool outer_first = faults_.exits_first(id);
    if (outer_first) out_.line(own);
    out_.open("switch (f.at) {");
    for (const NodeId child : plan_.node(id).children) {
        const std::string exits = steps_.leave_statement(child);
        if (exits.empty()) continue;
        for (const NodeId leaf : plan_.resting_leaves(child))
            out_.line(fmt::format("case {}:", control_.qualified_label(plan_.label_of(leaf))));
        out_.line("    " + exits);
        out_.line("    break;");
    }
    out_.line("default: break;");
    out_.close();
    if (!own.empty() && !outer_first) out_.line(own);
    out_.close();
}

void StraightCode::take_function(ir::TransitionId id) {
    const ir::Transition& transition = plan_.machine().transitions[id.index];
    straight_function(plan_.take_label(id), "Action of " + generation_.place_text(transition.origin));
    if (!faults_.acts_first(transition)) out_.write_raw(steps_.straight_program(transition.action, 2));
    out_.line(steps_.arrive_statement(transition.target));
    out_.close();
}

/// Writes the function for an initial node or junction. Returns true if control may have to stay there.
bool StraightCode::pass_function(NodeId id) {
    straight_function("pass_" + plan_.label_of(id), "Chooses at " + generation_.place_text(plan_.node(id).origin));
    const bool stays = steps_.write_ways(id, out_, "return;");
    if (stays) out_.line(control_.go_statement(plan_.label_of(id)));
    out_.close();
    return stays;
}

}  // namespace robochart::cpp_emit
