// SPDX-License-Identifier: Apache-2.0
// Renames names in syntax trees, and finds the names that patterns bind. A name is renamed everywhere, even where it
// has another meaning. So callers must choose names that have only one meaning in the tree.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "checker/cspm/syntax/syntax.hpp"

namespace robochart::cspm {

/// Maps old names to new names.
using NewNames = std::map<std::string, std::string>;

/// Returns the declarations with the new names. Of a qualified name `A::b`, only the first part can be renamed. Returns
/// the same objects if `names` is empty.
[[nodiscard]] std::vector<DeclPtr> rename_declarations(const std::vector<DeclPtr>& decls, const NewNames& names);

/// New names for plain names and for the parts of qualified names. The tree declares `modules` itself; a name after one
/// of them is renamed like a plain name.
struct QualifiedNames {
    NewNames plain;
    NewNames first, inside, last;  ///< new names for A, b and c in `A::b::c`
    std::set<std::string> modules;
};
[[nodiscard]] std::vector<DeclPtr> rename_declarations(const std::vector<DeclPtr>& decls, const QualifiedNames& names);

/// Returns the names of parameters of functions, lambdas and modules, of variables in generators and inputs, and of
/// local definitions. If a channel or constructor has such a name where the tree is used, the name no longer binds a
/// variable there: it is a pattern for that one value.
[[nodiscard]] std::set<std::string> bound_names(const std::vector<DeclPtr>& decls);

/// Returns the names that declarations of values bind outside expressions, including the private and exported parts of
/// modules.
[[nodiscard]] std::set<std::string> value_names(const std::vector<DeclPtr>& decls);

}  // namespace robochart::cspm
