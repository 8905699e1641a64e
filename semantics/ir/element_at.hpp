// SPDX-License-Identifier: Apache-2.0
// Finds the element of the model that contains a place, for reports about expressions, which have no names.
#pragma once

#include <string>

#include "base/diagnostics/source.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::ir {

/// The smallest element of a component, or the function, that contains a place, with its package: "P::S::t1"; "" if
/// there is none.
[[nodiscard]] std::string element_at(const System&, diagnostics::Span);

}  // namespace robochart::ir
