// Where the events of a component's machines lead: to its boundary, to other machines, into buffers (semantics 3.9).
#pragma once

#include <vector>

#include "cpp_emit/plan/component.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::cpp_emit {

/// Collects the events that the units use and follows their connections: fills Part::events, Component::events and
/// Component::buffers. `contexts` has the controller of each part, null for a machine alone. Refuses what has no
/// sensible code.
void wire(Component&, const ir::System&, const ir::Module*, const std::vector<const ir::Controller*>& contexts,
          diagnostics::Diagnostics&);

}  // namespace robochart::cpp_emit
