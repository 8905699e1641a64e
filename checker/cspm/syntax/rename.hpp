// Syntax trees with other names in them, and the names that patterns in them bind. Names are changed wherever they
// stand, whatever they mean there: whoever calls this chooses names that mean one thing, or nothing, in the tree.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "checker/cspm/syntax/syntax.hpp"

namespace robochart::cspm {

/// New names by old ones.
using NewNames = std::map<std::string, std::string>;

/// The declarations with the new names; of a qualified name `A::b` the first part may have one. They themselves if
/// there are no new names.
[[nodiscard]] std::vector<DeclPtr> renamed(const std::vector<DeclPtr>& decls, const NewNames& names);

/// New names of plain names, and of the parts of qualified ones. What stands behind one of `modules`, which the
/// declarations themselves have, is renamed as a plain name is.
struct QualifiedNames {
    NewNames plain;
    NewNames first, inside, last;  ///< of `A::b::c`: A, b and c
    std::set<std::string> modules;
};
[[nodiscard]] std::vector<DeclPtr> renamed(const std::vector<DeclPtr>& decls, const QualifiedNames& names);

/// Parameters of functions, lambdas and modules, variables of generators, inputs and local definitions. What stands
/// there and is a channel or a constructor where the tree is used would be a pattern that matches only that.
[[nodiscard]] std::set<std::string> bound_names(const std::vector<DeclPtr>& decls);

/// Names that a value declaration binds outside expressions: of the modules' exported and private parts too.
[[nodiscard]] std::set<std::string> value_names(const std::vector<DeclPtr>& decls);

}  // namespace robochart::cspm
