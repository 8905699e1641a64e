// SPDX-License-Identifier: Apache-2.0
// Applies the operators that the process variants of all components share (semantics 3.12).
#pragma once

#include "csp_emit/base/project.hpp"

namespace robochart::csp_emit {

/// In the timed semantics, returns `prioritise(P,<{},{tock}>)`, which gives hidden events and ✓ priority over tock. The
/// events of the set `urgent`, if given, also get priority over tock. In the untimed semantics, returns P.
[[nodiscard]] cspm::ExprPtr maximal_progress(const Project&, const cspm::ExprPtr& process,
                                             const cspm::ExprPtr& urgent = nullptr);
/// Returns `sbisim(diamond(P))` in the untimed semantics, and `dbisim(P)` in the timed semantics.
[[nodiscard]] cspm::ExprPtr compress_process(const Project&, const cspm::ExprPtr& process, bool large = false);

}  // namespace robochart::csp_emit
