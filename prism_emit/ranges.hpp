// Models whose updates stay in the ranges of their variables in every state, reachable or not: PRISM's engines that
// work with decision diagrams ask for that.
#pragma once

#include "checker/prism/syntax/syntax.hpp"

namespace robochart::prism_emit {

/// The label of the states in which a step is left out since it would leave a range.
inline constexpr const char* left_out_label = "out_of_range";

/// Guards each command whose update may leave a range. If there is one, `left_out_label` is added, which no state that
/// is reachable may satisfy.
[[nodiscard]] prism::ModelFile in_ranges(prism::ModelFile model);

}  // namespace robochart::prism_emit
