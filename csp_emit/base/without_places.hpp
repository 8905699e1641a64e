// SPDX-License-Identifier: Apache-2.0
// Removes the spans from syntax trees, so that errors inside them are reported where the trees are used.
#pragma once

#include <vector>

#include "checker/cspm/syntax/syntax.hpp"

namespace robochart::csp_emit {

/// Returns the same declarations with unknown spans. The evaluator reports an error inside them at the nearest caller
/// with a known span.
[[nodiscard]] std::vector<cspm::DeclPtr> without_places(const std::vector<cspm::DeclPtr>&);

}  // namespace robochart::csp_emit
