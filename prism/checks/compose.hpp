// SPDX-License-Identifier: Apache-2.0
// Converts `system ... endsystem` to a list of synchronisations.
#pragma once

#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "prism/checks/checked.hpp"

namespace robochart::prism {

/// Lists the synchronisations of a composition. Without a composition, all modules synchronise on their common actions.
/// Reports modules that are missing, unknown or duplicated.
[[nodiscard]] std::vector<Synchronisation> compose(const std::vector<Module>& modules, const CompositionPtr& system,
                                                   diagnostics::Diagnostics& diagnostics);

}  // namespace robochart::prism
