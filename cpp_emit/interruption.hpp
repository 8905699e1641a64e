// What a state's during action does, itself or in operations that it calls, can be cut short by a transition.
#pragma once

#include "cpp_emit/component.hpp"

namespace robochart::cpp_emit {

/// Marks the platform calls and the variables seen outside that during actions make and write
/// (PlatformCall::interruptible, StoredVariable::interruptible). Elsewhere a second call in one cycle stops time for
/// good, so such a model is not schedulable; here a transition may leave the state instead, so the code must wait.
void mark_interruptible(Component&);

/// The member of Step that tells whether an interruptible output was made in this cycle.
[[nodiscard]] std::string done_flag(const PlatformCall&);
[[nodiscard]] std::string done_flag(const StoredVariable&);

}  // namespace robochart::cpp_emit
