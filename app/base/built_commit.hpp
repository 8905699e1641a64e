// SPDX-License-Identifier: Apache-2.0
// Declares the commit from which the program was built. scripts/cmake/commit.cmake generates the definition in every
// build.
#pragma once

#include <string>

#include "base/diagnostics/json.hpp"

namespace robochart::app {

/// A commit of the repository.
struct Commit {
    std::string id;         ///< 40 hexadecimal digits; "" if it is unknown
    bool modified = false;  ///< true if tracked files differed from the commit
};

/// Returns the commit of this build. It is unknown if the sources are neither a git checkout nor an archive made by
/// `git archive`.
[[nodiscard]] Commit built_commit();
/// Returns "commit 0123456789ab", "commit 0123456789ab with local changes" or "unknown commit".
[[nodiscard]] std::string commit_text(const Commit&);
/// Describes the program in reports: name, version and commit.
[[nodiscard]] diagnostics::Json program_json(const std::string& version, const Commit&);

}  // namespace robochart::app
