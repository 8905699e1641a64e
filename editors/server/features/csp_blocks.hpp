// SPDX-License-Identifier: Apache-2.0
// Provides completion and hovers inside CSP blocks of assertion files, for names of the script that contains the block.
#pragma once

#include <optional>

#include "editors/server/workspace/target.hpp"

namespace robochart::lsp {

/// Returns the completions at a place inside a block; no value if the place is not in a block.
[[nodiscard]] std::optional<Json> completion_in_block(const Session&, const Target&);
/// Describes the name at a place inside a block by its meaning in the model. Returns no value if the place is not in a
/// block.
[[nodiscard]] std::optional<Hover> hover_in_block(const Session&, const Target&);

}  // namespace robochart::lsp
