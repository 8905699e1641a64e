// SPDX-License-Identifier: Apache-2.0
// Computes the limits of a whole run.
#pragma once

#include <cstdint>

#include "base/diagnostics/budget.hpp"
#include "driver/settings/settings.hpp"

namespace robochart::driver {

/// Returns 16 GiB, or three quarters of the memory of the machine or its control group, whichever is less.
[[nodiscard]] std::uint64_t default_memory();

/// Returns the limits of a run that starts at the time of the call.
[[nodiscard]] diagnostics::Limits run_limits(const LimitSettings&);

}  // namespace robochart::driver
