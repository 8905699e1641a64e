// SPDX-License-Identifier: Apache-2.0
// Writes the properties that are checked for every model, also without a claim (docs/semantics.md, "Core
// properties").
#pragma once

#include <vector>

#include "csp_emit/base/component.hpp"
#include "csp_emit/base/names.hpp"

namespace robochart::csp_emit {

/// Returns the core properties of every module, controller and state machine, one component after the other. Required:
/// the component has no deadlock, divergence or timelock, and reads no clock before it is set. All other properties are
/// informative. A component that has terminated counts neither as a deadlock nor as a timelock. Assumption: the
/// platform accepts every call, output and write at once.
[[nodiscard]] std::vector<Obligation> core_properties(const Project&, NameManager&, Emitted&);

}  // namespace robochart::csp_emit
