// SPDX-License-Identifier: Apache-2.0
// Parses a scenario and checks it against its component.
#include "simulation/scenario/read_scenario.hpp"

#include "simulation/scenario/scenario_reader.hpp"

namespace robochart::simulation {

Scenario read_scenario(const diagnostics::SourceManager& sources, diagnostics::SourceId source,
                       diagnostics::Diagnostics& diagnostics, durations::Unit declared) {
    return ScenarioReader(sources, source, diagnostics, declared).read();
}

}  // namespace robochart::simulation
