// SPDX-License-Identifier: Apache-2.0
// Replaces the contents of a file's tree so that pointers from other files into the tree stay valid (private to the
// front end).
#pragma once

#include <string>

#include "frontend/syntax/ast.hpp"

namespace robochart::frontend {

/// Returns the parts of a file that are visible in other files, as text: everything except nodes and transitions (which
/// are visible only in assertions), and the recorded facts about syntax errors. If two trees have equal texts, the only
/// differences visible in other files are the places of declarations.
[[nodiscard]] std::string outside_of(File& file);

/// True if both trees have the same declarations in the same order.
[[nodiscard]] bool same_declarations(const File& old, const File& fresh);

/// Moves the new tree into the old one. Declarations to which other files may point (all except nodes, transitions,
/// connections, expressions and statements) keep their addresses. Precondition: `same_declarations`.
void patch_file(File& old, File&& fresh);

}  // namespace robochart::frontend
