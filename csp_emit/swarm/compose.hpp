// A swarm as CSP: the robots' generated processes, and the world that they are in.
//
// Every robot is the component's compressed process with its events renamed to events of its own number. With a grid,
// each robot has a body (its heading, and whether it drives, stands or turns), and each pair of robots a process that
// knows nothing but the offset between the two: so states that differ by a translation alone are one state. After each
// tock the bodies move, in the order of their numbers, those that drive by one cell along their heading; nothing else
// that robots do with their world happens in between, so the order is of no account. A turn is done when the next tock
// has passed. Within a time unit, what robots do is done before time passes (maximal progress). Without a grid, who is
// near is open at any time.
//
// Sensing is an event with the set of those that are near, to which each pair of robots agrees or does not; so is the
// observation that a condition is judged by.
#pragma once

#include "csp_emit/base/emission.hpp"
#include "csp_emit/swarm/swarm.hpp"
#include "diagnostics/diagnostic.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::csp_emit {

/// Replaces what the emission asserts by what the swarm claims: its script is the definitions, the swarm's module and
/// assertions. What the component does not have, or its values cannot say, is reported.
void make_swarm(Emission& emission, const Swarm& swarm, Time time, const ir::System& system,
                const ir::Instantiation& instantiation, diagnostics::SourceManager& sources,
                diagnostics::Diagnostics& diagnostics);

}  // namespace robochart::csp_emit
