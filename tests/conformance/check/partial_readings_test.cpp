// SPDX-License-Identifier: Apache-2.0
// Compares the search over partial readings with the search over all valuations. Both have the same result, and the
// former scales to models for which the latter is infeasible.
#include "conformance/check/partial_readings.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "conformance/check/conform.hpp"
#include "conformance/check/conformance_check.hpp"
#include "tests/conformance/bench.hpp"
#include "tests/conformance/support.hpp"

namespace robochart::conformance {
namespace {

/// Runs both searches on the code of one component.
class Both {
public:
    Both(const std::string& folder, const std::string& machine)
        : model_(folder), bench_(model_, machine.empty() ? model_.first_module() : model_.machine_named(machine)) {}

    /// The results of both searches; no value if the code does not compile.
    std::optional<std::pair<Result, Result>> judge_both(cpp_emit::Fault fault, std::uint32_t site) {
        const auto object = bench_.compile_fault(fault, site);
        if (!object) return std::nullopt;
        const Alphabet alphabet(bench_.interface(), bench_.session().event_table());
        ModelGraph graph(bench_.system(), alphabet);
        Result whole = refined_by(graph, alphabet, object->interface(), 1, {});
        Result partial = judge_partially(graph, alphabet, object->interface(), 1, {});
        return std::pair{std::move(whole), std::move(partial)};
    }
    [[nodiscard]] std::uint32_t sites(cpp_emit::Fault fault) { return bench_.site_count(fault); }

private:
    test::Model model_;
    test::Bench bench_;
};

TEST(PartialReadings, AgreeWithAllValuations) {
    using Fault = cpp_emit::Fault;
    std::size_t different = 0;
    for (const auto& [folder, machine] :
         {std::pair("corpus/aggregation", ""), std::pair("tests/conformance/models/team", ""),
          std::pair("tests/conformance/models/timing", "Timing"),
          std::pair("tests/conformance/models/missed", "Missed"),
          std::pair("tests/conformance/models/outside", "Outside"),
          std::pair("tests/conformance/models/reacts", "Reacts")}) {
        Both both(folder, machine);
        for (const Fault fault :
             {Fault::none, Fault::guard_negated, Fault::action_dropped, Fault::event_kept, Fault::output_repeated,
              Fault::wait_dropped, Fault::deadline_kept, Fault::outside_write_lost}) {
            if (fault != Fault::none && both.sites(fault) == 0) continue;
            const auto results = both.judge_both(fault, 0);
            if (!results) continue;
            EXPECT_EQ(results->first.outcome, results->second.outcome)
                << folder << " " << static_cast<int>(fault) << ": " << results->first.reason << " / "
                << results->second.reason;
            different += results->first.outcome == Outcome::differs ? 1U : 0U;
            if (results->first.api_difference) continue;
            EXPECT_EQ(results->first.cycles.size(), results->second.cycles.size()) << folder;
        }
    }
    EXPECT_GT(different, 12U);
}

/// Each state takes one of sixteen events. There are 65,536 valuations, and each state of NF could store as many
/// contents of registers. However, a cycle without the state's event changes nothing, and a cycle with the event reads
/// at most the next event.
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
