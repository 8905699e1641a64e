// SPDX-License-Identifier: Apache-2.0
// Finds values that csp blocks replace. If there are any, the assertions use other values than the generated code and
// its comparison.
#pragma once

#include <string>

#include "checker/cspm/syntax/syntax.hpp"
#include "driver/model/pipeline.hpp"

namespace robochart::driver {

/// The constants and functions that the timed blocks define differently from these definitions, which were made without
/// blocks: "RC = 0 (there 1), ms(...)". "" if they define none differently.
[[nodiscard]] std::string values_unlike_blocks(const Project&, const cspm::Script& without_blocks);

}  // namespace robochart::driver
