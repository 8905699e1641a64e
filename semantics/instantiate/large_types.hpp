// SPDX-License-Identifier: Apache-2.0
// Finds types of a model with too many values to enumerate.
#pragma once

#include <string>

#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::ir {

/// Describes the first type of an event or a parameter that has more than `most` values: its name, the number in the
/// model that makes its carrier so large, and the option that makes it smaller. Returns "" if there is no such type.
[[nodiscard]] std::string large_type(const System&, const Instantiation&, double most,
                                     const diagnostics::SourceManager&);

}  // namespace robochart::ir
