// Names of the model in CSP blocks, when the model's are renamed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lsp/renaming/rename_check.hpp"

namespace robochart::lsp {

/// The edits of blocks that go with these edits of the model: parts of qualified names, and what the script makes of a
/// name (`moveCall`, `set_x`). Nothing where the blocks would not be in order with them; empty if no block has the
/// name.
[[nodiscard]] std::optional<std::vector<Edit>> edits_of_blocks(Project&, const std::string& old_name,
                                                               const std::string& new_name,
                                                               const std::vector<Edit>& edits_of_model,
                                                               diagnostics::Budget*);

}  // namespace robochart::lsp
