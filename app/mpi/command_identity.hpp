// SPDX-License-Identifier: Apache-2.0
// Identifies the robochart-verify of the same build.
#pragma once

#include <string>

namespace robochart::app {

/// The build ID of the robochart-verify of the same build, which that program gets from diagnostics::program_identity;
/// "" if it has none. Both programs use the same libraries for evaluation, compilation and search, so their stored
/// states are equal.
[[nodiscard]] std::string command_identity();

}  // namespace robochart::app
