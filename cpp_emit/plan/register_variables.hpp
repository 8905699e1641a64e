// SPDX-License-Identifier: Apache-2.0
// Connects the variables in the contexts of RoboSim machines to the variables of their controllers and platforms
// (docs/robosim.md, "Controllers and modules": "variables of the composition").
#pragma once

#include "base/diagnostics/diagnostic.hpp"
#include "cpp_emit/plan/component.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::cpp_emit {

/// Adds the registers of the composition's variables to Component::variables, and sets StoredVariable::memory, ::once,
/// ::copy and ::local of the machines' variables. `contexts` contains the controller of each part.
/// Preconditions: the component is a controller or module of RoboSim, and the variables of its machines are collected.
void connect_variables(Component&, const ir::System&, const ir::Instantiation&, const ir::Module*,
                       const std::vector<const ir::Controller*>& contexts, diagnostics::Diagnostics&);

}  // namespace robochart::cpp_emit
