// SPDX-License-Identifier: Apache-2.0
// Collects the names that CSPM text declares at its top level.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "checker/cspm/syntax/syntax.hpp"

namespace robochart::csp_emit {

/// Names in CSP blocks, grouped by the names that they can clash with.
struct UserNames {
    std::set<std::string> constructors;  ///< channels and constructors at the top
    std::set<std::string> all;           ///< everything declared at the top
    std::set<std::string> modules;       ///< modules and instances at the top
};
[[nodiscard]] UserNames user_names(const std::vector<cspm::DeclPtr>& blocks);

}  // namespace robochart::csp_emit
