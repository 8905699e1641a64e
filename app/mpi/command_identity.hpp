// SPDX-License-Identifier: Apache-2.0
// Identifies the robochart-verify of the same build.
#pragma once

#include <string>

namespace robochart::app {

/// Returns the build ID of robochart-verify from the same build; "" if it has none. It is the value of
/// diagnostics::program_identity in robochart-verify. Both programs use the same libraries for evaluation, compilation
/// and search, so their stored states are equal.
[[nodiscard]] std::string command_identity();

}  // namespace robochart::app
