// Inside CSP blocks of assertion files: the names of the script that they are part of.
#pragma once

#include <optional>

#include "lsp/workspace/session.hpp"

namespace robochart::lsp {

/// What may be written at a place inside a block; nothing where the place is in none.
[[nodiscard]] std::optional<Json> completion_in_block(const Session&, const Target&);
/// The name of the script at a place inside a block, with what it means in the model; null if there is none, nothing
/// where the place is in no block.
[[nodiscard]] std::optional<Json> hover_in_block(const Session&, const Target&);

}  // namespace robochart::lsp
