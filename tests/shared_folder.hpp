// SPDX-License-Identifier: Apache-2.0
// Finds the read-only material next to the repository, which tests use if it is present.
#pragma once

#include <cstdlib>
#include <filesystem>

#include "tests/source_folder.hpp"

namespace robochart::tests {

/// Returns the folder that ROBOCHART_SHARED names, or `shared` next to the repository or next to the folder of its
/// worktrees. Returns an empty path if none exists.
inline std::filesystem::path shared_folder() {
    namespace fs = std::filesystem;
    const fs::path root = tests::source_folder();
    const char* named = std::getenv("ROBOCHART_SHARED");
    if (named != nullptr) return fs::is_directory(named) ? fs::path(named) : fs::path();
    for (const fs::path& folder : {root / "../shared", root / "../../shared"})
        if (fs::is_directory(folder)) return folder;
    return {};
}

}  // namespace robochart::tests
