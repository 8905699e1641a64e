// SPDX-License-Identifier: Apache-2.0
// RoboSim: `simulation N of M`, a RoboChart component that runs in cycles, as RoboTool defines it (docs/robosim.md).
#pragma once

#include "csp_emit/base/component.hpp"

namespace robochart::csp_emit {

/// Emits the CSPM module of the simulation; its component has been emitted. With the events of M hidden and `terminate`
/// of M hidden,
///     N = prioritise(((M ; end -> SKIP) [| events of M, tock, end |] Assumptions) \ {events of M, end}, <{},{tock}>)
/// where the assumptions, written with tock as an ordinary event, are
///     A1: what a register holds may happen, once, until the next read;
///     A2: each output happens at most once, only at the beginning of a cycle, and is written at once;
///     A3: first all registers are read; M acts only at the beginning of a cycle.
/// TLF decides whether N is schedulable: M may also let time pass for ever when it offers neither an output nor time.
[[nodiscard]] ComponentEmission emit_simulation(const Project&, const ir::Simulation&, Emitted&);

}  // namespace robochart::csp_emit
