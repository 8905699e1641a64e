// What is declared where in the text of a script: for tools that look at scripts without evaluating them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "checker/cspm/syntax/syntax.hpp"

namespace robochart::cspm {

/// The names that a declaration brings into its scope: constructors too, of a value the variables that are its pattern.
[[nodiscard]] std::vector<std::string> declared_names(const Decl& decl);

/// The declaration of `path`, a name or `A::B::name` with or without a `::` in front: into modules, their private parts
/// too, into timed sections, and from an instance into the module that it is made of. Of a function the first clause.
/// Null if there is none.
[[nodiscard]] DeclPtr declaration_of(const Script& script, std::string_view path);

/// The assertions among declarations in their order, those inside modules and timed sections too.
[[nodiscard]] std::vector<DeclPtr> assertions_in(const std::vector<DeclPtr>& decls);

}  // namespace robochart::cspm
