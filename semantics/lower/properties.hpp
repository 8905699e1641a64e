// Assertions and csp blocks. Private to semantics/lower*.
#pragma once

#include "semantics/lower/lowering.hpp"

namespace robochart::ir {

/// Fills System::properties and System::csp_blocks; components must be there.
void lower_properties(Lowering&);

}  // namespace robochart::ir
