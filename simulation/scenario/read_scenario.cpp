// SPDX-License-Identifier: Apache-2.0
// Implements read_scenario.hpp: parses a scenario.
#include "simulation/scenario/read_scenario.hpp"

#include "simulation/scenario/scenario_reader.hpp"

namespace robochart::simulation {

Scenario read_scenario(const diagnostics::SourceManager& sources, diagnostics::SourceId source,
                       diagnostics::Diagnostics& diagnostics, durations::Unit declared) {
    return ScenarioReader(sources, source, diagnostics, declared).read();
}

}  // namespace robochart::simulation
