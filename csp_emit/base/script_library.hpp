// SPDX-License-Identifier: Apache-2.0
// The beginning of a project's script, as a syntax tree.
#pragma once

#include <vector>

#include "csp_emit/base/project.hpp"

namespace robochart::csp_emit {

/// The library of the project's semantics (untimed or timed) and the toolkit functions that the model calls. The trees
/// have no places: an error inside of them is reported where the model calls them.
[[nodiscard]] std::vector<cspm::DeclPtr> library(const Project&);

}  // namespace robochart::csp_emit
