// SPDX-License-Identifier: Apache-2.0
// Finds declarations in the text of a script, for tools that read scripts without evaluating them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "checker/cspm/syntax/syntax.hpp"

namespace robochart::cspm {

/// Returns the names that a declaration adds to its scope: its own names, its constructors, and the variables in the
/// pattern of a value.
[[nodiscard]] std::vector<std::string> declared_names(const Decl& decl);

/// Returns the declaration of `path`: `name` or `A::B::name`, with or without a leading `::`. Also searches timed
/// sections, the private parts of modules, and the modules of instances. For a function, returns the first clause.
/// Returns null if it finds no declaration.
[[nodiscard]] DeclPtr declaration_of(const Script& script, std::string_view path);

/// Returns the assertions among the declarations in order. Also searches modules and timed sections.
[[nodiscard]] std::vector<DeclPtr> assertions_in(const std::vector<DeclPtr>& decls);

}  // namespace robochart::cspm
