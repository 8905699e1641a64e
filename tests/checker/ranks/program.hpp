// SPDX-License-Identifier: Apache-2.0
// Identifies the programs in the tests of ranks.
#pragma once

#include <string>

namespace robochart::ranks {

inline const std::string program = "a build";

}  // namespace robochart::ranks
