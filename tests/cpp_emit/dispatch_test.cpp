// SPDX-License-Identifier: Apache-2.0
// Compares the event API with the cycle API in every reachable state of a controller. To dispatch an event and then run
// a cycle without inputs must equal one cycle with the event. To call begin() and then run a cycle without inputs must
// equal a cycle without events. The test runs both strategies over all states and inputs of the compiled code.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "frontend/project/project.hpp"
#include "semantics/lower/lower.hpp"
#include "tests/cpp_emit/harness.hpp"
#include "tests/source_folder.hpp"

namespace robochart::cpp_emit::dispatch_test {
namespace {

/// The driver uses names from the unnamed namespace of the exploration interface, so both are compiled together. It
/// prints the number of compared steps.
constexpr const char* driver = R"(
#include <array>
#include <cstdio>
#include <cstring>
#include <set>
#include <string>
#include <vector>

namespace {

using Registers = std::vector<rc_register>;

/// Writes and result, as text.
std::string reported(const rc_log& log, rc_result result) {
    std::string text = std::to_string(result);
    for (std::uint32_t i = 0; i < log.count; ++i) {
        text += " " + std::to_string(log.record[i].output) + ":";
        for (std::uint32_t a = 0; a < log.record[i].count; ++a) text += std::to_string(log.record[i].argument[a]) + ",";
    }
    return text;
}

std::string bytes(const State& state) {
    return std::string(reinterpret_cast<const char*>(&state), sizeof state);
}

/// One event (none: only what needs none) without time, then a cycle without inputs in which only time passes.
std::string dispatched(State& state, std::size_t event, const Registers& registers) {
    std::array<rc_record, 64> records{};
    rc_log log{0, 0, 64, records.data(), 0, 0, {}, {}};
    Log platform(log);
    robochart::StepResult result =
        event == registers.size()
            ? core::begin(state, platform)
            : core::dispatch(state, static_cast<core::Event>(event), read_inputs(registers.data()), platform);
    const std::uint32_t writes = log.count;
    if (core::begin(state, platform) != result) std::printf("beginning again gives another result\n");
    if (DIRECT && result == robochart::StepResult::quiescent) result = core::pass(state, platform);
    if (log.count != writes) std::printf("the cycle without inputs writes\n");
    return reported(log, robochart::to_abi(result));
}

}  // namespace

int main() {
    State first{};
    std::set<std::string> known{bytes(first)};
    std::vector<std::string> open{bytes(first)};
    unsigned long compared = 0;
    const auto visit = [&](const std::string& image, std::size_t event, const Registers& registers) {
        std::string once = image;
        std::array<rc_record, 64> records{};
        rc_log log{0, 0, 64, records.data(), 0, 0, {}, {}};
        const rc_result result = step_once(&once[0], registers.data(), &log);
        if (known.size() < 20000 && known.insert(once).second) open.push_back(once);
        // Variables written from outside are no events.
        if (event < registers.size() && std::strncmp(interface.input[event].name, "set_EXT", 7) == 0) return true;
        State state;
        std::memcpy(&state, image.data(), sizeof state);
        const std::string other = dispatched(state, event, registers);
        ++compared;
        if (!DIRECT && result == RC_DEADLINE) return true;
        return other == reported(log, result) && (!DIRECT || bytes(state) == once);
    };
    while (!open.empty()) {
        const std::string image = open.back();
        open.pop_back();
        if (!visit(image, EVENTS, Registers(EVENTS))) return 1;
        for (std::size_t event = 0; event < EVENTS; ++event) {
            for (std::uint32_t value = 0; value == 0 || value < interface.input[event].values; ++value) {
                Registers registers(EVENTS);
                registers[event] = {1, value};
                if (visit(image, event, registers)) continue;
                std::printf("event %zu differs\n", event);
                return 1;
            }
        }
    }
    std::printf("%zu states, %lu compared\n", known.size(), compared);
}
)";

struct Case {
    const char* model;
    const char* component;
    bool direct;  ///< true if no program waits, so that the code is a switch or a table
};

void PrintTo(const Case& row, std::ostream* out) {
    *out << row.model << " " << row.component;
}

constexpr Case cases[] = {
    {"corpus/aggregation", "AggregationFSM", true},
    {"corpus/swarm_taxis", "SwarmTaxisFSM", false},
    {"benchmarks/models/m1.rct", "M1", true},
    {"benchmarks/models/m2.rct", "M2", true},
    {"benchmarks/models/m3.rct", "M3", true},
    {"benchmarks/models/m4.rct", "M4", true},
    {"tests/cpp_emit/models/reactions.rct", "Reactions", true},
};

class Dispatch : public ::testing::TestWithParam<std::tuple<Case, Strategy>> {};

TEST_P(Dispatch, DoesWhatACycleDoes) {
    const auto& [row, strategy] = GetParam();
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    const auto model = frontend::load_project(sources, tests::source_folder().string() + "/" + row.model, diagnostics);
    const ir::System system = ir::lower(*model, sources, diagnostics);
    ASSERT_TRUE(diagnostics.ok());
    Options options;
    options.strategy = strategy;
    const Emission code = testing::emit_ok(system, testing::component_named(system, row.component), options);
    std::string core;
    for (const OutputFile& file : code.files)
        if (file.path == std::string(row.component) + "_core.hpp") core = file.text;
    const bool table = core.find("static constexpr std::uint8_t cases[") != std::string::npos;
    EXPECT_EQ(table, row.direct && strategy == Strategy::table);
    EXPECT_EQ(core.find("const Inputs<Types> values = inputs_;") == std::string::npos, row.direct);
    const testing::Folder folder;
    folder.write(code);
    std::ofstream(folder.path() + "/driver.cpp") << "#include \"" << code.shim << "\"\n#define DIRECT " << row.direct
                                                 << "\nconstexpr std::size_t EVENTS = sizeof inputs / sizeof *inputs;\n"
                                                 << driver;
    const std::string output = folder.run(
        "${CXX:-c++} -std=c++17 -O1 -Wall -Wextra -Wpedantic -Wconversion -Werror -fno-exceptions -fno-rtti -I. -o "
        "driver driver.cpp && ./driver");
    EXPECT_NE(output.find("compared"), std::string::npos) << output;
    EXPECT_EQ(output.find("writes"), std::string::npos) << output;
}

INSTANTIATE_TEST_SUITE_P(BothWays, Dispatch,
                         ::testing::Combine(::testing::ValuesIn(cases),
                                            ::testing::Values(Strategy::nested_switch, Strategy::table)),
                         [](const auto& instance) {
                             const bool table = std::get<1>(instance.param) == Strategy::table;
                             return std::get<0>(instance.param).component + std::string(table ? "_table" : "_switch");
                         });

/// Code that asks its platform asks it in both APIs. Here `dispatch` runs as a cycle, so the strategy has no effect.
/// tests/conformance/check/dispatch_equivalence_test.cpp compares both APIs for every answer.
TEST(Strategies, CodeThatAsksRunsAsInACycle) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    const auto model = frontend::load_project(
        sources, tests::source_folder().string() + "/tests/conformance/models/reacts", diagnostics);
    const ir::System system = ir::lower(*model, sources, diagnostics);
    for (const bool choices : {false, true}) {
        Options options;
        options.strategy = Strategy::table;
        options.choices = choices;
        const Emission code = testing::emit_ok(system, testing::component_named(system, "Reacts"), options);
        for (const OutputFile& file : code.files) {
            if (file.path != "Reacts_core.hpp") continue;
            EXPECT_EQ(file.text.find(" cases[") == std::string::npos, choices);
            EXPECT_EQ(file.text.find("const Inputs<Types> values = inputs_;") != std::string::npos, choices);
        }
    }
}

/// The generator uses a table if the machine has at least five stable points.
TEST(Strategies, TheStrategyFollowsTheSize) {
    for (const auto& [name, table] : {std::pair("m2", false), std::pair("m4", true)}) {
        diagnostics::SourceManager sources;
        diagnostics::Diagnostics diagnostics;
        const auto model = frontend::load_project(
            sources, tests::source_folder().string() + "/benchmarks/models/" + name + ".rct", diagnostics);
        const ir::System system = ir::lower(*model, sources, diagnostics);
        const std::string machine = name == std::string("m2") ? "M2" : "M4";
        const Emission code = testing::emit_ok(system, testing::component_named(system, machine));
        for (const OutputFile& file : code.files) {
            if (file.path != machine + "_core.hpp") continue;
            EXPECT_EQ(file.text.find(" cases[") != std::string::npos, table) << name;
        }
    }
}

}  // namespace
}  // namespace robochart::cpp_emit::dispatch_test
