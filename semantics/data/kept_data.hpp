// SPDX-License-Identifier: Apache-2.0
// Describes which data keep the carriers of the finite instantiation, and why (docs/data.md, "Data that keep their
// carriers").
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics/source.hpp"

namespace robochart::ir {

/// Why values keep their carriers. A reason is reported at an expression (Keep::span), unless its comment says "no
/// place".
enum class KeepReason {
    type,           ///< classes cannot replace values of this type: functions, relations, matrices; no place
    other_place,    ///< the values also flow to a place of another type, or are initialised by a controller or
                    ///< platform; no place
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
    numbers,        ///< the conditions read too many of the numbers in one value; no place
    extremes,       ///< some conditions read the least number of a window, and others the greatest; no place
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

/// A flow class that keeps its carrier, and the reason.
struct KeptData {
    std::vector<std::string> places;  ///< names of variables, events and parameters, ascending
    Keep keep;
};

}  // namespace robochart::ir
