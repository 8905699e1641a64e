// SPDX-License-Identifier: Apache-2.0
// Components that are used in several places (a machine on its own and in a controller, a controller in a module)
// become modules with equal text. Such a module is written once, with an unused parameter, and each place has an
// `instance` of it: the same channels and processes under the same names (FDR manual, modules), in less text.
#pragma once

#include <vector>

#include "checker/cspm/syntax/syntax.hpp"
#include "csp_emit/base/names.hpp"

namespace robochart::csp_emit {

/// The declarations in which equal modules are shared; `names` provides names for the shared modules. A module is not
/// moved if a name in it would have another meaning in the place where all its users can see it.
[[nodiscard]] std::vector<cspm::DeclPtr> share_modules(std::vector<cspm::DeclPtr> decls, NameManager names);

}  // namespace robochart::csp_emit
