// SPDX-License-Identifier: Apache-2.0
// Emits the CSPM module of a machine in one place of the model: separately, in a controller, or in a module.
#pragma once

#include "csp_emit/base/component.hpp"
#include "csp_emit/machine/tables/machine_context.hpp"

namespace robochart::csp_emit {

/// Emits the module and records its meaning in the provenance and the components.
[[nodiscard]] ComponentEmission machine_module(MachineContext, Emitted&);

}  // namespace robochart::csp_emit
