// SPDX-License-Identifier: Apache-2.0
// The kinds of faults of a run.
#pragma once

namespace robochart::refine {

/// The fault at the end of a run.
enum class ViolationKind {
    trace,           ///< the specification does not allow the last step's event
    refusal,         ///< the stable state reached offers too little
    divergence,      ///< the state reached can perform taus forever (loop), and the specification must not diverge
    deadlock,        ///< nothing is possible in the state reached
    nondeterminism,  ///< after the trace, `event` may be both accepted and refused
    no_return,       ///< none of the given events can ever happen after the state reached
    no_trace,        ///< has trace: the process cannot perform it; steps contain the longest possible prefix
};

}  // namespace robochart::refine
