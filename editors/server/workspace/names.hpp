// SPDX-License-Identifier: Apache-2.0
// Finds the occurrences of names that refer to the same declaration or element.
#pragma once

#include <vector>

#include "editors/server/workspace/workspace.hpp"

namespace robochart::lsp {

/// Returns all occurrences in the project with the same target as this occurrence, which is included, sorted by place.
[[nodiscard]] std::vector<const frontend::Occurrence*> same_name(Project&, const frontend::Occurrence&);

}  // namespace robochart::lsp
