// SPDX-License-Identifier: Apache-2.0
// RoboSim: where the registers of a component's machines lead (docs/robosim.md, "Controllers and modules"). An input is
// filled by an input of the whole or by an event between parts, and an output is written to outputs of the whole and to
// events between parts.
#pragma once

#include <vector>

#include "cpp_emit/plan/component.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::cpp_emit {

/// Fills Part::events, Component::events and Component::buffers. `contexts` contains the controller of each part, null
/// for a single machine. Rejects connections that the generator cannot translate.
void wire_registers(Component&, const ir::Module*, const std::vector<const ir::Controller*>& contexts,
                    diagnostics::Diagnostics&);

}  // namespace robochart::cpp_emit
