// SPDX-License-Identifier: Apache-2.0
// Shortens the script by sharing modules with equal text. Such modules result from components that are used in several
// places (a machine separately and in a controller, a controller in a module). A shared module is written once, with an
// unused parameter. Each place contains an `instance` of it, with the same channels and processes under the same names
// (FDR manual, modules).
#pragma once

#include <vector>

#include "checker/cspm/syntax/syntax.hpp"
#include "csp_emit/base/names.hpp"

namespace robochart::csp_emit {

/// Returns the declarations with equal modules shared. `names` provides names for the shared modules. A module is not
/// shared if a name in this module would have another meaning at the place at which the shared module is declared.
[[nodiscard]] std::vector<cspm::DeclPtr> share_modules(std::vector<cspm::DeclPtr> decls, NameManager names);

}  // namespace robochart::csp_emit
