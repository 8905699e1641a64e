// SPDX-License-Identifier: Apache-2.0
// Describes data that keep the carriers of the finite instantiation, and the reasons (docs/data.md, "Data that keep
// their carriers").
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics/source.hpp"

namespace robochart::ir {

/// The reason why values keep their carriers. Each reason is reported at the place of an expression (Keep::span),
/// except those marked "no place".
enum class KeepReason {
    type,           ///< classes cannot replace values of this type: functions, relations, matrices; no place
    other_place,    ///< they are shared with a place of another type, or a controller or platform initialises them; no
                    ///< place
    part,           ///< an assignment changes a part of them
    selector,       ///< they select the part of a variable that an assignment changes
    other_data,     ///< a condition also reads other data
    clock,          ///< an expression also reads a clock
    undefined,      ///< an expression may be undefined, and the machine stops there
    time,           ///< a wait or a deadline uses them as its duration
    probability,    ///< a probability depends on them
    contract,       ///< a precondition or postcondition of an operation reads them
    form,           ///< a condition is neither linear nor on windows near the start of a sequence
    conditions,     ///< there are too many conditions; no place
    classes,        ///< there are too many classes; no place
    numbers,        ///< the conditions read too many numbers of one value; no place
    extremes,       ///< some conditions read least, and others greatest, numbers of windows; no place
    points,         ///< for some combination of answers, no decimal numbers were found; no place
    computed,       ///< they are computed, and a condition reads them
    from_carriers,  ///< they are computed from data with carriers
    computed_from,  ///< data with carriers are computed from them
    observed        ///< a claim observes values of events; no place
};

/// True if this program was built with Z3, which finds classes for conditions that are not linear.
[[nodiscard]] bool has_solver();

/// The reason with its expression.
struct Keep {
    KeepReason why = KeepReason::type;
    diagnostics::Span span;  ///< unknown if the reason has no place
};

/// A flow class that keeps its carrier.
struct KeptData {
    std::vector<std::string> places;  ///< names of variables, events and parameters, ascending
    Keep keep;
};

}  // namespace robochart::ir
