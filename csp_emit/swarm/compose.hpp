// SPDX-License-Identifier: Apache-2.0
// Writes a swarm as CSP: the generated processes of the robots, and processes for their world.
//
// Every robot is the component's compressed process, with its events renamed to events that carry its number. On a
// grid, each robot has a body (its heading, and whether it drives, stands or turns), and each pair of robots has a
// process that stores only the offset between the two. So states that differ only by a translation are the same state.
// After each tock the bodies move in the order of their numbers. A body that drives moves by one cell along its
// heading. Between these moves the robots do not interact with their world, so the order does not matter. A turn ends
// after the next tock. Within a time unit, robots act before time passes (maximal progress). Without a grid, any robots
// may be near each other at any time.
//
// Sensing is an event that carries the set of the robots in range. Each pair of robots accepts or refuses it. The
// observations that decide conditions work in the same way.
#pragma once

#include "base/diagnostics/diagnostic.hpp"
#include "csp_emit/base/emission.hpp"
#include "csp_emit/swarm/swarm.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::csp_emit {

/// Replaces the assertions of the emission by the claims of the swarm. The script then consists of the definitions, the
/// swarm's module and its assertions. Reports elements that the component does not have, and values that its types do
/// not have.
void make_swarm(Emission& emission, const Swarm& swarm, Time time, const ir::System& system,
                const ir::Instantiation& instantiation, diagnostics::SourceManager& sources,
                diagnostics::Diagnostics& diagnostics);

}  // namespace robochart::csp_emit
