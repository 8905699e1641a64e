// SPDX-License-Identifier: Apache-2.0
// Writes the steps of control as statements: a transition continues, control enters a node, a state is left. Each
// continuation is one statement, which calls the next function or sets the place where control resumes later.
#pragma once

#include "cpp_emit/expressions/cpp_expr.hpp"
#include "cpp_emit/machine/order_faults.hpp"

namespace robochart::cpp_emit {

/// The steps of one machine, from which the code of functions, places and transitions is built.
class ControlSteps : private MachineCodePart {
public:
    ControlSteps(MachineContext& context, OrderFaults& faults)
        : MachineCodePart(context), faults_(faults), proceeds_(context.unit.machine->transitions.size()) {}

    /// Returns whether control enters the node without waiting according to the plan, and no seeded fault forbids this.
    [[nodiscard]] bool enters_without_waiting(ir::NodeId);
    /// Returns whether the transition continues at a separate place after its trigger, because an exit or its action
    /// may wait.
    [[nodiscard]] bool has_place(const ir::Transition&);
    /// Returns the lines of a program that never waits.
    [[nodiscard]] std::string straight_program(const ir::StmtPtr& program, std::size_t depth);
    /// Returns the statement that runs the exits of a state and of its active inner states; "" if there are none.
    [[nodiscard]] std::string leave_statement(ir::NodeId) const;
    /// Returns the statement that moves control into a node.
    [[nodiscard]] std::string arrive_statement(ir::NodeId);
    /// Returns the statement that continues a transition after the exits.
    [[nodiscard]] const std::string& proceed_statement(const ir::Transition&);
    /// Writes the code after a node's entry action. `end` is the statement that leaves this code: "return;" or
    /// "break;".
    void write_settling(ir::NodeId, CodeWriter&, const char* end);
    /// Writes the code with which control enters an initial node and, if its transition has no condition, moves on to
    /// the target.
    void begin(ir::NodeId initial, CodeWriter&);
    /// Writes the code that marks a state as entered. Also marks each composite state that it is the first child of
    /// (semantics 3.3 a).
    void note_entry(ir::NodeId, CodeWriter&);
    /// Writes the code that takes the first transition whose guard holds. Returns true if there may be no such
    /// transition; control then stays (semantics 3.3, 3.4).
    bool write_ways(ir::NodeId, CodeWriter&, const char* end);
    void write_blocking(ir::NodeId, CodeWriter&, const char* end);
    /// Returns the guard preceded by its preconditions. `incoming` is the text of the incoming value. The result is
    /// empty if there is no guard.
    [[nodiscard]] CppExpr guard_condition(const ir::Transition&, const std::string& incoming) const;
    /// Returns the call of the trace hook.
    [[nodiscard]] std::string tell_taken(ir::TransitionId) const;
    /// Returns the guard. If the code has choices, it includes the condition that the platform has picked the
    /// transition.
    [[nodiscard]] CppExpr picked_guard(const CppExpr& guard) const;
    /// Returns the statement that starts a deadline.
    [[nodiscard]] std::string start_of(const Watch&) const;

private:
    void mark_entered(ir::NodeId, CodeWriter&);
    bool pick_way(ir::NodeId, CodeWriter&, const char* end);

    OrderFaults& faults_;
    std::vector<std::string> proceeds_;  ///< by transition: the code after its exits, computed on first use
};

}  // namespace robochart::cpp_emit
