// SPDX-License-Identifier: Apache-2.0
// Parses, binds, builds and runs models and scenarios that are given as texts.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"
#include "simulation/report/run.hpp"
#include "simulation/trial/controller.hpp"

namespace robochart::simulation::testing {

std::string read_file(const std::string& path);
/// Replaces every occurrence. Fails the test if there is none.
std::string replaced(std::string text, const std::string& what, const std::string& with);

/// Return variants of a case study's model with one fault each. They violate the paper's claims in every simulator.
std::vector<std::string> broken_aggregation(const std::string& model);
std::vector<std::string> broken_taxis(const std::string& model);

struct Experiment {
    /// `others` are the models of the scenario's other kinds of robots and of its environment.
    Experiment(const std::string& model, const std::string& scenario, const std::string& model_path = "model.rct",
               const std::vector<std::string>& others = {});

    /// Builds the controller once and runs all trials. The experiment must have no errors.
    RunResult run(unsigned threads = 2, const StageMaker& stage = embedded_stage);
    /// Returns the codes of the findings, in order of place: "RC-M07 RC-M08".
    [[nodiscard]] std::string codes() const;
    /// Returns the messages of the findings.
    [[nodiscard]] std::string messages() const;

    /// Returns the loaded controllers.
    [[nodiscard]] Drives drives() const;

    /// The model of another kind of robots, or of the environment.
    struct Other {
        ir::System system;
        ir::Instantiation instantiation;
        cpp_emit::DriveEmission emission;
        std::unique_ptr<Controller> controller;
    };

    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    std::vector<std::unique_ptr<Other>> others;
    ir::System system;
    ir::Instantiation instantiation;
    Scenario scenario;
    cpp_emit::DriveEmission emission;
    Plan plan;
    std::unique_ptr<Controller> controller;

private:
    void lower_model(const std::string& path, const std::string& text, ir::System& system,
                     ir::Instantiation& instantiation);
    cpp_emit::DriveEmission emitted(const ir::System& system, const ir::Instantiation& instantiation,
                                    const Name& component);
};

}  // namespace robochart::simulation::testing
