// SPDX-License-Identifier: Apache-2.0
// Renders a simulation as one page. It shows the scenario and its results, a replay of a trial, the active states of
// each robot on the diagrams of its machines, and the measures over time. page.hpp describes the common properties of
// all pages.
#pragma once

#include <string>
#include <vector>

#include "app/command/options.hpp"
#include "cpp_emit/simulator_api.hpp"
#include "driver/model/pipeline.hpp"
#include "simulation/report/pictures.hpp"
#include "simulation/report/run.hpp"

namespace robochart::app {

/// The model that drives a kind of robots. Its diagrams are shown.
struct KindModel {
    driver::Project* project = nullptr;
    const cpp_emit::DriveEmission* emission = nullptr;
};

/// The contents of the page.
struct SimulationRun {
    const std::vector<KindModel>& kinds;  ///< in the order of the scenario
    const simulation::Scenario& scenario;
    const simulation::Machines& machines;  ///< the machines of all kinds of robots
    const simulation::RunResult& result;
    std::string simulator;           ///< "" for the built-in world
    std::string monitors;            ///< one line about what the monitors observed; "" without monitors
    std::string notes;               ///< lines about monitors and about files that were not written
    std::vector<std::string> files;  ///< files written together with the page
};

[[nodiscard]] std::string render_simulation_html(const SimulationRun&, const Options&);

}  // namespace robochart::app
