// Exploration of PRISM models, interpreted: states a second, for a chain whose commands act alone, and for a decision
// process whose commands act together.
#include <benchmark/benchmark.h>

#include <optional>
#include <string>

#include "checker/prism/checks/check.hpp"
#include "checker/prism/explore/state_space.hpp"
#include "checker/prism/syntax/reader.hpp"

namespace {

using namespace robochart;

/// Counters that count to 9, each with a chance of one half to stay: 10^counters states.
std::string counters(int count) {
    std::string text = "dtmc\n";
    for (int i = 0; i < count; ++i) {
        const std::string x = "x" + std::to_string(i);
        text += "module M" + std::to_string(i) + " " + x + ":[0..9]; [] " + x + "<9 -> 0.5:(" + x + "'=" + x +
                "+1) + 0.5:true; [] " + x + "=9 -> true; endmodule\n";
    }
    return text;
}

/// Neighbours in a ring move together, or one of them turns back: 4^parts states.
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

void explore(benchmark::State& state, const std::string& text) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    const prism::ModelFile file = prism::read_model(sources, sources.add("model", text), diagnostics);
    const std::optional<prism::CheckedModel> model = prism::check_model(file, diagnostics);
    std::size_t states = 0;
    for (auto unused : state) {
        const prism::StateSpace space(*model, {}, {}, diagnostics);
        states = space.chain().states();
    }
    state.counters["states"] = static_cast<double>(states);
    state.counters["states/s"] =
        benchmark::Counter(static_cast<double>(states), benchmark::Counter::kIsIterationInvariantRate);
}

void independent_counters(benchmark::State& state) {
    explore(state, counters(static_cast<int>(state.range(0))));
}
BENCHMARK(independent_counters)->Arg(4)->Arg(5)->Unit(benchmark::kMillisecond);

void synchronised_ring(benchmark::State& state) {
    explore(state, ring(static_cast<int>(state.range(0))));
}
BENCHMARK(synchronised_ring)->Arg(6)->Arg(8)->Unit(benchmark::kMillisecond);

}  // namespace
