// What expressions of a script are about: themselves and the definitions of CSP blocks that they name.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "checker/cspm/syntax/syntax.hpp"
#include "csp_emit/base/emission.hpp"

namespace robochart::csp_emit {

/// Calls `visit` on the expressions and all their parts, and on those of the definitions outside of components that
/// they name; of each definition once.
void visit_named(const Emission&, const std::vector<cspm::ExprPtr>&,
                 const std::function<void(const cspm::ExprPtr&)>& visit);

/// The paths of the components whose processes the expressions name.
[[nodiscard]] std::set<std::string> components_in(const Emission&, const std::vector<cspm::ExprPtr>&);

}  // namespace robochart::csp_emit
