// SPDX-License-Identifier: Apache-2.0
// The processes of components in the expressions of claims.
#pragma once

#include <string>

#include "checker/cspm/syntax/syntax.hpp"

namespace robochart::driver {

/// The component whose process is called: "P::S" for `P::S::O__(..)`; "" if there is none.
[[nodiscard]] std::string component_of(const cspm::Expr& expr);

/// The expression with this variant of the processes of components, such as `D__`.
[[nodiscard]] cspm::ExprPtr with_variant(const cspm::ExprPtr& expr, const std::string& variant);

/// The expression without compression of components: `D__` for `O__` and `VS__` for `VS_O__`. The same expression if it
/// calls none of these.
[[nodiscard]] cspm::ExprPtr without_compression(const cspm::ExprPtr& expr);

}  // namespace robochart::driver
