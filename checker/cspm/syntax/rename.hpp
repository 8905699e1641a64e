// SPDX-License-Identifier: Apache-2.0
// Renames names in syntax trees, and finds the names that patterns bind. A name is renamed wherever it occurs, with
// any meaning. So the caller must choose names that have at most one meaning in the tree.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "checker/cspm/syntax/syntax.hpp"

namespace robochart::cspm {

/// Maps old names to new names.
using NewNames = std::map<std::string, std::string>;

/// Returns the declarations with the new names. In a qualified name `A::b`, the first part may be renamed. Returns the
/// same objects if there are no new names.
[[nodiscard]] std::vector<DeclPtr> rename_declarations(const std::vector<DeclPtr>& decls, const NewNames& names);

/// The new names for plain names, and for the parts of qualified names. A name after one of `modules`, which the tree
/// itself declares, is renamed like a plain name.
struct QualifiedNames {
    NewNames plain;
    NewNames first, inside, last;  ///< new names for A, b and c in `A::b::c`
    std::set<std::string> modules;
};
[[nodiscard]] std::vector<DeclPtr> rename_declarations(const std::vector<DeclPtr>& decls, const QualifiedNames& names);

/// Returns the names of parameters of functions, lambdas and modules, of variables of generators and inputs, and of
/// local definitions. If such a name is also a channel or a constructor where the tree is used, it becomes a pattern
/// that matches only this value.
[[nodiscard]] std::set<std::string> bound_names(const std::vector<DeclPtr>& decls);

/// Returns the names that value declarations bind outside expressions. These declarations may be in exported or private
/// parts of modules.
[[nodiscard]] std::set<std::string> value_names(const std::vector<DeclPtr>& decls);

}  // namespace robochart::cspm
