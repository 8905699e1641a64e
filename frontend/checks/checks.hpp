// The well-formedness rules of a resolved model, by area (private to the front end).
#pragma once

#include "diagnostics/diagnostic.hpp"
#include "frontend/names/names.hpp"

namespace robochart::frontend {

using diagnostics::Diagnostics;
using diagnostics::Rule;

/// Every rule below.
void check(const Model& model, const Names& names, Diagnostics& out);

/// Nodes, transitions, actions of a machine or operation: S2 to PT2.
void check_nodes(const Machine& machine, Diagnostics& out);
/// Contents of interfaces, platforms, machines, operations, controllers, modules: STM1 to M2, DT.
void check_component(const Context& context, Diagnostics& out);
/// DT.
void check_type(const TypeDeclaration& type, Diagnostics& out);
/// What parts require against what their surroundings provide: C3, C4, C8, M2, STM8 to STM10.
void check_provision(const Component& component, Diagnostics& out);
/// Connections of a controller or module: Cn2 to Cn11 without Cn10, C6, M3.
void check_connections(const Component& component, Diagnostics& out);
/// Ends of connections whose component has no such event: Cn10. A component that lacks a whole interface is reported
/// once, and not at all if its own uses of the events have been.
void check_ends(const Model& model, const Names& names, Diagnostics& out);
/// Directions of connections against what machines send and receive, and controllers pass on: Cn5 to Cn9.
void check_directions(const Component& component, Diagnostics& out);
/// Clocks and deadlines: TT1, TE1, TE4, TE5, CE2 and the untimed reading.
void check_time(const Machine& machine, Diagnostics& out);
/// Declarations, assertions and csp blocks of one name: RC-N03.
void check_unique(const Model& model, const Names& names, Diagnostics& out);
/// Imports of what nobody declares: RC-N04.
void check_imports(const Model& model, const Names& names, Diagnostics& out);
/// Probabilistic assertions, and parts of assertion files that nothing reads: RC-Q10 to RC-Q12. (RC-P33 is the
/// reader's.)
void check_probabilistic(const File& file, Diagnostics& out);
/// What `prob property` may claim: RC-Q11, RC-Q12.
void check_property(const Expr& property, Diagnostics& out);

}  // namespace robochart::frontend
