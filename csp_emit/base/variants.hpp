// What all components' process variants share (semantics 3.12).
#pragma once

#include "csp_emit/base/project.hpp"

namespace robochart::csp_emit {

/// Timed: hidden events and ✓ before tock, `prioritise(P,<{},{tock}>)`; untimed: P. With `urgent`, a set of
/// events, these come before tock as well.
[[nodiscard]] cspm::ExprPtr maximal_progress(const Project&, const cspm::ExprPtr& process,
                                             const cspm::ExprPtr& urgent = nullptr);
/// Untimed `sbisim(diamond(P))`, timed `dbisim(P)`.
[[nodiscard]] cspm::ExprPtr compressed(const Project&, const cspm::ExprPtr& process, bool large = false);

}  // namespace robochart::csp_emit
