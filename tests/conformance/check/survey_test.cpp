// SPDX-License-Identifier: Apache-2.0
// Tests that the code of every component of the available models is generated, compiles and conforms. The table below
// lists the exceptions with the reason: components that are not schedulable, not generated, or not yet decided. A row
// that is no longer true fails the test.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <set>

#include "conformance/check/conform.hpp"
#include "conformance/code/shared_object.hpp"
#include "frontend/project/project.hpp"
#include "semantics/instantiate/instantiate.hpp"
#include "semantics/lower/lower.hpp"
#include "tests/source_folder.hpp"

namespace robochart::conformance {
namespace {

namespace fs = std::filesystem;

struct Exception {
    const char* component;  ///< folder or file of the model, and the component
    Outcome outcome;
    const char* why;  ///< occurs in the reason or in a diagnostic's code
};

constexpr Exception exceptions[] = {
    // These loops take no time, so no control cycle exists. Most of them repeat an output indefinitely. The platform
    // always accepts its calls, and only a register that accepts one output per cycle would stop the loop.
    {"example7.rct/contrl", Outcome::not_schedulable, "infinitely many steps"},
    {"example3.rct/stm4", Outcome::not_schedulable, "infinitely many steps"},
    {"AlphaAlgorithm/Communication", Outcome::not_schedulable, "infinitely many steps"},
    {"AlphaAlgorithm/CommunicationC", Outcome::not_schedulable, "infinitely many steps"},
    {"AlphaAlgorithm/AggregationSoftware", Outcome::not_schedulable, "infinitely many steps"},
    {"hvc/Watchdog", Outcome::not_schedulable, "infinitely many steps"},
    {"hvc/State_machine", Outcome::not_schedulable, "infinitely many steps"},
    // Only a csp block defines the function `ms` of these models. With the default of `ms`, waits take no time, so the
    // machine waits for an input with a deadline of 0 repeatedly in one cycle.
    {"hvc/mod_sys", Outcome::not_schedulable, "neither go on"},
    {"hvc/ctrl0", Outcome::not_schedulable, "neither go on"},
    {"hvc/ctrl1", Outcome::not_schedulable, "neither go on"},
};

/// These models are rejected or have no semantics.
const std::set<std::string> not_lowered = {"example9_empty_stm.rct"};

std::string shared_folder() {
    const char* given = std::getenv("ROBOCHART_SHARED");
    return given != nullptr ? given : tests::source_folder().string() + "/../shared";
}

/// Returns a setting of tests/long.sh survey, the compiler or additional flags, or `otherwise`.
std::string from_environment(const char* name, const char* otherwise) {
    const char* given = std::getenv(name);
    return given != nullptr ? given : otherwise;
}

std::string compiler() {
    return from_environment("ROBOCHART_COMPILER", "c++");
}

std::string flags() {
    return "-std=c++17 -O0 -fno-exceptions -fno-rtti -Wall -Wextra -Wpedantic -Wconversion -Werror " +
           from_environment("ROBOCHART_FLAGS", "");
}

std::chrono::seconds seconds() {
    return std::chrono::seconds(std::stoi(from_environment("ROBOCHART_SURVEY_SECONDS", "20")));
}

class Survey : public ::testing::Test {
protected:
    void survey_project(const std::string& path) {
        diagnostics::SourceManager sources;
        diagnostics::Diagnostics diagnostics;
        const std::string name = fs::path(path).filename().string();
        const auto model = frontend::load_project(sources, path, diagnostics);
        ir::System system;
        if (diagnostics.ok()) system = ir::lower(*model, sources, diagnostics);
        EXPECT_EQ(diagnostics.ok(), not_lowered.count(name) == 0) << path;
        if (!diagnostics.ok()) return;
        ir::InstantiationOptions values;
        if (name == "robotool-csp-2026") values.constants["av"] = "1";  // a constant without a value, used as a divisor
        const ir::Instantiation instantiation = ir::instantiate_system(system, values, diagnostics);
        const auto survey_all = [&](const auto& items, ir::ComponentKind kind, const auto& included) {
            for (std::uint32_t i = 0; i < items.size(); ++i)
                if (included(items[i]))
                    survey_component(system, instantiation, {kind, items[i].name, items[i].package, i}, name, sources);
        };
        const auto all = [](const auto&) { return true; };
        survey_all(system.modules, ir::ComponentKind::module, all);
        // nested components are checked as parts of their enclosing components
        survey_all(system.controllers, ir::ComponentKind::controller, [](const auto& c) { return c.path == c.name; });
        survey_all(system.machines, ir::ComponentKind::machine, [](const ir::Machine& machine) {
            return machine.kind == ir::MachineKind::state_machine && machine.path == machine.name;
        });
    }

