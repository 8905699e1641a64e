// Comments of CSP blocks, for scripts that are written down again: the tree has a place for them, and who only
// evaluates it leaves it empty.
#pragma once

#include <string_view>
#include <vector>

#include "checker/cspm/syntax/syntax.hpp"

namespace robochart::csp_emit {

/// The declarations of this text, each with the comments that stand before it, in it, or behind it on its last line.
/// What stands behind the last declaration is its comment too, so none is lost unless there is no declaration.
[[nodiscard]] std::vector<cspm::DeclPtr> with_comments(const std::vector<cspm::DeclPtr>& decls, std::string_view text);

}  // namespace robochart::csp_emit
