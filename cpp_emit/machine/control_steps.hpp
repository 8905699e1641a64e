// The steps of control as statements: a transition goes on, control comes to a node, a state is left. What follows a
// program is one statement: the next function, or the place where control goes on later.
#pragma once

#include "cpp_emit/expressions/cpp_expr.hpp"
#include "cpp_emit/machine/order_faults.hpp"

namespace robochart::cpp_emit {

/// One machine's; the code of functions, places and transitions is made of them.
class ControlSteps : private MachineCodePart {
public:
    ControlSteps(MachineContext& context, OrderFaults& faults)
        : MachineCodePart(context), faults_(faults), proceeds_(context.unit.machine->transitions.size()) {}

    /// Control gets into the node in one go (MachinePlan::straight), and no seeded fault forbids it.
    [[nodiscard]] bool straight(ir::NodeId);
    /// The transition goes on at a place of its own after its trigger: an exit or its action may wait.
    [[nodiscard]] bool has_place(const ir::Transition&);
    /// The lines of a program that never waits.
    [[nodiscard]] std::string straight_program(const ir::StmtPtr& program, std::size_t depth);
    /// The statement that runs the exits of a state and of what is active in it; "" if there are none.
    [[nodiscard]] std::string leave(ir::NodeId) const;
    /// The statement that brings control into a node.
    [[nodiscard]] std::string arrive(ir::NodeId);
    /// The statement that goes on with a transition after the exits.
    [[nodiscard]] const std::string& proceed(const ir::Transition&);
    /// Writes what follows a node's entry action; `end` leaves the code that it is in.
    void settle(ir::NodeId, CodeWriter&, const char* end);
    /// Control comes to an initial node, and if it asks for nothing on to where it leads.
    void begin(ir::NodeId initial, CodeWriter&);
    /// The state itself is entered, and with its first child each composite around it (semantics 3.3 a).
    void note_entry(ir::NodeId, CodeWriter&);
    /// The first transition whose guard holds is taken. True if there may be none: control stays (semantics 3.3, 3.4).
    bool ways(ir::NodeId, CodeWriter&, const char* end);
    /// The guard behind its preconditions, with the text of the incoming value; none if there is no guard.
    [[nodiscard]] CppExpr guard(const ir::Transition&, const std::string& incoming) const;
    /// The call of the trace hook.
    [[nodiscard]] std::string tell_taken(ir::TransitionId) const;
    /// With choices: the guard, and that it is the transition's turn.
    [[nodiscard]] CppExpr in_turn(const CppExpr& guard) const;
    /// The statement that starts a deadline.
    [[nodiscard]] std::string start_of(const Watch&) const;

private:
    void mark_entered(ir::NodeId, CodeWriter&);
    bool pick_way(ir::NodeId, CodeWriter&, const char* end);

    OrderFaults& faults_;
    std::vector<std::string> proceeds_;  ///< by transition: what follows its exits, once asked for
};

}  // namespace robochart::cpp_emit
