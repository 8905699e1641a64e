// SPDX-License-Identifier: Apache-2.0
// Parses claims files to trees.
#pragma once

#include "base/diagnostics/diagnostic.hpp"
#include "claims/syntax/syntax.hpp"

namespace robochart::claims {

/// The claims of a text. If there are errors, the result contains the parts that could be parsed.
[[nodiscard]] ClaimFile read(const diagnostics::SourceManager&, diagnostics::SourceId, diagnostics::Diagnostics&);

}  // namespace robochart::claims
