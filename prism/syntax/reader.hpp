// SPDX-License-Identifier: Apache-2.0
// Parses PRISM files into trees.
#pragma once

#include <string>

#include "base/diagnostics/diagnostic.hpp"
#include "prism/syntax/syntax.hpp"

namespace robochart::prism {

/// Parses a model. If there are errors, the result contains the parts that could be parsed.
[[nodiscard]] ModelFile read_model(const diagnostics::SourceManager&, diagnostics::SourceId, diagnostics::Diagnostics&);
/// Parses a properties file in the same way.
[[nodiscard]] PropertyFile read_properties(const diagnostics::SourceManager&, diagnostics::SourceId,
                                           diagnostics::Diagnostics&);
/// Parses a single expression, such as the value of a constant on the command line. Returns null and reports findings
/// if it is malformed.
[[nodiscard]] ExprPtr read_expression(const diagnostics::SourceManager&, diagnostics::SourceId,
                                      diagnostics::Diagnostics&);

}  // namespace robochart::prism
