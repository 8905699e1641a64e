// SPDX-License-Identifier: Apache-2.0
// Finds the element of the model that contains a place. Reports about expressions name this element, because
// expressions have no names.
#pragma once

#include <string>

#include "base/diagnostics/source.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::ir {

/// Returns the name of the element that contains a place, with its package: "P::S::t1". The element is a function, or
/// the smallest element of a component. Returns "" if no element contains the place.
[[nodiscard]] std::string element_at(const System&, diagnostics::Span);

}  // namespace robochart::ir
