// SPDX-License-Identifier: Apache-2.0
#include "cpp_emit/machine/order_fault_code.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace robochart::cpp_emit {

using ir::NodeId;
using ir::NodeKind;

void OrderFaultCode::enter_child_first(ProgramWriter& program, NodeId id) {
    const NodeId child = faults_.sole_first_child(id);
    const std::string label = plan_.enter_label(id);
    if (plan_.notes_entry(id)) program.current_code().line(fmt::format("f.entering_{} = true;", plan_.label_of(id)));
    program.write_statement(plan_.node(child).entry, label);
    program.write_statement(plan_.node(id).entry, label);
    steps_.note_entry(child, program.current_code());
    program.write_jump(plan_.label_of(child));
}

void OrderFaultCode::exit_outer_before(ProgramWriter& program, NodeId id) {
    if (plan_.node(id).is_composite()) return;
    for (const NodeId outer : plan_.ancestors(id)) {
        if (!plan_.notes_leaving(outer) || !faults_.exits_first(outer)) continue;
        std::vector<std::string> left;
        for (const ir::TransitionId way : plan_.node(outer).outgoing)
            left.push_back(fmt::format("f.leaving == {}::{}", context_.leaving, plan_.take_label(way)));
        program.current_code().open(fmt::format("if ({}) {{", fmt::join(left, " || ")));
        program.write_statement(plan_.node(outer).exit, plan_.exit_label(id));
        program.current_code().close();
    }
}

void OrderFaultCode::act_before(ProgramWriter& program, NodeId id) {
    for (const ir::TransitionId way : plan_.node(id).outgoing) {
        const ir::Transition& transition = plan_.machine().transitions[way.index];
        if (!plan_.notes_leaving(id) || !faults_.acts_first(transition)) continue;
        program.current_code().open(
            fmt::format("if (f.leaving == {}::{}) {{", context_.leaving, plan_.take_label(way)));
        program.write_statement(transition.action, plan_.exit_label(id));
        program.current_code().close();
    }
}

void OrderFaultCode::act_late(ProgramWriter& program, const ir::Transition& transition, const std::string& label) {
    program.write_statement(plan_.node(transition.target).entry, label);
    program.write_statement(transition.action, label);
    steps_.note_entry(transition.target, program.current_code());
    program.write_jump(plan_.label_of(transition.target));
}

}  // namespace robochart::cpp_emit
