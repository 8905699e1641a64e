// SPDX-License-Identifier: Apache-2.0
// Features inside CSP blocks of assertion files, for names of the script that contains the block.
#pragma once

#include <optional>

#include "editors/server/workspace/target.hpp"

namespace robochart::lsp {

/// The completions at a place inside a block; no value if the place is not in a block.
[[nodiscard]] std::optional<Json> completion_in_block(const Session&, const Target&);
/// The name of the script at a place inside a block, and its meaning in the model. No value if the place is not in
/// a block.
[[nodiscard]] std::optional<Hover> hover_in_block(const Session&, const Target&);

}  // namespace robochart::lsp
