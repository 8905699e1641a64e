// SPDX-License-Identifier: Apache-2.0
// Tests that the search over partial readings scales to models for which the search over all valuations is infeasible.
// reading_on_demand_test.cpp compares the results of both.
#include "conformance/check/partial_readings.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "conformance/check/conform.hpp"
#include "conformance/check/conformance_check.hpp"
#include "tests/conformance/bench.hpp"
#include "tests/conformance/support.hpp"

namespace robochart::conformance {
namespace {

/// Each state takes one of sixteen events. There are 65,536 valuations, and each state of NF could store as many
/// contents of registers. But a cycle without the state's event changes nothing, and a cycle with the event reads at
/// most the next event.
TEST(PartialReadings, ScaleToManyEvents) {
    std::string text = "stm Ring {\n initial i transition t { from i to S0 }\n event x : nat\n";
    constexpr int states = 16;
    for (int s = 0; s < states; ++s)
        text += fmt::format(
            " event e{0}\n state S{0} {{ entry x!{1} ; wait(1) }}\n transition t{0} {{ from S{0} to S{2} trigger e{0} "
            "}}\n",
            s, s % 3, (s + 1) % states);
    const test::ModelFolder folder(text + "}\n");
    test::Model model(folder.path());
    Options options;
    options.limits.max_states = 100'000;
    options.walks.cycles = 0;
    const Result result = conform(model.system, model.instantiation, model.machine_named("Ring"), options,
                                  model.sources, model.diagnostics);
    EXPECT_EQ(result.outcome, Outcome::conforms) << result.reason;
    EXPECT_LT(result.product.states, 1000U);
}

TEST(PartialReadings, AreInconclusiveAtALimit) {
    test::Model model("corpus/aggregation");
    test::Bench bench(model, model.first_module());
    const auto object = bench.compile_fault(cpp_emit::Fault::none, 0);
    const Alphabet alphabet(bench.interface(), bench.session().event_table());
    ModelGraph graph(bench.system(), alphabet);
    refine::Limits limits;
    limits.max_states = 1;
    EXPECT_EQ(judge_partially(graph, alphabet, object->interface(), 1, limits).outcome, Outcome::inconclusive);
}

}  // namespace
}  // namespace robochart::conformance
