// SPDX-License-Identifier: Apache-2.0
// Returns the folder of the sources that tests read (models, fixtures, pages), and the path of the command that they
// run.
#pragma once

#include <filesystem>

namespace robochart::tests {

/// Returns the root of the source tree, as an absolute path.
[[nodiscard]] std::filesystem::path source_folder();

/// Returns the absolute path of the built command, `robochart-verify`. A test that runs it depends on its target.
[[nodiscard]] const char* command_path();

}  // namespace robochart::tests
