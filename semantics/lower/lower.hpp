// From the resolved model to the shared IR.
#pragma once

#include "diagnostics/diagnostic.hpp"
#include "diagnostics/source.hpp"
#include "frontend/syntax/ast.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::ir {

/// Lowers a model that was resolved without errors. What has no place in the IR yet is reported by name
/// (rule table semantics/rules.hpp) and left out; never silently. The sources give paths and the wording of assertions.
[[nodiscard]] System lower(const frontend::Model&, const diagnostics::SourceManager&, diagnostics::Diagnostics&);

}  // namespace robochart::ir
