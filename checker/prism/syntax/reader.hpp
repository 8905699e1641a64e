// PRISM files read into trees.
#pragma once

#include <string>

#include "checker/prism/syntax/syntax.hpp"
#include "diagnostics/diagnostic.hpp"

namespace robochart::prism {

/// A model. Where findings are errors, what could be read is there.
[[nodiscard]] ModelFile read_model(const diagnostics::SourceManager&, diagnostics::SourceId, diagnostics::Diagnostics&);
/// A properties file.
[[nodiscard]] PropertyFile read_properties(const diagnostics::SourceManager&, diagnostics::SourceId,
                                           diagnostics::Diagnostics&);
/// An expression alone, as a constant's value on the command line; null, with findings, where it is none.
[[nodiscard]] ExprPtr read_expression(const diagnostics::SourceManager&, diagnostics::SourceId,
                                      diagnostics::Diagnostics&);

}  // namespace robochart::prism
