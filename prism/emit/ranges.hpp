// SPDX-License-Identifier: Apache-2.0
// Restricts updates so that they stay in the ranges of their variables in every state, reachable or not. PRISM's
// engines that use decision diagrams require this.
#pragma once

#include "prism/syntax/syntax.hpp"

namespace robochart::prism_emit {

/// The label of the states in which a step is omitted because it would leave a range.
inline constexpr const char* left_out_label = "out_of_range";

/// Adds a guard to each command whose update may leave a range. If there is one, also adds `left_out_label`; no
/// reachable state may satisfy it.
[[nodiscard]] prism::ModelFile in_ranges(prism::ModelFile model);

}  // namespace robochart::prism_emit
