// SPDX-License-Identifier: Apache-2.0
// Finds and replaces the processes of components in the expressions of claims.
#pragma once

#include <string>

#include "checker/cspm/syntax/syntax.hpp"

namespace robochart::driver {

/// Returns the component whose process the expression calls: "P::S" for `P::S::O__(..)`. Returns "" if the expression
/// calls no process of a component.
[[nodiscard]] std::string component_of(const cspm::Expr& expr);

/// Returns the expression with the given variant of the components' processes, such as `D__`.
[[nodiscard]] cspm::ExprPtr with_variant(const cspm::ExprPtr& expr, const std::string& variant);

/// Returns the expression without compression of components: `D__` replaces `O__`, and `VS__` replaces `VS_O__`. An
/// expression that calls no compressed process is returned unchanged.
[[nodiscard]] cspm::ExprPtr without_compression(const cspm::ExprPtr& expr);

}  // namespace robochart::driver
