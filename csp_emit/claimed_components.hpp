// SPDX-License-Identifier: Apache-2.0
// Finds the components that expressions of a script mention, directly or through definitions of CSP blocks.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "checker/cspm/syntax/syntax.hpp"
#include "csp_emit/base/emission.hpp"

namespace robochart::csp_emit {

/// Calls `visit` for each expression and each of its parts. Also visits the definitions of their names, once each,
/// unless they are inside a component.
void visit_named(const Emission&, const std::vector<cspm::ExprPtr>&,
                 const std::function<void(const cspm::ExprPtr&)>& visit);

/// Returns the paths of the components whose processes the expressions name.
[[nodiscard]] std::set<std::string> components_in(const Emission&, const std::vector<cspm::ExprPtr>&);

}  // namespace robochart::csp_emit
