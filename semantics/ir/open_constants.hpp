// SPDX-License-Identifier: Apache-2.0
// Finds constants that have no value in the model but are used in a divisor.
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics/source.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::ir {

/// Returns the names, without duplicates, of constants that have no value in the model and occur in divisors inside
/// this span of text. Such a constant is 0 unless an option gives it a value. Constants that a block Instantiations
/// mentions are not included, because the block may give them a value.
[[nodiscard]] std::vector<std::string> open_divisors(const System&, diagnostics::Span place);

}  // namespace robochart::ir
