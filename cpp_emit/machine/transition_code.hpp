// SPDX-License-Identifier: Apache-2.0
// Writes the choice of transitions: active states from the inside out, and in each state in textual order. Triggers are
// examined before they are consumed, and guards see the incoming value (semantics 3.4 "Guards").
#pragma once

#include "cpp_emit/machine/control_steps.hpp"

namespace robochart::cpp_emit {

/// Writes the functions that start a transition.
class TransitionCode : private MachineCodePart {
public:
    TransitionCode(MachineContext& context, OrderFaults& faults, ControlSteps& steps)
        : MachineCodePart(context), faults_(faults), steps_(steps) {}

    /// Writes a function for each state that can be left, and the function that calls them from the inside out. If an
    /// order of events is declared, also writes a function `first`.
    void transition_functions();
    /// Returns whether the machine has a function `first`.
    [[nodiscard]] bool has_first_events() const { return !first_events().empty(); }
    /// Returns whether the transition is tried before transitions on other events and transitions without an event.
    [[nodiscard]] bool comes_first(const ir::Transition&) const;

private:
    using Calls = std::vector<std::string> (TransitionCode::*)(ir::NodeId) const;
    void choosing_function(const std::string& name, const char* comment, Calls calls_of);
    [[nodiscard]] const std::vector<ir::EventId>& first_events() const;
    void first_functions();
    [[nodiscard]] bool has_first(ir::NodeId state, std::size_t number) const;
    [[nodiscard]] bool has_others(ir::NodeId state) const;
    [[nodiscard]] std::vector<std::string> first_calls(ir::NodeId leaf) const;
    void pick_function(const std::string& name, const std::string& attempt);
    [[nodiscard]] std::vector<std::string> attempt_calls(ir::NodeId leaf) const;
    void from_function(ir::NodeId);
    bool try_transition(const ir::Transition&);
    void reset_too_soon(const ir::Transition&);
    bool try_trigger(const ir::Transition&, ir::TransitionId);
    void begin_transition(const ir::Transition&, ir::TransitionId);
    void write_begin_of_cycle();
    void next_function();
    [[nodiscard]] bool stores_late(const ir::Transition&) const;
    void write_stores(const ir::Transition&);
    void end_cycle(const ir::Transition&, ir::TransitionId);
    void cut_durings(ir::NodeId source);
    void write_departure(ir::NodeId source, ir::TransitionId);

    OrderFaults& faults_;
    ControlSteps& steps_;
};

}  // namespace robochart::cpp_emit
