// SPDX-License-Identifier: Apache-2.0
// Loads a scenario with its model and controllers, ready to run. The verb `simulate` and the adapters of other
// simulators use this.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/command/options.hpp"
#include "base/cache/digest.hpp"
#include "driver/evidence/certificate.hpp"
#include "driver/model/pipeline.hpp"
#include "simulation/report/run.hpp"
#include "simulation/scenario/plan.hpp"
#include "simulation/trial/controller.hpp"

namespace robochart::app {

/// The model and controller of another kind of robots, or of the environment.
struct OtherController {
    std::unique_ptr<driver::Project> project;
    std::string model;  ///< its path
    cpp_emit::DriveEmission emission;
    std::unique_ptr<simulation::Controller> controller;
};

struct Simulation {
    std::unique_ptr<driver::Project> project;  ///< the model; its sources also contain the scenario
    simulation::Scenario scenario;
    cpp_emit::DriveEmission emission;
    std::vector<OtherController> others;  ///< controllers of the other kinds and of the environment
    simulation::Plan plan;                ///< refers to the scenario

    /// Returns the model of the controller with this index (see Scenario::controller_at).
    [[nodiscard]] const driver::Project& project_of(std::size_t controller) const {
        return controller == 0 ? *project : *others[controller - 1].project;
    }
    /// Returns the generated code that drives the robots of a kind (see Scenario::kind_at).
    [[nodiscard]] const cpp_emit::DriveEmission& emission_of(std::size_t kind) const {
        return kind == 0 ? emission : others[kind - 1].emission;
    }
};

/// Reads the scenario and its model and connects them. Never null; the project's diagnostics show whether the scenario
/// can run.
[[nodiscard]] std::unique_ptr<Simulation> load_simulation(const Options&);

/// Reads the scenario; its text is added to the project's sources.
[[nodiscard]] simulation::Scenario read_scenario_of(driver::Project&, const Options&);
/// Builds the controllers. Returns the controller of the first kind of robots and stores the others in the simulation.
/// On failure the result is null, and the project's diagnostics contain the reason.
[[nodiscard]] std::unique_ptr<simulation::Controller> build_controller(Simulation&, const Options&);

/// Returns all controllers, which must already be built.
[[nodiscard]] simulation::Drives drives_of(const Simulation&, const simulation::Controller&);

/// Adds to a hash everything that a trial depends on except its seed: the texts of the scenario and drawings, and the
/// generated code. The identity of the program is not added, because the cache adds it to every key.
void add_trials(const Simulation&, diagnostics::Hasher&);

/// Returns the path of the model of a controller (see Scenario::controller_at). `path` is the path of the scenario.
[[nodiscard]] std::string model_of(const simulation::Scenario&, const std::string& path, std::size_t controller);

/// Returns the settings for the model of one controller: its path, and its constants. A constant has the value that
/// `--const` gives for this controller, or else the value of the scenario (`const ...` in `robots` and `environment`).
/// The robots are simulated with these constants, so all claims about the models are decided with them.
[[nodiscard]] driver::Settings settings_for(const simulation::Scenario&, driver::Settings, std::size_t controller);
/// Returns "NAME=VALUE" for all constants that were given to the model.
[[nodiscard]] std::vector<std::string> constants_of(const driver::Project&);

/// Shows the findings about the scenario and its model, and those about the models of the other controllers.
void show_all_diagnostics(const Simulation&, const Options&);

/// These three functions add results to the evidence. All are computed with the constants of settings_for. The first
/// function adds the assertions of the scenario's models and the digests of their files. The second adds whether the
/// code of each controller conforms. The third adds the scenario's claims. It returns false if the scenario cannot be
/// run; the simulation's project then contains the reason. Results about all controllers except the first begin with
/// the controller's name: "leaders: A1". If two controllers have the same model and constants, only one is checked. All
/// three throw diagnostics::LimitReached.
void decide_assertions(const Options&, const simulation::Scenario&, driver::Evidence&);
void decide_conformance(const Options&, const simulation::Scenario&, driver::Evidence&);
[[nodiscard]] bool decide_claims(const Options&, driver::Evidence&, std::unique_ptr<Simulation>&);

/// A simulator that replaces the built-in world.
struct OtherStage {
    std::string name;  ///< "" for the built-in world
    simulation::StageMaker make;
    bool parallel = true;  ///< true if trials may run at the same time
};
Exit run_simulate(const Options&, const OtherStage&);
/// Runs a scenario that has variations.
Exit sweep(const Options&, const OtherStage&);
/// Runs a scenario that defines a chain. The simulation's project must have no errors.
Exit study_chain(Simulation&, const Options&, const OtherStage&);
/// Returns a function that returns true if trials must end because of a limit or a signal.
[[nodiscard]] std::function<bool()> when_a_limit_is_reached(const Options&);
/// Returns a function that reports the progress of trials as `--progress` selects; empty if no reports are wanted.
[[nodiscard]] std::function<void(const simulation::RunProgress&)> progress_reports(const Options&,
                                                                                   const std::string& subject);
/// Runs the program for another simulator, with the arguments of the verb `simulate`. Returns its exit code.
int simulate_program(const char* program, int argc, char** argv, const OtherStage&);

/// Writes tables and pictures of a run below the output folder. Returns the paths. Errors are reported in the project's
/// diagnostics.
[[nodiscard]] std::vector<std::string> write_simulation_files(Simulation&, const simulation::RunResult&,
                                                              const simulation::Machines&, const Options&,
                                                              std::string& notes);

}  // namespace robochart::app
