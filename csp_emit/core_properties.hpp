// SPDX-License-Identifier: Apache-2.0
// The properties that are checked for every model, even if it does not claim them (docs/semantics.md, "Core
// properties").
#pragma once

#include <vector>

#include "csp_emit/base/component.hpp"
#include "csp_emit/base/names.hpp"

namespace robochart::csp_emit {

/// The core properties of every module, controller and state machine, component by component. A component that has
/// terminated counts neither as deadlocked nor as stopping time, and the platform is assumed to accept every call,
/// output and write at once. Required properties: freedom from deadlocks, divergences and timelocks, and no read of a
/// clock before it is set. The others are information.
[[nodiscard]] std::vector<Obligation> core_properties(const Project&, NameManager&, Emitted&);

}  // namespace robochart::csp_emit
