// SPDX-License-Identifier: Apache-2.0
// Parses PRISM files into trees.
#pragma once

#include <string>

#include "prism/syntax/syntax.hpp"
#include "base/diagnostics/diagnostic.hpp"

namespace robochart::prism {

/// A model. If there are errors, the result contains the parts that could be parsed.
[[nodiscard]] ModelFile read_model(const diagnostics::SourceManager&, diagnostics::SourceId, diagnostics::Diagnostics&);
/// A properties file.
[[nodiscard]] PropertyFile read_properties(const diagnostics::SourceManager&, diagnostics::SourceId,
                                           diagnostics::Diagnostics&);
/// A single expression, such as a constant's value on the command line; null, with findings, if it is malformed.
[[nodiscard]] ExprPtr read_expression(const diagnostics::SourceManager&, diagnostics::SourceId,
                                      diagnostics::Diagnostics&);

}  // namespace robochart::prism
