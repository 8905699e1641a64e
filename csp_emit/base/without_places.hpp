// SPDX-License-Identifier: Apache-2.0
// Syntax trees without places: what goes wrong in them is reported where they are used.
#pragma once

#include <vector>

#include "checker/cspm/syntax/syntax.hpp"

namespace robochart::csp_emit {

/// The same declarations with unknown spans. An error of evaluation inside of them gets the place of the nearest caller
/// that has one.
[[nodiscard]] std::vector<cspm::DeclPtr> without_places(const std::vector<cspm::DeclPtr>&);

}  // namespace robochart::csp_emit
