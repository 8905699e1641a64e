// A call of generated code that need not come back. Generated code bounds its own steps; code with a fault may not, and
// an endless loop in it must be a finding, not the end of the search.
#pragma once

#include "cpp_emit/runtime/explore_abi.h"

namespace robochart::conformance {

/// What a call of `step` came to.
struct Stepped {
    rc_result result = RC_QUIESCENT;
    bool endless = false;  ///< it was stopped: `state` and `log` are as the code had left them then
};

/// How long a call of generated code may take.
enum class Patience {
    seconds,  ///< one to two of the thread's own time
    short_,   ///< a hundredth of that, for code of which one call was found endless
};

/// Calls `step`; what does not return is stopped, and its result is RC_STEP_BOUND. The code must own nothing (no heap,
/// no locks), as generated code does.
[[nodiscard]] Stepped watched_step(const rc_interface&, void* state, const rc_register* registers, rc_log* log,
                                   Patience = Patience::seconds);

/// A call of generated code, and what it is called with.
using Guarded = rc_result (*)(void* arguments);

/// The same for other functions of the interface.
[[nodiscard]] Stepped watched(Guarded, void* arguments, Patience = Patience::seconds);

}  // namespace robochart::conformance
