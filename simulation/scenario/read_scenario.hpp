// SPDX-License-Identifier: Apache-2.0
// Reads the text of a scenario (docs/scenarios.md).
#pragma once

#include <optional>

#include "base/diagnostics/diagnostic.hpp"
#include "base/diagnostics/source.hpp"
#include "base/durations/time_unit.hpp"
#include "simulation/scenario/scenario.hpp"

namespace robochart::simulation {

/// Parses a scenario and checks everything that does not need the model. Mistakes become diagnostics. A scenario
/// without `unit` has the time unit that the project declares.
[[nodiscard]] Scenario read_scenario(const diagnostics::SourceManager&, diagnostics::SourceId,
                                     diagnostics::Diagnostics&, durations::Unit declared = {});

/// Returns the world at the start of a trial, with its robots. Reports robots that do not fit.
[[nodiscard]] std::optional<World> start(const Scenario&, std::uint32_t trial, diagnostics::Diagnostics&);

/// Reports features that only the built-in world has (RC-M15). The adapters of other simulators call this function.
void refuse_beyond(const Scenario&, const char* simulator, diagnostics::Diagnostics&);

}  // namespace robochart::simulation
