// Gathers branches of a choice that differ in their events only: writes by others that nothing will read any more, the
// passing of time where nothing counts it. `a?x -> P [] b?x -> P [] tock -> P` becomes `[] e__ : {| a, b, tock |} @ e__
// -> P`, the same process in less text.
#pragma once

#include <string>
#include <vector>

#include "csp_emit/base/names.hpp"
#include "csp_emit/passes/liveness.hpp"

namespace robochart::csp_emit {

/// A set of events that has a name of its own, so that it is written and evaluated once.
struct NamedSet {
    std::string name;
    cspm::ExprPtr events;
};

/// Rewrites the bodies. `known`: sets that have names already; those that come to need one are put behind them.
void gather_alike_branches(std::vector<Function>& functions, NameManager& names, std::vector<NamedSet>& known);

}  // namespace robochart::csp_emit
