// SPDX-License-Identifier: Apache-2.0
// Finds the names that can be written at a place (language reference 1.3).
#pragma once

#include <string>
#include <vector>

#include "editors/server/workspace/workspace.hpp"
#include "frontend/project/occurrences.hpp"

namespace robochart::lsp {

/// Returns the declaration whose name has this span; null if there is none.
[[nodiscard]] const frontend::Declaration* declared_at(const frontend::File&, Span name);
/// Returns the declarations of other files that are visible in a file without qualification: those of its package, of
/// its imports, and of unnamed packages. Literals of visible enumerations are included.
[[nodiscard]] std::vector<const frontend::Declaration*> visible_from(const frontend::Model&, const frontend::File&);
/// Returns the declarations that may follow `A::B::`.
[[nodiscard]] std::vector<const frontend::Declaration*> declarations_after(const frontend::Model&,
                                                                           const frontend::File&,
                                                                           const std::vector<std::string>& qualifier);
/// Returns the parts of package names that may follow `A::` or begin a name.
[[nodiscard]] std::vector<std::string> packages_behind(const frontend::Model&,
                                                       const std::vector<std::string>& qualifier);

}  // namespace robochart::lsp
