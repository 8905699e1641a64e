// SPDX-License-Identifier: Apache-2.0
// Finds what the registers of a RoboSim component's machines are connected to (docs/robosim.md, "Controllers and
// modules"). An input of a machine is connected to an input of the component, or to an event between machines. An
// output may be connected to several outputs of the component and events between machines.
#pragma once

#include <vector>

#include "cpp_emit/plan/component.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::cpp_emit {

/// Fills Part::events, Component::events and Component::buffers. `contexts` contains the controller of each part; it is
/// null for a single machine. Rejects connections that the generator cannot translate.
void wire_registers(Component&, const ir::Module*, const std::vector<const ir::Controller*>& contexts,
                    diagnostics::Diagnostics&);

}  // namespace robochart::cpp_emit
