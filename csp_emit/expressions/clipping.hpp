// SPDX-License-Identifier: Apache-2.0
// Describes where the finite instantiation changes values. Arithmetic clips results outside their type, and a function
// without a body returns a default value (semantics 3.13). While the checker explores processes, it records the calls
// of such functions. This file explains these calls in terms of the model.
#pragma once

#include <optional>
#include <string>

#include "checker/cspm/syntax/observed_call.hpp"
#include "csp_emit/base/emission.hpp"
#include "semantics/ir/instantiation.hpp"

namespace robochart::csp_emit {

/// Returns the tree with this span in every call and every division that has no known span.
[[nodiscard]] cspm::ExprPtr with_place(const cspm::ExprPtr&, diagnostics::Span);

/// Describes how the result of the call differs from that in the model. Returns no value if both are equal. Examples:
/// "2 + 1 leaves its type and is taken as 2", "f has no body here and is taken as 0".
[[nodiscard]] std::optional<std::string> reached_bound(const Emission&, const ir::Instantiation&,
                                                       const cspm::ObservedCall&);

}  // namespace robochart::csp_emit
