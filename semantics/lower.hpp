// From the resolved model to the shared IR.
#pragma once

#include "diagnostics/diagnostic.hpp"
#include "frontend/ast.hpp"
#include "semantics/ir.hpp"

namespace robochart::ir {

/// Lowers a model that was resolved without errors. What has no place in the IR yet is reported by name
/// (rule table semantics/rules.hpp) and left out; never silently.
[[nodiscard]] System lower(const frontend::Model&, diagnostics::Diagnostics&);

/// The IR as text, for `--print ir`: stable, one declaration a line, programs indented.
[[nodiscard]] std::string dump(const System&);

}  // namespace robochart::ir
