// SPDX-License-Identifier: Apache-2.0
// Tests that the search that reads registers on demand has the same results as the search over all valuations. Tests
// also that its size does not double with each input.
#include "conformance/check/reading_on_demand.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>

#include "conformance/check/conform.hpp"
#include "conformance/check/conformance_check.hpp"
#include "conformance/check/cycle_schedule.hpp"
#include "conformance/check/partial_readings.hpp"
#include "conformance/code/cycle_graph.hpp"
#include "semantics/instantiate/instantiate.hpp"
#include "semantics/lower/lower.hpp"
#include "tests/conformance/batches/batch.hpp"
#include "tests/conformance/bench.hpp"
#include "tests/conformance/random/random_shapes.hpp"
#include "tests/conformance/support.hpp"
#include "tests/random_models/models/well_formed.hpp"

namespace robochart::conformance {
namespace {

/// The faults that leave the code compilable.
constexpr std::array faults{cpp_emit::Fault::none,
                            cpp_emit::Fault::guard_negated,
                            cpp_emit::Fault::action_dropped,
                            cpp_emit::Fault::event_kept,
                            cpp_emit::Fault::output_repeated,
                            cpp_emit::Fault::input_not_awaited,
                            cpp_emit::Fault::event_not_consumed,
                            cpp_emit::Fault::guard_after_consume,
                            cpp_emit::Fault::loop_never_ends,
                            cpp_emit::Fault::wait_dropped,
                            cpp_emit::Fault::deadline_kept,
                            cpp_emit::Fault::outside_write_lost};

void expect_same(const Result& all, const Result& on_demand, const std::string& name) {
    EXPECT_EQ(all.outcome, on_demand.outcome) << name << ": " << all.reason << " / " << on_demand.reason;
    if (all.outcome != on_demand.outcome) return;
    if (all.register_cycles && on_demand.register_cycles) {
        EXPECT_EQ(all.register_cycles->holds, on_demand.register_cycles->holds) << name;
    }
    if (all.deadlines && on_demand.deadlines) {
        EXPECT_EQ(all.deadlines->holds, on_demand.deadlines->holds) << name;
    }
    if (all.outcome != Outcome::conforms) return;
    EXPECT_EQ(all.code_states, on_demand.code_states) << name;
    EXPECT_EQ(all.missed.size(), on_demand.missed.size()) << name;
    for (std::size_t i = 0; i < std::min(all.missed.size(), on_demand.missed.size()); ++i) {
        EXPECT_EQ(all.missed[i].event, on_demand.missed[i].event) << name;
        EXPECT_EQ(all.missed[i].cycles, on_demand.missed[i].cycles) << name;
    }
    EXPECT_EQ(all.overtaken.size(), on_demand.overtaken.size()) << name;
    for (std::size_t i = 0; i < std::min(all.overtaken.size(), on_demand.overtaken.size()); ++i) {
        EXPECT_EQ(all.overtaken[i].event, on_demand.overtaken[i].event) << name;
        EXPECT_EQ(all.overtaken[i].by, on_demand.overtaken[i].by) << name;
        EXPECT_EQ(all.overtaken[i].due, on_demand.overtaken[i].due) << name;
    }
}

/// Compares both searches that scale to many inputs with the search over all inputs.
TEST(ReadingOnDemand, AgreesWithAllInputsForSeededFaults) {
    using Fault = cpp_emit::Fault;
    std::size_t decided = 0;
    std::size_t different = 0;
    for (const auto& [folder, machine] :
         {std::pair("corpus/aggregation", ""), std::pair("tests/conformance/models/team", ""),
          std::pair("tests/conformance/models/timing", "Timing"),
          std::pair("tests/conformance/models/missed", "Missed"),
          std::pair("tests/conformance/models/outside", "Outside"),
          std::pair("tests/conformance/models/reacts", "Reacts")}) {
        test::Model model(folder);
        test::Bench bench(model, std::string(machine).empty() ? model.first_module() : model.machine_named(machine));
        const Alphabet alphabet(bench.interface(), bench.session().event_table());
        ModelGraph graph(bench.system(), alphabet);
        expect_same(check_schedulability(graph, alphabet, 1, {}), schedulable_on_demand(graph, alphabet, 1, {}),
                    folder);
        for (const Fault fault : faults) {
            if (fault != Fault::none && bench.site_count(fault) == 0) continue;
            const auto object = bench.compile_fault(fault, 0);
            if (!object) continue;
            const Result all = refined_by(graph, alphabet, object->interface(), 1, {});
            const Result partial = judge_partially(graph, alphabet, object->interface(), 1, {});
            EXPECT_EQ(all.outcome, partial.outcome)
                << folder << " " << static_cast<int>(fault) << ": " << all.reason << " / " << partial.reason;
            if (!all.api_difference) {
                EXPECT_EQ(all.cycles.size(), partial.cycles.size()) << folder;
            }
            try {
                const Result on_demand = refined_on_demand(graph, alphabet, object->interface(), 1, {});
                expect_same(all, on_demand, fmt::format("{} {}", folder, static_cast<int>(fault)));
                ++decided;
                different += all.outcome == Outcome::differs ? 1U : 0U;
            } catch (const NotProbed&) {
                EXPECT_NE(fault, Fault::none) << folder;
            }
        }
    }
    EXPECT_GT(decided, 30U);
    EXPECT_GT(different, 12U);
}

/// Generates the code of the model of this seed, with the fault at its first place. Returns null if the model has no
/// code, or the code has no such place.
std::unique_ptr<Candidate> random_candidate(std::uint64_t seed, cpp_emit::Fault fault, Options options) {
    const auto loaded = random_models::load(random_models::well_formed(seed, test::core_shape(seed)));
    if (loaded->findings.error_count() > 0) return nullptr;
    const ir::System system = ir::lower(loaded->model, loaded->sources, loaded->findings);
    const ir::Instantiation instantiation = ir::instantiate_system(system, {}, loaded->findings);
    if (!loaded->findings.ok() || system.modules.empty()) return nullptr;
    const ir::Module& module = system.modules.front();
    options.generator.fault = fault;
    return candidate(system, instantiation, {ir::ComponentKind::module, module.name, module.package, 0}, options,
                     loaded->sources, loaded->findings);
}

/// Compares both searches for the code of `count` models, from this seed on.
void compare_on_random_models(std::uint64_t first_seed, std::size_t count) {
    Options options;
    options.flags = "-std=c++17 -O0 -fno-exceptions -fno-rtti";
    options.limits.max_states = 30'000;
    options.walks.cycles = 0;
    std::vector<std::unique_ptr<Candidate>> candidates;
    std::vector<std::string> names;
    for (std::uint64_t seed = first_seed; candidates.size() < count; ++seed) {
        const cpp_emit::Fault fault = faults[seed % faults.size()];
        auto ready = random_candidate(seed, fault, options);
        if (!ready) continue;
        candidates.push_back(std::move(ready));
        names.push_back(fmt::format("seed {}, fault {}", seed, static_cast<int>(fault)));
    }
    std::string error;
    const auto batch = Batch::build(std::move(candidates), options, error);
    ASSERT_TRUE(batch) << error.substr(0, 500);
    std::size_t compared = 0, different = 0;
    for (std::size_t i = 0; i < batch->size(); ++i) {
        const auto deadline = [] { return std::chrono::steady_clock::now() + std::chrono::seconds(20); };
        const Result all = batch->judge_candidate(i, deadline(), InputSearch::all_inputs);
        const Result on_demand = batch->judge_candidate(i, deadline(), InputSearch::on_demand);
        if (all.outcome == Outcome::inconclusive || on_demand.outcome == Outcome::inconclusive) continue;
        ++compared;
        different += all.outcome == Outcome::differs ? 1U : 0U;
        expect_same(all, on_demand, names[i]);
    }
    EXPECT_GT(4 * compared, count);
    std::printf("%zu compared, %zu of them differ\n", compared, different);
}

TEST(ReadingOnDemand, AgreesWithAllInputsOnRandomModels) {
    compare_on_random_models(1, 40);
}

/// Compares many models for campaigns: ROBOCHART_ON_DEMAND is the first seed of 400 models.
TEST(ReadingOnDemand, Campaign) {
    const char* const seed = std::getenv("ROBOCHART_ON_DEMAND");
    if (seed == nullptr) GTEST_SKIP() << "ROBOCHART_ON_DEMAND is not set";
    for (std::uint64_t part = 0; part < 10; ++part)
        compare_on_random_models(std::strtoull(seed, nullptr, 10) + 1000 * part, 40);
}

/// Returns a machine in which one state takes any of its events, and another state takes none of them.
std::string hub(int events) {
    std::string text =
        "stm Hub {\n initial i state Idle { } state Hub { }\n event x : nat\n event go\n event back\n"
        " transition t { from i to Idle }\n transition g { from Idle to Hub trigger go }\n"
        " transition b { from Hub to Idle trigger back }\n";
    for (int e = 0; e < events; ++e)
        text +=
            fmt::format(" event e{0}\n transition t{0} {{ from Hub to Hub trigger e{0} action x!{1} }}\n", e, e % 3);
    return text + "}\n";
}

Result judge_hub(int events) {
    const test::ModelFolder folder(hub(events));
    test::Model model(folder.path());
    Options options;
    options.walks.cycles = 0;
    return conform(model.system, model.instantiation, model.machine_named("Hub"), options, model.sources,
                   model.diagnostics);
}

TEST(ReadingOnDemand, GrowsSlowlyWithTheNumberOfEvents) {
    const Result few = judge_hub(10);
    const Result many = judge_hub(20);
    EXPECT_EQ(few.outcome, Outcome::conforms) << few.reason;
    EXPECT_EQ(many.outcome, Outcome::conforms) << many.reason;
    EXPECT_LT(many.code_cycles, 8 * few.code_cycles);
    EXPECT_LT(many.product.states, 100'000U);
}

/// The model takes `e1` in no state that it reaches, but the code of the other model reads it.
TEST(ReadingOnDemand, EventsThatTheModelAwaitsNowhereAreTried) {
    const std::string head = "stm S {\n initial i state A { } state B { } state C { }\n event x : nat\n";
    std::string events;
    for (int e = 0; e < 9; ++e)
        events += fmt::format(" event e{0}\n transition c{0} {{ from C to C trigger e{0} action x!1 }}\n", e);
    const std::string ways = " transition t { from i to A }\n transition a { from A to B trigger e0 }\n";
    const test::ModelFolder one(head + events + ways + "}\n");
    const test::ModelFolder other(head + events + ways + " transition b { from A to A trigger e1 }\n}\n");
    test::Model model(one.path());
    test::Model changed(other.path());
    test::Bench bench(model, model.machine_named("S"));
    test::Bench other_bench(changed, changed.machine_named("S"));
    const auto same = bench.compile_fault(cpp_emit::Fault::none, 0);
    const auto different = other_bench.compile_fault(cpp_emit::Fault::none, 0);
    const Alphabet alphabet(bench.interface(), bench.session().event_table());
    ModelGraph graph(bench.system(), alphabet);
    EXPECT_EQ(refined_on_demand(graph, alphabet, same->interface(), 1, {}).outcome, Outcome::conforms);
    // If the code takes e1 without an effect, it does not differ. If it makes an output, it differs.
    EXPECT_EQ(refined_on_demand(graph, alphabet, different->interface(), 1, {}).outcome, Outcome::conforms);
    const test::ModelFolder third(head + events + ways + " transition b { from A to A trigger e1 action x!2 }\n}\n");
    test::Model writes(third.path());
    test::Bench writing_bench(writes, writes.machine_named("S"));
    const auto writing = writing_bench.compile_fault(cpp_emit::Fault::none, 0);
    const Result result = refined_on_demand(graph, alphabet, writing->interface(), 1, {});
    EXPECT_EQ(result.outcome, Outcome::differs);
    ASSERT_EQ(result.cycles.size(), 1U);
    EXPECT_EQ(result.cycles.front().inputs, std::vector<std::string>{"e1"});
}

TEST(ReadingOnDemand, HandWrittenCodeIsNotProbed) {
    std::string error;
    const auto object = test::hand_made("turner", 0, error);
    ASSERT_TRUE(object) << error;
    process::EventTable events;
    const Alphabet alphabet(test::turner_interface(), events);
    EXPECT_THROW(CycleGraph(object->interface(), alphabet, 1), NotProbed);
}

TEST(ReadingOnDemand, SaysAtALimitWhatWasSearched) {
    test::Model model("corpus/aggregation");
    test::Bench bench(model, model.first_module());
    const auto object = bench.compile_fault(cpp_emit::Fault::none, 0);
    const Alphabet alphabet(bench.interface(), bench.session().event_table());
    ModelGraph graph(bench.system(), alphabet);
    refine::Limits limits;
    limits.max_states = 3;
    const Result result = refined_on_demand(graph, alphabet, object->interface(), 1, limits);
    EXPECT_EQ(result.outcome, Outcome::inconclusive);
    EXPECT_NE(result.reason.find("no difference in "), std::string::npos) << result.reason;
}

}  // namespace
}  // namespace robochart::conformance
