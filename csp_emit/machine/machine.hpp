// SPDX-License-Identifier: Apache-2.0
// Emits a machine as one sequential process (semantics 3.3 to 3.8, 3.10, 3.11). The process consists of mutually
// recursive functions, one for each reachable configuration. Their parameters are the machine's constants, variables,
// clocks and counters.
//
// During the emission, MachineTables (tables/machine_tables.hpp) owns all data about the machine, in one class for each
// kind of data. A class depends only on the classes that this list names before it. CallGraph contains the called
// operations and the constants. ParameterTable contains the cells. DefaultValues and ClockLimits contain small
// definitions. ActivationRecords contains the cell of every variable, clock and counter of the machine and of each
// called operation. HiddenEvents contains the numbers of steps. ClockWatch records the first reset of a watched clock.
// PointTable contains the reachable configurations. CallSharing contains the return points of shared calls. The rules
// (rules/) are functions that own no data: they read the tables and return the next events and configurations as data
// (Next, Branch). Processes applies the rules from the initial configuration and makes a function for every point. When
// all points are known, choose_memories removes large variables from their parameters, DefinitionMeanings records what
// each point means in the model, and ModuleDeclarations adds RoboTool's channels, sets and process variants.
// machine_module.cpp performs these steps in turn.
#pragma once

#include "csp_emit/base/component.hpp"
#include "csp_emit/machine/tables/machine_context.hpp"

namespace robochart::csp_emit {

/// Emits the machine's CSPM module and records meanings in the provenance.
[[nodiscard]] ComponentEmission emit_machine(MachineContext, Emitted&);

}  // namespace robochart::csp_emit
