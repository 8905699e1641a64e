// SPDX-License-Identifier: Apache-2.0
// Converts the text of a scenario (docs/scenarios.md).
#pragma once

#include <optional>

#include "base/diagnostics/diagnostic.hpp"
#include "base/diagnostics/source.hpp"
#include "base/durations/time_unit.hpp"
#include "simulation/scenario/scenario.hpp"

namespace robochart::simulation {

/// Parses a scenario and checks everything that does not need the model. Mistakes become diagnostics. A scenario
/// without `unit` has the declared time unit.
[[nodiscard]] Scenario read_scenario(const diagnostics::SourceManager&, diagnostics::SourceId,
                                     diagnostics::Diagnostics&, durations::Unit declared = {});

/// The robots at the start of a trial. Reports robots that do not fit.
[[nodiscard]] std::optional<World> start(const Scenario&, std::uint32_t trial, diagnostics::Diagnostics&);

/// Reports features that only the built-in world has (RC-M15); for the adapters of other simulators.
void refuse_beyond(const Scenario&, const char* simulator, diagnostics::Diagnostics&);

}  // namespace robochart::simulation
