// SPDX-License-Identifier: Apache-2.0
// Writes the event API of a machine whose programs never wait. The reaction of a state to an event is one case. A
// nested switch selects the case or, from five states on, a dense table. Each case tries the transitions in the order
// of step(): inner states first, then textual order (semantics 3.4). Then it takes transitions that need no event until
// none is enabled.
#pragma once

#include "cpp_emit/machine/frame_code.hpp"

namespace robochart::cpp_emit {

/// Writes the event API. The threads must have been written before.
class DispatchCode : private MachineCodePart {
public:
    DispatchCode(MachineContext& context, ControlSteps& steps, const TimeCode& time, const FrameCode& frame)
        : MachineCodePart(context), steps_(steps), time_(time), frame_(frame) {}

    /// Returns whether every transition is one straight effect. Control then rests only in states (or in a junction
    /// without an enabled transition), and dispatch can be written as a switch.
    [[nodiscard]] bool is_direct() const;
    /// Writes dispatch, begin and pass.
    void dispatch_function();

private:
    [[nodiscard]] bool is_urgent(const ir::Transition&) const;
    [[nodiscard]] bool is_first(const ir::Transition&) const;
    [[nodiscard]] bool asks_for(const ir::Transition&, const EventPort& port) const;
    [[nodiscard]] bool goes_on(ir::NodeId rest) const;
    [[nodiscard]] bool look_after(ir::NodeId target) const;
    [[nodiscard]] std::string rest_result() const;
    void case_effect(const ir::Transition&, const EventPort* port, CodeWriter&);
    [[nodiscard]] std::string incoming_value(const ir::Transition&) const;
    [[nodiscard]] std::vector<const ir::Transition*> candidate_transitions(ir::NodeId leaf,
                                                                           const EventPort* port) const;
    [[nodiscard]] CppExpr case_condition(const ir::Transition&) const;
    void place_body(ir::NodeId place, CodeWriter&);
    [[nodiscard]] std::string case_body(ir::NodeId leaf, const EventPort* port, std::size_t depth);
    void begin_machine(CodeWriter&);
    void begin_function(const std::vector<const EventPort*>& columns);
    void pass_function_of_time(const std::vector<const EventPort*>& columns);
    [[nodiscard]] const EventPort* taken_for(ir::NodeId row, const EventPort& port,
                                             const std::vector<const EventPort*>& columns);
    void dispatch_switch(const std::vector<ir::NodeId>& rows, const std::vector<const EventPort*>& columns);
    void dispatch_table(const std::vector<ir::NodeId>& rows, const std::vector<const EventPort*>& columns);

    ControlSteps& steps_;
    const TimeCode& time_;
    const FrameCode& frame_;
};

}  // namespace robochart::cpp_emit
