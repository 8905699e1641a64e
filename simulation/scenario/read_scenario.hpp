// From the text of a scenario to the scenario (docs/scenarios.md).
#pragma once

#include <optional>

#include "diagnostics/diagnostic.hpp"
#include "diagnostics/source.hpp"
#include "simulation/scenario/scenario.hpp"

namespace robochart::simulation {

/// Reads a scenario and checks everything that needs no model. Wrong text becomes diagnostics.
[[nodiscard]] Scenario read_scenario(const diagnostics::SourceManager&, diagnostics::SourceId,
                                     diagnostics::Diagnostics&);

/// The robots at the start of a trial; reports those that do not fit.
[[nodiscard]] std::optional<World> start(const Scenario&, std::uint32_t trial, diagnostics::Diagnostics&);

/// Reports what only the embedded world has (RC-M15); for the adapters of other simulators.
void refuse_beyond(const Scenario&, const char* simulator, diagnostics::Diagnostics&);

}  // namespace robochart::simulation
