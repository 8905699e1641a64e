// SPDX-License-Identifier: Apache-2.0
// Removes the spans from syntax trees, so that errors inside them are reported where the trees are used.
#pragma once

#include <vector>

#include "checker/cspm/syntax/syntax.hpp"

namespace robochart::csp_emit {

/// Returns the same declarations without spans. The evaluator then reports errors in them at the nearest caller that
/// has a span.
[[nodiscard]] std::vector<cspm::DeclPtr> without_places(const std::vector<cspm::DeclPtr>&);

}  // namespace robochart::csp_emit
