// Formulas and constants that use each other: in an order in which each comes after those that it uses.
#pragma once

#include <string>
#include <vector>

#include "checker/prism/checks/rewrite.hpp"
#include "checker/prism/syntax/syntax.hpp"
#include "diagnostics/diagnostic.hpp"

namespace robochart::prism {

/// A definition by its name; the body may be null.
struct Defined {
    Name name;
    ExprPtr body;
};

/// Indices in such an order. Each name that is defined by itself is reported, and left out.
[[nodiscard]] std::vector<std::size_t> definition_order(const std::vector<Defined>& definitions,
                                                        diagnostics::Diagnostics& diagnostics);

/// Adds the formulas, expanded, to what the rewriter replaces; returns them in the order of the text. Reports what is
/// defined by itself or grows too large.
[[nodiscard]] std::vector<Definition> expand_formulas(const std::vector<Definition>& formulas, Rewriter& rewriter,
                                                      diagnostics::Diagnostics& diagnostics);

/// Whether an expression is of a size that can be worked with; reports where it is not.
bool is_manageable(const ExprPtr& expr, Span place, diagnostics::Diagnostics& diagnostics);

}  // namespace robochart::prism
