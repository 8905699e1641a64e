// SPDX-License-Identifier: Apache-2.0
// Identifies the robochart-verify of the same build.
#pragma once

#include <string>

namespace robochart::app {

/// The build ID of the robochart-verify of the same build (at run time, diagnostics::program_identity there); "" if it
/// has none. Both use the same libraries for evaluation, compilation and search, so their stored rows are equal.
[[nodiscard]] std::string command_identity();

}  // namespace robochart::app
