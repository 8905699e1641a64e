// SPDX-License-Identifier: Apache-2.0
// Parses claims files to trees.
#pragma once

#include "base/diagnostics/diagnostic.hpp"
#include "claims/syntax/syntax.hpp"

namespace robochart::claims {

/// Parses only the parts of a text at these places, which are the claims in an assertion file.
[[nodiscard]] ClaimFile read_parts(const diagnostics::SourceManager&, diagnostics::SourceId,
                                   const std::vector<Span>& places, diagnostics::Diagnostics&);

/// Returns the claims of a text. If there are errors, the result contains the parts that could be parsed.
[[nodiscard]] ClaimFile read(const diagnostics::SourceManager&, diagnostics::SourceId, diagnostics::Diagnostics&);

}  // namespace robochart::claims
