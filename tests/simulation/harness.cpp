// SPDX-License-Identifier: Apache-2.0
#include "harness.hpp"
#include "frontend/syntax/parse.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "base/diagnostics/render.hpp"
#include "frontend/project/project.hpp"
#include "semantics/instantiate/instantiate.hpp"
#include "semantics/lower/lower.hpp"
#include "simulation/scenario/read_scenario.hpp"

namespace robochart::simulation::testing {

namespace {

/// Returns the module with this name, or the machine if there is no such module.
ir::ComponentRef component(const ir::System& system, const std::string& name) {
    ir::ComponentRef ref;
    ref.path = name.substr(name.rfind(':') == std::string::npos ? 0 : name.rfind(':') + 1);
    for (std::size_t i = 0; i < system.modules.size(); ++i)
        if (system.modules[i].name == ref.path) {
            ref.kind = ir::ComponentKind::module;
            ref.definition = static_cast<std::uint32_t>(i);
            ref.package = system.modules[i].package;
            return ref;
        }
    for (std::size_t i = 0; i < system.machines.size(); ++i)
        if (system.machines[i].name == ref.path) {
            ref.kind = ir::ComponentKind::machine;
            ref.definition = static_cast<std::uint32_t>(i);
            ref.package = system.machines[i].package;
            return ref;
        }
    ADD_FAILURE() << "no component " << name;
    return ref;
}

}  // namespace

std::string read_file(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    EXPECT_TRUE(in) << path;
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
    std::size_t at = text.find(what);
    EXPECT_NE(at, std::string::npos) << "nothing to replace: " << what;
    for (; at != std::string::npos; at = text.find(what, at + with.size())) text.replace(at, what.size(), with);
    return text;
}

std::vector<std::string> broken_aggregation(const std::string& model) {
    std::string swapped = replaced(model, "S1 to S2 trigger seeRobot", "S1 to S2 trigger swapped");
    swapped = replaced(swapped, "S2 to S1 trigger seeWall", "S2 to S1 trigger seeRobot");
    return {replaced(swapped, "trigger swapped", "trigger seeWall"),
            replaced(model, "entry RotateClockwise(-5.02)", "entry MoveClockwise(-0.75, -10.88)"),
            replaced(model, "entry MoveClockwise(-0.75, -10.88)", "entry RotateClockwise(-5.02)"),
            replaced(model, "angularSpeed = angular; linearSpeed = 0;", "angularSpeed = 0; linearSpeed = 0;")};
}

std::vector<std::string> broken_taxis(const std::string& model) {
    const std::string radii = "if illuminated then avoidanceRadius = 0.2 else avoidanceRadius = 0.1 end";
    return {replaced(model, radii, "if illuminated then avoidanceRadius = 0.1 else avoidanceRadius = 0.2 end"),
            replaced(model, radii, "if illuminated then avoidanceRadius = 0.2 else avoidanceRadius = 0.2 end"),
            replaced(model, "if illuminated then", "if false then"), replaced(model, "25", "25000")};
}

void Experiment::lower_model(const std::string& path, const std::string& text, ir::System& of,
                             ir::Instantiation& instantiated) {
    frontend::Model parsed;
    parsed.files.push_back(frontend::parse(sources, sources.add(path, text), false, diagnostics));
    frontend::resolve(parsed, diagnostics);
    of = ir::lower(parsed, sources, diagnostics);
    instantiated = ir::instantiate_system(of, {}, diagnostics);
}

cpp_emit::DriveEmission Experiment::emitted(const ir::System& of, const ir::Instantiation& instantiated,
                                            const Name& name) {
    cpp_emit::Options options;
    options.cycle_length = scenario.units_per_step;
    options.sources = &sources;
    return cpp_emit::emit_drive(of, instantiated, component(of, name.text), options, diagnostics);
}

Experiment::Experiment(const std::string& model, const std::string& text, const std::string& model_path,
                       const std::vector<std::string>& other_models) {
    lower_model(model_path, model, system, instantiation);
    scenario = read_scenario(sources, sources.add("test.scenario", text), diagnostics);
    if (!diagnostics.ok()) return;
    emission = emitted(system, instantiation, scenario.component);
    Emissions all{{&emission}, nullptr};
    for (std::size_t i = 0; i < other_models.size(); ++i) {
        Other& other = *others.emplace_back(std::make_unique<Other>());
        lower_model("other" + std::to_string(i) + ".rct", other_models[i], other.system, other.instantiation);
        const bool environment = i == scenario.others.size();
        if (environment && !scenario.environment) ADD_FAILURE() << "more models than kinds";
        other.emission = emitted(other.system, other.instantiation,
                                 environment ? scenario.environment->component : scenario.others[i].component);
        if (environment)
            all.environment = &other.emission;
        else
            all.kinds.push_back(&other.emission);
    }
    if (diagnostics.ok()) plan = bind_scenario(scenario, all, diagnostics);
}

Drives Experiment::drives() const {
    std::vector<const rc_drive*> kinds{&controller->drive()};
    for (const auto& other : others) kinds.push_back(&other->controller->drive());
    const rc_drive* environment = nullptr;
    if (scenario.environment) {
        environment = kinds.back();
        kinds.pop_back();
    }
    return {kinds, environment};
}

RunResult Experiment::run(unsigned threads, const StageMaker& stage) {
    EXPECT_TRUE(diagnostics.ok()) << messages();
    std::string error;
    if (controller == nullptr) controller = Controller::build(emission, "", error);
    EXPECT_NE(controller, nullptr) << error;
    if (controller == nullptr) return {};
    for (const auto& other : others)
        if (other->controller == nullptr) other->controller = Controller::build(other->emission, "", error);
    find_states(scenario, machines_of(scenario, drives()), diagnostics);
    RunOptions options;
    options.threads = threads;
    options.stage = stage;
    return simulation::run_trials(plan, drives(), options, diagnostics);
}

std::string Experiment::codes() const {
    std::string result;
    for (const auto& d : diagnostics.sorted_findings())
        if (!std::string(d.rule->code).starts_with("RC-W"))
            result += (result.empty() ? "" : " ") + std::string(d.rule->code);
    return result;
}

std::string Experiment::messages() const {
    return diagnostics::render_text(sources, diagnostics);
}

}  // namespace robochart::simulation::testing
