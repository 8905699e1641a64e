// SPDX-License-Identifier: Apache-2.0
// RoboSim: declares the registers of a component as channels of its CSPM module, with RoboTool's names. Defines the
// process of its cycles (docs/robosim.md).
#pragma once

#include <string>
#include <vector>

#include "csp_emit/base/component.hpp"

namespace robochart::csp_emit {

/// An input or output of a component that runs in cycles.
struct Register {
    std::string name;               ///< its name in the model
    std::vector<ir::TypeId> types;  ///< for an input event: boolean, then the type of its value
    MeaningKind kind = MeaningKind::output;
    ir::Origin origin;
    bool event = false;  ///< an event
};
struct Registers {
    std::vector<Register> inputs, outputs;
};

[[nodiscard]] Register input_event(const std::string& name, ir::TypeId type, const ir::Origin&);
[[nodiscard]] Register input_variable(const std::string& name, ir::TypeId type, const ir::Origin&);
[[nodiscard]] Register output_event(const ir::Event&);
[[nodiscard]] Register output_variable(const std::string& name, ir::TypeId type, const ir::Origin&);
[[nodiscard]] Register output_call(const ir::OperationSignature&);
/// Returns the registers of the contexts of a machine or operation.
[[nodiscard]] Registers registers_of(const ir::Machine&);
/// Adds the register unless the list contains one with this name.
void add_register(std::vector<Register>&, Register);

/// Returns `registerRead.i_x` or `registerWrite.o_x` or, with a part, `part::registerRead.part::i_x`.
[[nodiscard]] cspm::ExprPtr register_read(const std::string& name, const std::string& part = "");
[[nodiscard]] cspm::ExprPtr register_write(const std::string& name, const std::string& part = "");

/// Declares the types RegisterDataInput and RegisterDataOutput, the sets RegisterInputs and RegisterOutputs, and the
/// channels. Without inputs (or outputs), a component has no declarations for them. `also_named` are outputs that only
/// the type contains.
void declare_registers(const Project&, const std::string& owner, const Registers&,
                       const std::vector<Register>& also_named, Provenance&, std::vector<cspm::DeclPtr>&);
/// Returns the channels of the registers with their constructors, as in ComponentEmission::visible: "registerRead.i_x".
[[nodiscard]] std::vector<std::string> visible_registers(const Registers&);
/// Returns the events that have this name in ComponentEmission::visible of the component with this path.
[[nodiscard]] cspm::ExprPtr visible_event(const std::string& path, const std::string& visible);

/// Returns `(events of each output -> STOP, interleaved) /\ endexec -> SKIP`: each output happens at most once, until
/// the execution ends.
[[nodiscard]] cspm::ExprPtr writes_of_cycle(const std::vector<std::vector<cspm::ExprPtr>>& events_of_outputs);
/// Returns the cycle of a component, a process that repeats
///     reads ; execution ; (terminate -> SKIP [] tock -> wait(c - 1) ; the next cycle)
/// Time passes only at the end of a cycle. There, a component that has reached its final state may terminate.
[[nodiscard]] cspm::DeclPtr cycle_definition(const std::string& name, const std::string& length,
                                             const cspm::ExprPtr& reads, const cspm::ExprPtr& execution);

}  // namespace robochart::csp_emit
