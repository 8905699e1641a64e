// SPDX-License-Identifier: Apache-2.0
// Restricts updates so that they stay in the ranges of their variables in every state, reachable or not. PRISM's
// engines that use decision diagrams require this.
#pragma once

#include "prism/syntax/syntax.hpp"

namespace robochart::prism_emit {

/// The label of the states in which a step is omitted, because its update would leave a range.
inline constexpr const char* left_out_label = "out_of_range";

/// Adds a guard to each command whose update may leave a range. If there is such a command, also adds `left_out_label`.
/// No reachable state may satisfy this label.
[[nodiscard]] prism::ModelFile in_ranges(prism::ModelFile model);

}  // namespace robochart::prism_emit
