// What can be wrong with a run.
#pragma once

namespace robochart::refine {

/// What is wrong at the end of a run.
enum class ViolationKind {
    trace,           ///< the last step's event is not allowed by the specification
    refusal,         ///< the reached stable state offers too little
    divergence,      ///< the reached state can do taus for ever (loop), where the specification may not
    deadlock,        ///< nothing is possible in the reached state
    nondeterminism,  ///< after the trace, `event` may be both accepted and refused
    no_return,       ///< from the reached state on none of the events that were asked for can happen
    no_trace,        ///< has trace: the process cannot perform it; steps hold the longest possible prefix
};

}  // namespace robochart::refine
