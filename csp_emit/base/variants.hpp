// SPDX-License-Identifier: Apache-2.0
// Applies the operators that the process variants of all components share (semantics 3.12).
#pragma once

#include "csp_emit/base/project.hpp"

namespace robochart::csp_emit {

/// Timed: gives hidden events and ✓ priority over tock, `prioritise(P,<{},{tock}>)`; untimed: returns P. The events of
/// the set `urgent`, if given, get priority over tock as well.
[[nodiscard]] cspm::ExprPtr maximal_progress(const Project&, const cspm::ExprPtr& process,
                                             const cspm::ExprPtr& urgent = nullptr);
/// Untimed `sbisim(diamond(P))`, timed `dbisim(P)`.
[[nodiscard]] cspm::ExprPtr compress_process(const Project&, const cspm::ExprPtr& process, bool large = false);

}  // namespace robochart::csp_emit
