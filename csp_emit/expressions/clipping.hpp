// SPDX-License-Identifier: Apache-2.0
// Where the finite instantiation changes values: results of arithmetic outside their type are clipped, and functions
// without a body return a chosen value (semantics 3.13). The checker records the calls of these functions that it
// evaluates while it explores processes; this file explains them in terms of the model.
#pragma once

#include <optional>
#include <string>

#include "checker/cspm/syntax/observed_call.hpp"
#include "csp_emit/base/emission.hpp"
#include "semantics/ir/instantiation.hpp"

namespace robochart::csp_emit {

/// The tree in which every call without a known place has this place.
[[nodiscard]] cspm::ExprPtr placed(const cspm::ExprPtr&, diagnostics::Span);

/// Describes how the call deviates from the model; no value if its result is the model's. Examples: "2 + 1 leaves its
/// type and is taken as 2", "f has no body here and is taken as 0".
[[nodiscard]] std::optional<std::string> reached_bound(const Emission&, const ir::Instantiation&,
                                                       const cspm::ObservedCall&);

}  // namespace robochart::csp_emit
