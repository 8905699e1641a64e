// SPDX-License-Identifier: Apache-2.0
// Declares the names of a model, for the type checker.
#pragma once

#include "prism/checks/checked.hpp"
#include "prism/checks/types.hpp"

namespace robochart::prism {

/// Declares the constants, variables and formulas of a model, which share one name space. Reports duplicate
/// declarations.
void declare_names(const CheckedModel& model, Scope& scope, diagnostics::Diagnostics& diagnostics);
/// Declares a constant of a model or of a properties file.
void declare_constant(const Constant& constant, Scope& scope, diagnostics::Diagnostics& diagnostics);

}  // namespace robochart::prism
