// Components that are used in several places, a machine on its own and in a controller, a controller in a module,
// become modules of equal text. Such a module is written once, with a parameter that nothing reads, and each place has
// an `instance` of it: the same channels and processes under the same names (FDR manual, modules), in less text.
#pragma once

#include <vector>

#include "checker/cspm/syntax/syntax.hpp"
#include "csp_emit/base/names.hpp"

namespace robochart::csp_emit {

/// The declarations with equal modules shared; `names` gives names to what is shared. A module is left where it is if
/// a name in it would mean something else in the place where all its users can see it.
[[nodiscard]] std::vector<cspm::DeclPtr> share_modules(std::vector<cspm::DeclPtr> decls, NameManager names);

}  // namespace robochart::csp_emit
