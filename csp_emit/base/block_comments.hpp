// SPDX-License-Identifier: Apache-2.0
// Attaches the comments of CSP blocks to the syntax tree, so that printed scripts contain them. The evaluation ignores
// the comments.
#pragma once

#include <string_view>
#include <vector>

#include "checker/cspm/syntax/syntax.hpp"

namespace robochart::csp_emit {

/// Returns the declarations of `text`. Each declaration gets the comments before it, inside it, and after it on its
/// last line. Comments after the last declaration are attached to it, so no comment is lost unless there is no
/// declaration.
[[nodiscard]] std::vector<cspm::DeclPtr> with_comments(const std::vector<cspm::DeclPtr>& decls, std::string_view text);

}  // namespace robochart::csp_emit
