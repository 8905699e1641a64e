// SPDX-License-Identifier: Apache-2.0
// Returns the folder of the sources that tests read: models, fixtures, pages.
#pragma once

#include <filesystem>

namespace robochart::tests {

/// Returns the root of the source tree, as an absolute path.
[[nodiscard]] std::filesystem::path source_folder();

}  // namespace robochart::tests
