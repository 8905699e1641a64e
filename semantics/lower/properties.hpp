// SPDX-License-Identifier: Apache-2.0
// Lowers assertions and csp blocks. Private to semantics/lower*.
#pragma once

#include "semantics/lower/lowering.hpp"

namespace robochart::ir {

/// Fills System::properties and System::csp_blocks. The components must already have been lowered.
void lower_properties(Lowering&);

}  // namespace robochart::ir
