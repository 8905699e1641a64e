// SPDX-License-Identifier: Apache-2.0
// Defines the kinds of violations that a run can show.
#pragma once

namespace robochart::refine {

/// The kind of violation at the end of a run.
enum class ViolationKind {
    trace,           ///< the specification does not allow the last step's event
    refusal,         ///< the stable state at the end offers too little
    divergence,      ///< the last state can perform taus forever (loop), and the specification must not diverge
    deadlock,        ///< no transition is possible in the last state
    nondeterminism,  ///< after the trace, `event` may be both accepted and refused
    no_return,       ///< none of the given events can ever happen after the last state
    no_trace,        ///< has trace: the process cannot perform the trace; the steps contain its longest possible prefix
};

}  // namespace robochart::refine
