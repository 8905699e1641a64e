// SPDX-License-Identifier: Apache-2.0
// The commit from which the program was built. scripts/cmake/commit.cmake writes the definition in every build.
#pragma once

#include <string>

#include "base/diagnostics/json.hpp"

namespace robochart::app {

/// A commit of the repository.
struct Commit {
    std::string id;         ///< 40 hexadecimal digits; "" if it is unknown
    bool modified = false;  ///< tracked files differed from the commit
};

/// The commit of this build. It is unknown if the sources are neither a git checkout nor an archive written by `git
/// archive`.
[[nodiscard]] Commit built_commit();
/// "commit 0123456789ab", "commit 0123456789ab with local changes", "unknown commit".
[[nodiscard]] std::string commit_text(const Commit&);
/// The program in reports: name, version and commit.
[[nodiscard]] diagnostics::Json program_json(const std::string& version, const Commit&);

}  // namespace robochart::app
