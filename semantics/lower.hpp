// From the resolved model to the shared IR.
#pragma once

#include "diagnostics/diagnostic.hpp"
#include "diagnostics/source.hpp"
#include "frontend/ast.hpp"
#include "semantics/ir.hpp"

namespace robochart::ir {

/// Lowers a model that was resolved without errors. What has no place in the IR yet is reported by name
/// (rule table semantics/rules.hpp) and left out; never silently. The sources give paths and the wording of assertions.
[[nodiscard]] System lower(const frontend::Model&, const diagnostics::SourceManager&, diagnostics::Diagnostics&);

/// The IR as text, for `--print ir`: stable, one declaration a line, programs indented.
[[nodiscard]] std::string dump(const System&);
/// One expression on one line, fully bracketed, with the names of the machine (may be null).
[[nodiscard]] std::string dump(const System&, const Machine*, const Expr&);

}  // namespace robochart::ir
