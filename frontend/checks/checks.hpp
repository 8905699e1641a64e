// SPDX-License-Identifier: Apache-2.0
// Checks the well-formedness rules of a resolved model, grouped by area (private to the front end).
#pragma once

#include <optional>

#include "base/diagnostics/diagnostic.hpp"
#include "frontend/names/names.hpp"

namespace robochart::frontend {

using diagnostics::Diagnostics;
using diagnostics::Rule;

/// Checks all rules below.
void check(const Model& model, const Names& names, Diagnostics& out);

/// Checks rules S2 to PT2: nodes, transitions and actions of a machine or operation.
void check_nodes(const Machine& machine, Diagnostics& out);
/// Checks rules STM1 to M2 and DT: members of interfaces, platforms, machines, operations, controllers and modules.
void check_component(const Context& context, Diagnostics& out);
/// Checks rules DT: members of data types.
void check_type(const TypeDeclaration& type, Diagnostics& out);
/// Checks rules C3, C4, C8, M2 and STM8 to STM10: the context of a component provides what the component requires.
void check_provision(const Component& component, Diagnostics& out);
/// Checks rules Cn2 to Cn11 (without Cn10), C6 and M3: connections of a controller or module.
void check_connections(const Component& component, Diagnostics& out);
/// Checks rule Cn10: each end of a connection is an event that the component has. If a whole interface is missing,
/// reports the component once, and not at all if the uses of the events inside it have already been reported.
void check_ends(const Model& model, const Names& names, Diagnostics& out);
/// Checks rules Cn5 to Cn9: the direction of a connection must fit the events that machines send and receive, and the
/// connections inside controllers.
void check_directions(const Component& component, Diagnostics& out);
/// Checks rules TT1, TE1, TE4, TE5 and CE2, about clocks and deadlines, and RC-U01, about untimed checks.
void check_time(const Machine& machine, Diagnostics& out);
/// Checks rules RC-Y01, RC-Y02, RC-Y07, RC-Y09 and RC-Y12: contexts, cycles and callers of a RoboSim component.
void check_robosim(const Context& context, Diagnostics& out);
/// Checks rules RC-Y01, RC-Y02, RC-Y07 and RC-Y10: a simulation whose subject is resolved.
void check_simulation(const Simulation& simulation, Diagnostics& out);
/// Checks rules RC-Y07 and RC-Y15: the lengths that a claim of RoboSim gives to cycles are positive numbers, and the
/// components that it compares have a common register.
void check_claim(const Assertion& assertion, Diagnostics& out);
/// Returns the value of an expression over literals and constants with values. Follows at most `constants` references,
/// because the definitions of constants may form a cycle.
[[nodiscard]] std::optional<double> constant_value(const Expr& expr, int constants = 20);
/// Checks rule RC-N03: declarations, assertions and csp blocks have different names.
void check_unique(const Model& model, const Names& names, Diagnostics& out);
/// Checks rule RC-N04: imported names are declared.
void check_imports(const Model& model, const Names& names, Diagnostics& out);
/// Checks rules RC-Q10 to RC-Q12: probabilistic assertions, and parts of assertion files that no verb evaluates. (The
/// parser reports RC-P33.)
void check_probabilistic(const File& file, Diagnostics& out);
/// Checks rules RC-Q11 and RC-Q12: the form of a `prob property`.
void check_property(const Expr& property, Diagnostics& out);

}  // namespace robochart::frontend
