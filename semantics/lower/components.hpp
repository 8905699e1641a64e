// SPDX-License-Identifier: Apache-2.0
// Lowers controllers and modules. Private to semantics/lower*.
#pragma once

#include "semantics/lower/lowering.hpp"

namespace robochart::ir {

/// Creates the entries of all machines, operations, controllers and modules in the System, in textual order, with the
/// files in order of their paths. An inline component has its place in this order. The bodies are added later.
void register_components(Lowering&);
void lower_controller(Lowering&, const frontend::Component&, ControllerId);
void lower_module(Lowering&, const frontend::Component&, std::size_t index);
/// Reports operations that call themselves through the definitions of a controller, and required constants for which
/// callers provide different values.
void check_calls(Lowering&);

}  // namespace robochart::ir
