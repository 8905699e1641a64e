// SPDX-License-Identifier: Apache-2.0
// Writes the properties that are checked for every model, even if it does not claim them (docs/semantics.md, "Core
// properties").
#pragma once

#include <vector>

#include "csp_emit/base/component.hpp"
#include "csp_emit/base/names.hpp"

namespace robochart::csp_emit {

/// Returns the core properties of every module, controller and state machine, component by component. The required
/// properties are that the component has no deadlock, divergence or timelock, and that no clock is read before it is
/// set. The other properties are informative. A terminated component counts neither as a deadlock nor as a timelock.
/// The platform is assumed to accept every call, output and write at once.
[[nodiscard]] std::vector<Obligation> core_properties(const Project&, NameManager&, Emitted&);

}  // namespace robochart::csp_emit
