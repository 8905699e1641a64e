// SPDX-License-Identifier: Apache-2.0
// Finds out where the events of a component's machines lead: to its boundary, to other machines, to buffers (semantics
// 3.9).
#pragma once

#include <vector>

#include "cpp_emit/plan/component.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::cpp_emit {

/// Collects the events that the units use and follows their connections. Fills Part::events, Component::events and
/// Component::buffers. `contexts` contains the controller of each part; it is null for a single machine. Rejects
/// connections that the generator cannot translate.
void wire_component(Component&, const ir::System&, const ir::Module*,
                    const std::vector<const ir::Controller*>& contexts, diagnostics::Diagnostics&);

}  // namespace robochart::cpp_emit
