// One machine as one sequential process: mutually recursive functions, one for each reachable configuration,
// whose parameters are the machine's constants, variables, clocks and counters (semantics 3.3 to 3.8, 3.10, 3.11).
//
// Who owns what. MachineTables (tables/machine_tables.hpp) holds everything that is known of the machine while its
// process is made, in one class for each kind of data, each of which knows those before it only: CallGraph the
// operations reached by calls and the constants, ParameterTable the cells, DefaultValues and ClockLimits small
// definitions, ActivationRecords which cell holds which variable, clock and counter of the machine and of each called
// operation, HiddenEvents the numbers of steps, ClockWatch the first reset of a watched clock, PointTable the reachable
// configurations, CallSharing where shared calls return to. The rules (rules/) own nothing: functions that read the
// tables and say which events and configurations follow, as data (Next, Branch). Processes follows the rules from the
// initial configuration and makes a function of every point. Once all are there, choose_memories takes large variables
// out of their parameters, DefinitionMeanings says what each means in the model, and ModuleDeclarations puts RoboTool's
// channels, sets and process variants around them. machine_module.cpp does these steps in turn.
#pragma once

#include "csp_emit/base/component.hpp"
#include "csp_emit/machine/tables/machine_context.hpp"

namespace robochart::csp_emit {

/// Emits the machine's CSPM module and adds to the provenance.
[[nodiscard]] ComponentEmission emit_machine(MachineContext, Emitted&);

}  // namespace robochart::csp_emit