    void survey_component(const ir::System& system, const ir::Instantiation& instantiation, const ir::ComponentRef& ref,
                          const std::string& model, diagnostics::SourceManager& sources) {
        const bool large = model == "hvc" || model == "swarm_taxis";
        if (large && std::getenv("ROBOCHART_SURVEY_SECONDS") == nullptr)
            return compile_only(system, instantiation, ref, model + "/" + ref.path);
        diagnostics::Diagnostics found;
        Options options;
        options.flags = flags();
        options.compiler = compiler();
        options.limits.max_states = 30'000'000;
        options.limits.deadline = std::chrono::steady_clock::now() + seconds();
        const Result result = conform(system, instantiation, ref, options, sources, found);
        std::string report = result.reason;
        for (const auto& finding : found.sorted_findings())
            report += fmt::format(" {} {}", finding.rule->code, finding.message());
        judge_result(model + "/" + ref.path, result, report);
    }

    /// Only generates and compiles the code of the industrial controller and of the larger case study, because they are
    /// too expensive to check in every run. tests/long.sh survey checks all of their components.
    void compile_only(const ir::System& system, const ir::Instantiation& instantiation, const ir::ComponentRef& ref,
                      const std::string& name) {
        diagnostics::Diagnostics found;
        const cpp_emit::Emission code = cpp_emit::emit(system, instantiation, ref, {}, found);
        ASSERT_FALSE(code.shim.empty()) << ref.path;
        std::string error;
        const auto object = SharedObject::build(code.files, {code.shim}, {compiler(), flags(), ""}, error);
        EXPECT_TRUE(object) << error;
        ++compiled_;
        seen_.insert(name);
    }

    void judge_result(const std::string& name, const Result& result, const std::string& report) {
        ++components_;
        const auto row = std::find_if(std::begin(exceptions), std::end(exceptions),
                                      [&](const Exception& exception) { return exception.component == name; });
        const bool excepted = row != std::end(exceptions);
        if (excepted) seen_.insert(name);
        const Outcome expected = excepted ? row->outcome : Outcome::conforms;
        EXPECT_EQ(result.outcome, expected) << name << ": " << report.substr(0, 2000);
        const bool reported = !excepted || report.find(row->why) != std::string::npos;
        EXPECT_TRUE(reported) << name << ": " << report.substr(0, 2000);
        if (result.outcome != Outcome::conforms) return;
        ++conforming_;
        in_registers_ += result.register_cycles && result.register_cycles->holds ? 1U : 0U;
        may_miss_ += result.deadlines && !result.deadlines->holds ? 1U : 0U;
    }

    std::size_t components_ = 0;
    std::size_t compiled_ = 0;
    std::size_t conforming_ = 0;
    std::size_t in_registers_ = 0;
    std::size_t may_miss_ = 0;
    std::set<std::string> seen_;
};

TEST_F(Survey, EveryComponentConformsButTheExceptions) {
    const std::string shared = shared_folder();
    if (!fs::exists(shared)) GTEST_SKIP() << "no ../shared here: its models are not part of the project";
    std::vector<std::string> projects{shared + "/bench/hvc"};
    for (const char* folder : {"/suite/robotool/accept", "/suite/robotool-csp/models"})
        for (const auto& entry : fs::directory_iterator(shared + folder))
            if (entry.is_directory() || entry.path().extension() == ".rct") projects.push_back(entry.path().string());
    projects.push_back(shared + "/suite/robotool-csp-2026");
    for (const char* folder : {"aggregation", "swarm_taxis"})
        projects.push_back(tests::source_folder().string() + "/corpus/" + folder);
    std::ranges::sort(projects);
    const char* const only = std::getenv("ROBOCHART_SURVEY");
    for (const std::string& path : projects)
        if (only == nullptr || fs::path(path).filename() == only) survey_project(path);
    fmt::print("{} components, {} conform ({:.0f} %; {} in register cycles, {} may miss a deadline); {} more compile\n",
               components_, conforming_, 100.0 * static_cast<double>(conforming_) / static_cast<double>(components_),
               in_registers_, may_miss_, compiled_);
    if (only != nullptr) return;
    EXPECT_GE(10 * conforming_, 9 * components_);
    for (const Exception& exception : exceptions)
        EXPECT_TRUE(seen_.count(exception.component) != 0) << exception.component << " is not there";
}

}  // namespace
}  // namespace robochart::conformance
