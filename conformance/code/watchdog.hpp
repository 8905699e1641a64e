// SPDX-License-Identifier: Apache-2.0
// Calls generated code that may not return. Generated code bounds its own steps, but faulty code may contain an endless
// loop. The search then reports a finding and continues.
#pragma once

#include "cpp_emit/runtime/explore_abi.h"

namespace robochart::conformance {

/// The result of a call of `step`.
struct Stepped {
    rc_result result = RC_QUIESCENT;
    bool endless = false;  ///< the call was stopped; `state` and `log` have the values at this moment
};

/// The maximal duration of a call of generated code.
enum class Patience {
    seconds,  ///< one to two seconds of the thread's own time
    short_,   ///< a hundredth of that, after an endless call has been found in the code
};

/// Calls `step`. If the call does not return, it is stopped, and its result is RC_STEP_BOUND. The code must own no
/// resources (no heap, no locks). Generated code satisfies this.
[[nodiscard]] Stepped step_watched(const rc_interface&, void* state, const rc_register* registers, rc_log* log,
                                   Patience = Patience::seconds);

/// A call of generated code, and its arguments.
using Guarded = rc_result (*)(void* arguments);

/// Calls another function of the interface, with the same watchdog.
[[nodiscard]] Stepped call_watched(Guarded, void* arguments, Patience = Patience::seconds);

}  // namespace robochart::conformance
