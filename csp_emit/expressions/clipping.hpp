// Where finite instantiation clips values: arithmetic that leaves its type is clipped, functions without a body have
// a value chosen (semantics 3.13). The checker tells which calls of the functions behind it were evaluated while it
// explored processes; this component knows what they mean.
#pragma once

#include <optional>
#include <string>

#include "checker/cspm/syntax/observed_call.hpp"
#include "csp_emit/base/emission.hpp"
#include "semantics/ir/instantiation.hpp"

namespace robochart::csp_emit {

/// The tree with this place at every call whose place is not known yet.
[[nodiscard]] cspm::ExprPtr placed(const cspm::ExprPtr&, diagnostics::Span);

/// What the call leaves out or chooses, in words; nothing if its value is what the model says.
/// "2 + 1 leaves its type and is taken as 2", "f has no body here and is taken as 0".
[[nodiscard]] std::optional<std::string> reached_bound(const Emission&, const ir::Instantiation&,
                                                       const cspm::ObservedCall&);

}  // namespace robochart::csp_emit
