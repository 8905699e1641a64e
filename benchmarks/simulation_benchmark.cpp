// SPDX-License-Identifier: Apache-2.0
// Measures the robot steps per CPU second of the embedded world and of Enki in one run, including the generated
// controller: benchmark_simulation SCENARIO. The scenario's robots are replaced by 20, 100 and 1,000 at the same
// density.
#include <fmt/format.h>

#include <algorithm>

#include "app/command/findings.hpp"
#include "app/command/run.hpp"
#include "app/verbs/simulate.hpp"
#include "benchmarks/cpu_time.hpp"
#include "benchmarks/scaled.hpp"
#include "simulation/adapters/enki/enki_stage.hpp"

namespace {

using namespace robochart;

/// Returns the maximum of three runs; 0 if the simulator cannot run.
double robot_steps_a_second(const app::Simulation& loaded, const simulation::Scenario& scenario, const rc_drive& drive,
                            const simulation::StageMaker& make) {
    double best = 0;
    for (int run = 0; run < 3; ++run) {
        diagnostics::Diagnostics diagnostics;
        const simulation::Plan plan = simulation::bind_scenario(scenario, loaded.emission, diagnostics);
        const auto stage = make(scenario, 0, diagnostics);
        if (stage == nullptr) return 0;
        simulation::TrialOptions options;
        options.record = false;
        const double begin = thread_cpu_seconds();
        const auto result = simulation::run_trial(plan, drive, *stage, options);
        best = std::max(best, static_cast<double>(result.steps) * scenario.robots / (thread_cpu_seconds() - begin));
    }
    return best;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        fmt::print(stderr, "usage: benchmark_simulation SCENARIO\n");
        return 4;
    }
    app::Options options;
    app::set_verb(options, app::Verb::simulate);
    options.load.inputs = {argv[1]};
    app::Run run(options);
    options.run = &run;
    const auto loaded = app::load_simulation(options);
    if (!app::show_diagnostics(*loaded->project, options)) return 2;
    std::string error;
    const auto controller = simulation::Controller::build(loaded->emission, "", error);
    if (controller == nullptr) {
        fmt::print(stderr, "{}\n", error);
        return 2;
    }
    fmt::print("| robots | embedded world, robot-steps/CPU s | Enki | ratio |\n| ---: | ---: | ---: | ---: |\n");
    for (const auto& [robots, seconds] : {std::pair(20U, 600.0), std::pair(100U, 120.0), std::pair(1000U, 6.0)}) {
        const auto scenario = scaled(loaded->scenario, robots, seconds);
        const double own = robot_steps_a_second(*loaded, scenario, controller->drive(), simulation::embedded_stage);
        const double enki = robot_steps_a_second(*loaded, scenario, controller->drive(), simulation::enki_stage);
        fmt::print("| {} | {:.0f} | {:.0f} | {:.1f} |\n", robots, own, enki, own / enki);
    }
    return 0;
}
