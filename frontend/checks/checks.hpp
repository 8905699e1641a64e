// SPDX-License-Identifier: Apache-2.0
// The well-formedness rules of a resolved model, grouped by area (private to the front end).
#pragma once

#include "base/diagnostics/diagnostic.hpp"
#include "frontend/names/names.hpp"

namespace robochart::frontend {

using diagnostics::Diagnostics;
using diagnostics::Rule;

/// Checks all rules below.
void check(const Model& model, const Names& names, Diagnostics& out);

/// S2 to PT2: nodes, transitions and actions of a machine or operation.
void check_nodes(const Machine& machine, Diagnostics& out);
/// STM1 to M2, DT: members of interfaces, platforms, machines, operations, controllers and modules.
void check_component(const Context& context, Diagnostics& out);
/// DT: members of data types.
void check_type(const TypeDeclaration& type, Diagnostics& out);
/// C3, C4, C8, M2, STM8 to STM10: what components require and their context provides.
void check_provision(const Component& component, Diagnostics& out);
/// Cn2 to Cn11 without Cn10, C6, M3: connections of a controller or module.
void check_connections(const Component& component, Diagnostics& out);
/// Cn10: connection ends whose component does not have the event. A component that lacks a whole interface is reported
/// once, and not at all if its own uses of the events have been reported.
void check_ends(const Model& model, const Names& names, Diagnostics& out);
/// Cn5 to Cn9: directions of connections compared with what machines send and receive and controllers pass on.
void check_directions(const Component& component, Diagnostics& out);
/// TT1, TE1, TE4, TE5, CE2 and the untimed reading: clocks and deadlines.
void check_time(const Machine& machine, Diagnostics& out);
/// RC-N03: declarations, assertions and csp blocks that share a name.
void check_unique(const Model& model, const Names& names, Diagnostics& out);
/// RC-N04: imports of names that are declared nowhere.
void check_imports(const Model& model, const Names& names, Diagnostics& out);
/// RC-Q10 to RC-Q12: probabilistic assertions, and parts of assertion files that no verb evaluates. (The parser reports
/// RC-P33.)
void check_probabilistic(const File& file, Diagnostics& out);
/// RC-Q11, RC-Q12: the form of a `prob property`.
void check_property(const Expr& property, Diagnostics& out);

}  // namespace robochart::frontend
