// SPDX-License-Identifier: Apache-2.0
// Provides the beginning of a project's script as a syntax tree.
#pragma once

#include <vector>

#include "csp_emit/base/project.hpp"

namespace robochart::csp_emit {

/// Returns the library for the project's semantics (untimed or timed), with the toolkit functions that the model calls.
/// Its trees have no spans. So an error inside the library is reported at the call in the model.
[[nodiscard]] std::vector<cspm::DeclPtr> script_library(const Project&);

}  // namespace robochart::csp_emit
