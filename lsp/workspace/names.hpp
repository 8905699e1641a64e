// Which occurrences speak of the same thing.
#pragma once

#include <vector>

#include "lsp/workspace/workspace.hpp"

namespace robochart::lsp {

/// All occurrences of the project that stand for what this one stands for, itself among them, by place.
[[nodiscard]] std::vector<const frontend::Occurrence*> same_name(Project&, const frontend::Occurrence&);

}  // namespace robochart::lsp
