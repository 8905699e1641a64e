// SPDX-License-Identifier: Apache-2.0
// Converts the resolved model to the shared IR.
#pragma once

#include "base/diagnostics/diagnostic.hpp"
#include "base/diagnostics/source.hpp"
#include "frontend/syntax/ast.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::ir {

/// Lowers a model that was resolved without errors. A construct that the IR cannot represent is reported
/// (semantics/rules.hpp) and omitted. The sources provide paths and the text of assertions.
[[nodiscard]] System lower(const frontend::Model&, const diagnostics::SourceManager&, diagnostics::Diagnostics&);

/// Removes the components of RoboSim, for a command that handles only RoboChart (RC-S26). It is an error if no
/// components of RoboChart remain. `elsewhere` is true if other systems of the command have some.
void leave_out_robosim(System&, diagnostics::Diagnostics&, bool elsewhere);

}  // namespace robochart::ir
