// SPDX-License-Identifier: Apache-2.0
// Merges branches of a choice that differ only in their events, for example external writes whose values are never
// read, or the passing of time if no parameter counts it. `a?x -> P [] b?x -> P [] tock -> P` becomes `[] e__ : {| a,
// b, tock |} @ e__ -> P`, which is the same process in less text.
#pragma once

#include <string>
#include <vector>

#include "csp_emit/base/names.hpp"
#include "csp_emit/passes/liveness.hpp"

namespace robochart::csp_emit {

/// A named set of events, which is written and evaluated once.
struct NamedSet {
    std::string name;
    cspm::ExprPtr events;
};

/// Rewrites the bodies. `known` contains the sets that already have names. The function appends each set that it names.
void gather_alike_branches(std::vector<Function>& functions, NameManager& names, std::vector<NamedSet>& known);

}  // namespace robochart::csp_emit
