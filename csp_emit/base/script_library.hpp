// SPDX-License-Identifier: Apache-2.0
// Provides the beginning of a project's script as a syntax tree.
#pragma once

#include <vector>

#include "csp_emit/base/project.hpp"

namespace robochart::csp_emit {

/// Returns the library of the project's semantics (untimed or timed) and the toolkit functions that the model calls.
/// Its syntax trees have no spans, so an error inside the library is reported where the model calls it.
[[nodiscard]] std::vector<cspm::DeclPtr> script_library(const Project&);

}  // namespace robochart::csp_emit
