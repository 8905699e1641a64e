// SPDX-License-Identifier: Apache-2.0
// Changes names in CSP blocks when the names are renamed in the model.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "editors/server/renaming/rename_check.hpp"

namespace robochart::lsp {

/// Returns the edits of CSP blocks that these edits of the model require. They change parts of qualified names, and
/// names that the script derives (`moveCall`, `set_x`). Returns no value if the blocks would have errors after the
/// edits. The list is empty if no block contains the name.
[[nodiscard]] std::optional<std::vector<Edit>> edits_of_blocks(Project&, const std::string& old_name,
                                                               const std::string& new_name,
                                                               const std::vector<Edit>& edits_of_model,
                                                               diagnostics::Budget*);

}  // namespace robochart::lsp
