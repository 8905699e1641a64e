// SPDX-License-Identifier: Apache-2.0
// Finds values that CSP blocks replace. If a block replaces a value, assertions use the new value, but the generated
// code and its conformance check use the old one.
#pragma once

#include <string>

#include "checker/cspm/syntax/syntax.hpp"
#include "driver/model/pipeline.hpp"

namespace robochart::driver {

/// Lists the constants and functions that timed blocks define differently from `without_blocks`. "RC = 0 (there 1),
/// ms(...)": RC is 1 in the blocks, and the function ms differs. Returns "" if nothing differs.
[[nodiscard]] std::string values_unlike_blocks(const Project&, const cspm::Script& without_blocks);

}  // namespace robochart::driver
