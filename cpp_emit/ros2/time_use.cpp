// SPDX-License-Identifier: Apache-2.0
// Statement: if the machines and operations of a RoboChart component read no clock, wait for no time and have no
// deadlines, then each state of the component in which time can pass is unchanged by tock. Reason: in the semantics,
// only clocks, waits and deadlines count tocks (semantics 3.10); in all other processes tock leads back to the same
// state. In RoboSim, each cycle is a step of the model, so a component in RoboSim always counts cycles.
#include "cpp_emit/ros2/time_use.hpp"

#include "semantics/ir/visit.hpp"

namespace robochart::cpp_emit::ros2 {

namespace {

class TimeUseFinder {
public:
    std::optional<TimeUse> find(const Component& component) {
        if (component.robosim) return TimeUse{"is written in RoboSim, where cycles are steps of the model", {}};
        for (const Unit& unit : component.units) visit_machine(*unit.machine);
        return std::move(found_);
    }

private:
    void visit_machine(const ir::Machine& machine) {
        ir::visit_running(machine, [&](const ir::Expr& expr, ir::ExprRole) {
            if (ir::mentions_clock(expr)) note("reads a clock", expr.span);
        });
        ir::visit_statements(machine, [&](const ir::Stmt& stmt) { visit_statement(stmt); });
        for (const ir::Transition& transition : machine.transitions)
            if (transition.deadline) note("has a deadline", transition.origin.span);
    }

    void visit_statement(const ir::Stmt& stmt) {
        switch (stmt.kind) {
            case ir::StmtKind::wait:
            case ir::StmtKind::wait_interval:
                return note("waits", stmt.origin.span);
            case ir::StmtKind::deadline:
                return note("has a deadline", stmt.origin.span);
            case ir::StmtKind::exec:
                return note("ends a cycle", stmt.origin.span);
            case ir::StmtKind::skip:
            case ir::StmtKind::sequence:
            case ir::StmtKind::if_then_else:
            case ir::StmtKind::assign:
            case ir::StmtKind::communicate:
            case ir::StmtKind::call:
            case ir::StmtKind::clock_reset:
            case ir::StmtKind::choose:
                return;
        }
    }

    void note(const char* text, diagnostics::Span span) {
        if (!found_) found_ = TimeUse{text, span};
    }

    std::optional<TimeUse> found_;
};

}  // namespace

std::optional<TimeUse> find_time_use(const Component& component) {
    return TimeUseFinder().find(component);
}

}  // namespace robochart::cpp_emit::ros2
