// Reads a scenario and checks it against the component that it is for.
#include "simulation/scenario/read_scenario.hpp"

#include "simulation/scenario/scenario_reader.hpp"

namespace robochart::simulation {

Scenario read_scenario(const diagnostics::SourceManager& sources, diagnostics::SourceId source,
                       diagnostics::Diagnostics& diagnostics) {
    return ScenarioReader(sources, source, diagnostics).read();
}

}  // namespace robochart::simulation
