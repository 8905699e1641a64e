// A simulation as one page: what was run and what came of it, a trial to play through, the active states of each
// robot on the diagrams of its machines, the measures over time. See page.hpp for what every page keeps to.
#pragma once

#include <string>
#include <vector>

#include "app/command/pipeline.hpp"
#include "cpp_emit/simulator_api.hpp"
#include "simulation/report/pictures.hpp"
#include "simulation/report/run.hpp"

namespace robochart::app {

/// What drives a kind of robots; the diagrams are those of its model.
struct KindModel {
    Project* project = nullptr;
    const cpp_emit::DriveEmission* emission = nullptr;
};

/// What the page is about.
struct SimulationRun {
    const std::vector<KindModel>& kinds;  ///< in the scenario's order
    const simulation::Scenario& scenario;
    const simulation::Machines& machines;  ///< of all kinds of robots
    const simulation::RunResult& result;
    std::string simulator;           ///< "" for the embedded world
    std::string monitors;            ///< what they watched, in a line; "" without
    std::string notes;               ///< lines, of monitors and of files that were not made
    std::vector<std::string> files;  ///< written beside the page
};

[[nodiscard]] std::string render_simulation_html(const SimulationRun&, const Options&);

}  // namespace robochart::app
