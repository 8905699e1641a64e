// What a call of generated code wrote and was asked, compared and gone through.
#pragma once

#include "cpp_emit/runtime/explore_abi.h"

namespace robochart::conformance {

/// The same outputs with the same arguments in the same order.
[[nodiscard]] bool same_writes(const rc_log&, const rc_log&);

/// The next answers to what a call asked, counted from the last; false after the last ones.
[[nodiscard]] bool next_choices(rc_log&);

}  // namespace robochart::conformance
