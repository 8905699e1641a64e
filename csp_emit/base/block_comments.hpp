// SPDX-License-Identifier: Apache-2.0
// Attaches the comments of CSP blocks to the syntax tree, so that printed scripts still contain them. Comments have no
// effect on the evaluation.
#pragma once

#include <string_view>
#include <vector>

#include "checker/cspm/syntax/syntax.hpp"

namespace robochart::csp_emit {

/// Returns the declarations of `text` with their comments: those before a declaration, inside it, and after it on its
/// last line. Comments after the last declaration belong to it. So comments are lost only if there is no declaration at
/// all.
[[nodiscard]] std::vector<cspm::DeclPtr> with_comments(const std::vector<cspm::DeclPtr>& decls, std::string_view text);

}  // namespace robochart::csp_emit
