// SPDX-License-Identifier: Apache-2.0
// Moves the claims of an assertion file into the claims file in the same folder, because RoboTool rejects assertion
// files with claims (docs/claims.md).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "frontend/syntax/ast.hpp"

namespace robochart::frontend {

struct MovedClaims {
    std::string path;                         ///< the claims file: NAME.claims for NAME.assertions
    std::string text;                         ///< imports and claims, to be added at the end of the claims file
    std::vector<diagnostics::Span> removals;  ///< the parts to remove from the assertion file, in textual order
};

/// Returns the changes of both files, or no value if the file has no claims.
[[nodiscard]] std::optional<MovedClaims> move_claims(const File&, const diagnostics::SourceManager&);

/// True if the part belongs in a claims file.
[[nodiscard]] bool is_claim(const KeptPart&);

}  // namespace robochart::frontend
