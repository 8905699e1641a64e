// SPDX-License-Identifier: Apache-2.0
// The folder of the sources that tests read: models, fixtures, pages.
#pragma once

#include <filesystem>

namespace robochart::tests {

/// The root of the source tree, as an absolute path.
[[nodiscard]] std::filesystem::path source_folder();

}  // namespace robochart::tests
