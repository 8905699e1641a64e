// SPDX-License-Identifier: Apache-2.0
// The scope of a model.
#pragma once

#include "prism/checks/checked.hpp"
#include "prism/checks/types.hpp"

namespace robochart::prism {

/// Constants, variables and formulas share one name space; duplicate declarations are reported.
void declare_names(const CheckedModel& model, Scope& scope, diagnostics::Diagnostics& diagnostics);
/// A constant of a model or of a properties file.
void declare_constant(const Constant& constant, Scope& scope, diagnostics::Diagnostics& diagnostics);

}  // namespace robochart::prism
