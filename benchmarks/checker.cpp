// SPDX-License-Identifier: Apache-2.0
// Measures the states per second of the checker on dining philosophers: evaluation, operational semantics and search
// together.
#include <benchmark/benchmark.h>

#include <string>

#include "checker/cspm/session.hpp"
#include "checker/cspm/syntax/reader.hpp"

namespace {

using namespace robochart;

/// Returns a script with N philosophers and N forks. The last philosopher takes the other fork first, so there is no
/// deadlock.
std::string philosophers(int n) {
    const std::string last = std::to_string(n - 1);
    const std::string count = std::to_string(n);
    return "channel picks, puts : {0.." + last + "}.{0.." + last +
           "}\n"
           "channel eats : {0.." +
           last +
           "}\n"
           "Right(i) = if i == " +
           last +
           " then 0 else i + 1\n"
           "First(i) = if i == " +
           last +
           " then Right(i) else i\n"
           "Second(i) = if i == " +
           last +
           " then i else Right(i)\n"
           "Phil(i) = picks!i!First(i) -> picks!i!Second(i) -> eats!i -> puts!i!First(i) -> puts!i!Second(i) -> "
           "Phil(i)\n"
           "Fork(f) = picks?i!f -> puts!i!f -> Fork(f)\n"
           "System = (||| i : {0.." +
           last + "} @ Phil(i)) [| {| picks, puts |} |] (||| f : {0.." + last +
           "} @ Fork(f))\n"
           "assert System :[deadlock free [F]]\n-- " +
           count + "\n";
}

void deadlock_freedom(benchmark::State& state) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    const auto source = sources.add("philosophers.csp", philosophers(static_cast<int>(state.range(0))));
    const cspm::Script script = cspm::read(sources, source, diagnostics);
    std::uint64_t states = 0;
    for (auto _ : state) {
        cspm::Session session(script);
        const auto result = session.check(*session.assertions().front(), {});
        if (result.verdict.outcome != refine::Outcome::holds) state.SkipWithError("the table deadlocks");
        states += result.verdict.statistics.states;
    }
    state.counters["states/s"] = benchmark::Counter(static_cast<double>(states), benchmark::Counter::kIsRate);
}
BENCHMARK(deadlock_freedom)->Arg(4)->Arg(6)->Unit(benchmark::kMillisecond);

}  // namespace
