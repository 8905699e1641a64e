// A new tree of a file put into its old one, so that what other files point at stays where it is (private to the front
// end).
#pragma once

#include <string>

#include "frontend/syntax/ast.hpp"

namespace robochart::frontend {

/// What other files can see of a file, as text: everything but nodes and transitions (assertions see those too), and
/// what is kept about its mistakes. Two trees with equal texts differ for others in nothing but places.
[[nodiscard]] std::string outside_of(File& file);

/// Do both trees have the same declarations in the same order?
[[nodiscard]] bool same_declarations(const File& old, const File& fresh);

/// Moves everything of the new tree into the old one; declarations that other files may point at (all but nodes,
/// transitions, connections, expressions and statements) keep their addresses. Only for the same declarations.
void patch(File& old, File&& fresh);

}  // namespace robochart::frontend
