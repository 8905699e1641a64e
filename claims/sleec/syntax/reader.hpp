// SPDX-License-Identifier: Apache-2.0
// Parses SLEEC files to trees.
#pragma once

#include "base/diagnostics/diagnostic.hpp"
#include "claims/sleec/syntax/syntax.hpp"

namespace robochart::sleec {

/// Returns the rules of a text. If there are errors, the result contains the parts that could be parsed.
[[nodiscard]] RuleFile read(const diagnostics::SourceManager&, diagnostics::SourceId, diagnostics::Diagnostics&);

}  // namespace robochart::sleec
