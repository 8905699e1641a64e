// SPDX-License-Identifier: Apache-2.0
// Emits RoboSim's `simulation N of M`: a RoboChart component that runs in cycles, as RoboTool defines it
// (docs/robosim.md).
#pragma once

#include "csp_emit/base/component.hpp"

namespace robochart::csp_emit {

/// Emits the CSPM module of the simulation. Its component must already have been emitted. With the events of M and its
/// `terminate` hidden,
///     N = prioritise(((M ; end -> SKIP) [| events of M, tock, end |] Assumptions) \ {events of M, end}, <{},{tock}>)
/// where the assumptions, written with tock as an ordinary event, are
///     A1: an input in a register happens at most once before the next read;
///     A2: each output happens at most once, only at the beginning of a cycle, and is written at once;
///     A3: first all registers are read; M acts only at the beginning of a cycle.
/// TLF decides whether N is schedulable. In TLF, M can also let time pass forever when it offers neither an output nor
/// time.
[[nodiscard]] ComponentEmission emit_simulation(const Project&, const ir::Simulation&, Emitted&);

}  // namespace robochart::csp_emit
