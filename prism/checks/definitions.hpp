// SPDX-License-Identifier: Apache-2.0
// Sorts formulas and constants, so that a definition comes after the definitions that it uses.
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "prism/checks/rewrite.hpp"
#include "prism/syntax/syntax.hpp"

namespace robochart::prism {

/// The name and the body of a definition; the body may be null.
struct Defined {
    Name name;
    ExprPtr body;
};

/// Returns the indices in sorted order. Definitions that depend on themselves are reported and omitted.
[[nodiscard]] std::vector<std::size_t> definition_order(const std::vector<Defined>& definitions,
                                                        diagnostics::Diagnostics& diagnostics);

/// Expands formulas, adds them to the rewriter's replacements, and returns them in the order of the text. Reports
/// definitions that depend on themselves or grow too large.
[[nodiscard]] std::vector<Definition> expand_formulas(const std::vector<Definition>& formulas, Rewriter& rewriter,
                                                      diagnostics::Diagnostics& diagnostics);

/// Returns whether an expression is within the size limit, and reports a finding if it is not.
bool is_manageable(const ExprPtr& expr, Span place, diagnostics::Diagnostics& diagnostics);

}  // namespace robochart::prism
