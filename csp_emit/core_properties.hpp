// What every model is asked about, whether or not it claims it (docs/semantics.md, "Core properties").
#pragma once

#include <vector>

#include "csp_emit/base/component.hpp"
#include "csp_emit/base/names.hpp"

namespace robochart::csp_emit {

/// The core properties of every module, controller and state machine, component by component. A component that has
/// terminated counts neither as deadlocked nor as stopping time, and the platform is taken to accept every call, output
/// and write at once. That it is free of deadlocks, divergences and timelocks, and reads no clock before it is set,
/// is required; the rest is information.
[[nodiscard]] std::vector<Obligation> core_properties(const Project&, NameManager&, Emitted&);

}  // namespace robochart::csp_emit
