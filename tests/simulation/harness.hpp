// A model and a scenario as texts, read, bound, built and run, for tests.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "diagnostics/diagnostic.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"
#include "simulation/report/run.hpp"
#include "simulation/trial/controller.hpp"

namespace robochart::simulation::testing {

std::string read_file(const std::string& path);
/// Every occurrence; fails the test if there is none.
std::string replaced(std::string text, const std::string& what, const std::string& with);

/// The case studies' models, each with one thing wrong: they fail the paper's claims in every simulator.
std::vector<std::string> broken_aggregation(const std::string& model);
std::vector<std::string> broken_taxis(const std::string& model);

struct Experiment {
    Experiment(const std::string& model, const std::string& scenario, const std::string& model_path = "model.rct");

    /// Builds the controller once and runs all trials. The experiment must have no errors.
    RunResult run(unsigned threads = 2, const StageMaker& stage = embedded_stage);
    /// The codes of the findings, in order of place: "RC-M07 RC-M08".
    [[nodiscard]] std::string codes() const;
    /// The messages.
    [[nodiscard]] std::string messages() const;

    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    ir::System system;
    ir::Instantiation instantiation;
    Scenario scenario;
    cpp_emit::DriveEmission emission;
    Plan plan;
    std::unique_ptr<Controller> controller;
};

}  // namespace robochart::simulation::testing
