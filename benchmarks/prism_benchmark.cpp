// SPDX-License-Identifier: Apache-2.0
// Measures the exploration of PRISM models: benchmark_prism [MODEL.prism [CONSTANTS]]. Prints states per second, bytes
// per state beyond the matrix, and steps per second of random paths. The models are a chain whose modules act
// independently, a decision process whose modules synchronise, and a given model. The recorded figures of other
// checkers are below.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cstdlib>
#include <exception>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>

#include "base/diagnostics/budget.hpp"
#include "prism/checks/check.hpp"
#include "prism/explore/state_space.hpp"
#include "prism/session/experiment.hpp"
#include "prism/session/simulation.hpp"
#include "prism/syntax/reader.hpp"

namespace {

using namespace robochart;

/// Returns a model of counters that count to 9. Each step keeps the value with probability one half. The model has
/// 10^counters states.
std::string counters(int count) {
    std::string text = "dtmc\n";
    for (int i = 0; i < count; ++i) {
        const std::string x = "x" + std::to_string(i);
        text += "module M" + std::to_string(i) + " " + x + ":[0..9]; [] " + x + "<9 -> 0.5:(" + x + "'=" + x +
                "+1) + 0.5:true; [] " + x + "=9 -> true; endmodule\n";
    }
    return text;
}

/// Returns a model with a ring of parts. Neighbours move together, or one of them moves back. The model has 4^parts
/// states.
std::string ring(int parts) {
    std::string text = "mdp\n";
    for (int i = 0; i < parts; ++i) {
        const std::string x = "x" + std::to_string(i);
        const std::string left = "[a" + std::to_string(i) + "] ";
        const std::string right = "[a" + std::to_string((i + 1) % parts) + "] ";
        text += "module M" + std::to_string(i) + " " + x + ":[0..3]; " + left + x + "<3 -> 0.9:(" + x + "'=" + x +
                "+1) + 0.1:true; " + right + x + ">0 -> (" + x + "'=" + x + "-1); [] true -> (" + x + "'=mod(" + x +
                "+1,4)); endmodule\n";
    }
    return text;
}

std::optional<prism::CheckedModel> checked(const std::string& text) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    const prism::ModelFile file = prism::read_model(sources, sources.add("model", text), diagnostics);
    return prism::check_model(file, diagnostics);
}

/// Returns the additional memory of the process per state while a state space exists, without its matrix (targets,
/// numbers, rows).
double bytes_beyond_matrix(const prism::CheckedModel& model, const prism::Values& constants) {
    diagnostics::Diagnostics diagnostics;
    const std::uint64_t before = diagnostics::resident_bytes();
    const prism::StateSpace space(model, constants, {}, diagnostics);
    const markov::Model& chain = space.chain();
    const std::size_t matrix = chain.target.size() * (sizeof chain.target[0] + sizeof chain.number[0]) +
                               chain.choices() * (sizeof chain.first_branch[0] + sizeof(std::uint32_t)) +
                               chain.states() * sizeof chain.first_choice[0];
    return (static_cast<double>(diagnostics::resident_bytes()) - static_cast<double>(before + matrix)) /
           static_cast<double>(chain.states());
}

void explore(benchmark::State& state, const prism::CheckedModel& model, const prism::Values& constants) {
    state.counters["bytes/state"] = bytes_beyond_matrix(model, constants);
    diagnostics::Diagnostics diagnostics;
    std::size_t states = 0;
    std::uint64_t transitions = 0;
    for (auto unused : state) {
        const prism::StateSpace space(model, constants, {}, diagnostics);
        states = space.chain().states();
        transitions = space.transitions();
    }
    const auto rate = [](auto count) {
        return benchmark::Counter(static_cast<double>(count), benchmark::Counter::kIsIterationInvariantRate);
    };
    state.counters["states"] = static_cast<double>(states);
    state.counters["states/s"] = rate(states);
    state.counters["transitions/s"] = rate(transitions);
}

void explore(benchmark::State& state, const std::string& text) {
    const std::optional<prism::CheckedModel> model = checked(text);
    explore(state, *model, {});
}

void independent_counters(benchmark::State& state) {
    explore(state, counters(static_cast<int>(state.range(0))));
}
BENCHMARK(independent_counters)->Arg(4)->Arg(6)->Unit(benchmark::kMillisecond);

void synchronised_ring(benchmark::State& state) {
    explore(state, ring(static_cast<int>(state.range(0))));
}
BENCHMARK(synchronised_ring)->Arg(6)->Arg(9)->Unit(benchmark::kMillisecond);

void random_paths(benchmark::State& state) {
    const std::optional<prism::CheckedModel> model = checked(counters(static_cast<int>(state.range(0))));
    const prism::Instance instance(*model, {});
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    const prism::PropertyFile file =
        prism::read_properties(sources, sources.add("question", "P=? [ G<=999 true ]"), diagnostics);
    const prism::CheckedProperties properties = prism::check_properties(*model, file, diagnostics);
    prism::SamplingOptions options;
    options.threads = 1;
    constexpr double steps = 1000 * 999;
    for (auto unused : state)
        benchmark::DoNotOptimize(prism::simulate(instance, properties, 0, {}, options, diagnostics));
    state.counters["steps/s"] = benchmark::Counter(steps, benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(random_paths)->Arg(6)->Unit(benchmark::kMillisecond);

/// A given model, with values for its open constants.
struct Given {
    std::optional<prism::CheckedModel> model;
    prism::Values constants;
};

Given given(const std::string& path, const std::string& constants) {
    std::ifstream file(path);
    const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    Given result{checked(text), {}};
    if (!result.model) throw std::runtime_error(path + " is no PRISM model");
    if (!constants.empty())
        result.constants =
            prism::combinations(prism::read_series(constants, prism::open_constants(result.model->constants))).front();
    return result;
}

/// Prints recorded figures. Those for RoboTool's model of the UVC case study (2,315,432 states, 9,644,662 transitions)
/// are from its published logs. Those of Storm are from the logs of the Quantitative Verification Benchmark Set.
void print_recorded() {
    fmt::print(
        "\nrecorded of others, states/s: PRISM 4.6, hybrid engine, UVC case study 48 thousand; Storm 1.2.4, sparse "
        "engine, models of the\nQuantitative Verification Benchmark Set 8 to 60 thousand; guards compiled to C++, UVC "
        "case study 720 thousand\n");
}

}  // namespace

int main(int argc, char** argv) try {
    benchmark::Initialize(&argc, argv);
    Given model;
    if (argc > 1) {
        model = given(argv[1], argc > 2 ? argv[2] : "");
        benchmark::RegisterBenchmark("model_given", [&](benchmark::State& state) {
            explore(state, *model.model, model.constants);
        })->Unit(benchmark::kMillisecond);
    }
    benchmark::RunSpecifiedBenchmarks();
    print_recorded();
    return EXIT_SUCCESS;
} catch (const std::exception& error) {
    fmt::print(stderr, "benchmark_prism: {}\n", error.what());
    return EXIT_FAILURE;
}
