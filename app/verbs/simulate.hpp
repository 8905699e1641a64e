// A scenario with its model and controller, ready to run: what the verb `simulate` and the adapters of other simulators
// share.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/command/pipeline.hpp"
#include "app/tune/certificate.hpp"
#include "diagnostics/cache/digest.hpp"
#include "simulation/report/run.hpp"
#include "simulation/scenario/plan.hpp"
#include "simulation/trial/controller.hpp"

namespace robochart::app {

/// The model and the controller of another kind of robots, or of the environment.
struct OtherController {
    std::unique_ptr<Project> project;
    std::string model;  ///< its path
    cpp_emit::DriveEmission emission;
    std::unique_ptr<simulation::Controller> controller;
};

struct Simulation {
    std::unique_ptr<Project> project;  ///< the model; its sources hold the scenario too
    simulation::Scenario scenario;
    cpp_emit::DriveEmission emission;
    std::vector<OtherController> others;  ///< of the scenario's other kinds, and of its environment
    simulation::Plan plan;                ///< refers to the scenario

    /// The model of a controller (Scenario::controller_at).
    [[nodiscard]] const Project& project_of(std::size_t controller) const {
        return controller == 0 ? *project : *others[controller - 1].project;
    }
    /// What drives robots of a kind (Scenario::kind_at).
    [[nodiscard]] const cpp_emit::DriveEmission& emission_of(std::size_t kind) const {
        return kind == 0 ? emission : others[kind - 1].emission;
    }
};

/// Reads the scenario and its model and binds them. Never null; the project's diagnostics tell whether it can run.
[[nodiscard]] std::unique_ptr<Simulation> load_simulation(const Options&);

/// The scenario's text into the project's sources; its scenario.
[[nodiscard]] simulation::Scenario read_scenario_of(Project&, const Options&);
/// Builds the controllers: returns that of the first kind of robots, and keeps the others. On failure null, and what is
/// wrong is among the project's diagnostics.
[[nodiscard]] std::unique_ptr<simulation::Controller> build_controller(Simulation&, const Options&);

/// All of them, once built.
[[nodiscard]] simulation::Drives drives_of(const Simulation&, const simulation::Controller&);

/// Adds what a trial depends on but for its seed: the texts of scenario and drawings, and the generated code. The
/// program itself is in the cache's own keys.
void add_trials(const Simulation&, diagnostics::Hasher&);

/// The path of the model of one of a scenario's controllers (Scenario::controller_at), where the scenario has this
/// path.
[[nodiscard]] std::string model_of(const simulation::Scenario&, const std::string& path, std::size_t controller);

/// The options for the model of one controller: its path, the constants of `--const` that are its, and where these
/// leave one open those of the scenario (`const ...` in `robots` and `environment`). The robots are simulated with
/// them, so all that is said of the models is decided with them.
[[nodiscard]] Options options_for(const simulation::Scenario&, Options, std::size_t controller);
/// "NAME=VALUE" of all constants that the model was given.
[[nodiscard]] std::vector<std::string> constants_of(const Project&);

/// What was found in the scenario and its model, and what in the models of the other controllers.
void show_all_diagnostics(const Simulation&, const Options&);

/// What is decided with the constants of options_for, added to the evidence: the assertions of the scenario's models
/// and the digests of their files; whether the code of each controller conforms; the scenario's claims, of which
/// false is returned where the scenario cannot be run: the diagnostics of the simulation's project say why. In what is
/// said of other controllers than the first its name stands in front, "leaders: A1"; two with one model and the same
/// constants are decided once. Throw diagnostics::LimitReached.
void decide_assertions(const Options&, const simulation::Scenario&, Evidence&);
void decide_conformance(const Options&, const simulation::Scenario&, Evidence&);
[[nodiscard]] bool decide_claims(const Options&, Evidence&, std::unique_ptr<Simulation>&);

/// Another simulator in place of the embedded world.
struct OtherStage {
    std::string name;  ///< "" for the embedded world
    simulation::StageMaker make;
    bool parallel = true;  ///< may trials run at the same time?
};
Exit run_simulate(const Options&, const OtherStage&);
/// Of a scenario in which something varies.
Exit sweep(const Options&, const OtherStage&);
/// Of a scenario with a chain; its project has no errors so far.
Exit study_chain(Simulation&, const Options&, const OtherStage&);
/// Whether trials are to end: a limit is reached, or a signal has come.
[[nodiscard]] std::function<bool()> when_a_limit_is_reached(const Options&);
/// The progress of trials as `--progress` asks for; empty: not at all.
[[nodiscard]] std::function<void(const simulation::RunProgress&)> progress_reports(const Options&,
                                                                                   const std::string& subject);
/// The whole of a program that simulates in another simulator: its arguments are those of the verb. Returns its exit
/// code.
int simulate_program(const char* program, int argc, char** argv, const OtherStage&);

/// Tables and pictures of a run below the output folder. Returns the paths; problems are reported.
[[nodiscard]] std::vector<std::string> write_simulation_files(Simulation&, const simulation::RunResult&,
                                                              const simulation::Machines&, const Options&,
                                                              std::string& notes);

}  // namespace robochart::app
