// The names that can be written at a place (language reference 1.3).
#pragma once

#include <string>
#include <vector>

#include "frontend/project/occurrences.hpp"
#include "lsp/workspace/workspace.hpp"

namespace robochart::lsp {

/// The declaration whose name has this span; null if the tree has none.
[[nodiscard]] const frontend::Declaration* declared_at(const frontend::File&, Span name);
/// Declarations of files that a file sees without qualifying them: of its package, of what it imports, of unnamed
/// packages. Literals of visible enumerations are among them.
[[nodiscard]] std::vector<const frontend::Declaration*> visible_from(const frontend::Model&, const frontend::File&);
/// Declarations that may follow `A::B::`.
[[nodiscard]] std::vector<const frontend::Declaration*> behind(const frontend::Model&, const frontend::File&,
                                                               const std::vector<std::string>& qualifier);
/// Names of packages that may follow `A::`, or stand first; one part each.
[[nodiscard]] std::vector<std::string> packages_behind(const frontend::Model&,
                                                       const std::vector<std::string>& qualifier);

}  // namespace robochart::lsp
