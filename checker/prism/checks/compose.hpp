// Which commands act together: `system ... endsystem` as a list of synchronisations.
#pragma once

#include <vector>

#include "checker/prism/checks/checked.hpp"
#include "diagnostics/diagnostic.hpp"

namespace robochart::prism {

/// Without a composition all modules act together on the actions that their texts have in common. Modules that are
/// missing, unknown or there twice are reported.
[[nodiscard]] std::vector<Synchronisation> compose(const std::vector<Module>& modules, const CompositionPtr& system,
                                                   diagnostics::Diagnostics& diagnostics);

}  // namespace robochart::prism
