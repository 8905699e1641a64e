// SPDX-License-Identifier: Apache-2.0
// Replaces the contents of a file's tree while the addresses to which other files point stay valid (private to the
// front end).
#pragma once

#include <string>

#include "frontend/syntax/ast.hpp"

namespace robochart::frontend {

/// The parts of a file that other files can see, as text: everything except nodes and transitions (which only
/// assertions see), and the facts recorded about its syntax errors. If the texts of two trees are equal, the trees
/// differ for other files only in the places of declarations.
[[nodiscard]] std::string outside_of(File& file);

/// True if both trees have the same declarations in the same order.
[[nodiscard]] bool same_declarations(const File& old, const File& fresh);

/// Moves the new tree into the old one. Declarations to which other files may point (all except nodes, transitions,
/// connections, expressions and statements) keep their addresses. Precondition: `same_declarations`.
void patch_file(File& old, File&& fresh);

}  // namespace robochart::frontend
