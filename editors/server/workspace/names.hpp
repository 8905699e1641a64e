// SPDX-License-Identifier: Apache-2.0
// Finds the occurrences of names that refer to the same declaration or element.
#pragma once

#include <vector>

#include "editors/server/workspace/workspace.hpp"

namespace robochart::lsp {

/// All occurrences of the project that refer to the same thing as this one, including itself, sorted by place.
[[nodiscard]] std::vector<const frontend::Occurrence*> same_name(Project&, const frontend::Occurrence&);

}  // namespace robochart::lsp
