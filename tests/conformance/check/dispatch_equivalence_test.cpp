// SPDX-License-Identifier: Apache-2.0
// Compares the event API with the cycle API in all states and with all events, and tests the report of a difference.
// The expected states follow by hand from tests/conformance/models/reacts.
#include <gtest/gtest.h>

#include <tuple>

#include "tests/conformance/bench.hpp"

namespace robochart::conformance {
namespace {

using cpp_emit::Fault;

const char* const reacts = "tests/conformance/models/reacts";

/// The module has two events without values, and its code has five states. The check dispatches each event, and no
/// event, in each state.
TEST(EventApi, IsComparedInEveryStateWithEveryEvent) {
    test::Model model("corpus/aggregation");
    test::Bench bench(model, model.first_module());
    const Result result = bench.check_code();
    EXPECT_EQ(result.outcome, Outcome::conforms) << result.reason;
    EXPECT_EQ(result.code_states, 5U);
    EXPECT_EQ(result.dispatched, 5U * (1 + 2));
    EXPECT_FALSE(result.api_difference);
}

/// The faulty code omits the first exit actions, which are those of A for event `a`: `innerLeft = true`. One cycle with
/// `a`, or with `v` of 1, leads to A.
TEST(EventApi, ADifferenceIsReportedWithTheWayThereAndBothBehaviours) {
    test::Model model(reacts);
    test::Bench bench(model, model.machine_named("Reacts"));
    const Result result = bench.check_code(Fault::dispatch_exits_dropped, 0);
    ASSERT_EQ(result.outcome, Outcome::differs) << result.reason;
    EXPECT_EQ(result.reason, "the event API differs from the cycle: `dispatch` of a: another state");
    ASSERT_EQ(result.cycles.size(), 1U);
    EXPECT_EQ(result.cycles[0].inputs.size(), 1U);
    EXPECT_EQ(result.cycles[0].outputs.size(), 1U);
    EXPECT_NE(result.cycles[0].state.find("state=Work_A "), std::string::npos) << result.cycles[0].state;
    ASSERT_TRUE(result.api_difference);
    EXPECT_EQ(result.api_difference->event, "a");
    EXPECT_EQ(result.api_difference->cycle.ends, "at rest");
    EXPECT_NE(result.api_difference->cycle.state.find("innerLeft=true"), std::string::npos)
        << result.api_difference->cycle.state;
    EXPECT_NE(result.api_difference->dispatched.state.find("innerLeft=false"), std::string::npos)
        << result.api_difference->dispatched.state;
}

/// The event comes before the first cycle. `v` with 0 leads to Check, which has a transition without a trigger.
TEST(EventApi, WhatIsStillEnabledIsReported) {
    test::Model model(reacts);
    test::Bench bench(model, model.machine_named("Reacts"));
    bool reported = false;
    for (std::uint32_t site = 0; !reported && site < bench.site_count(Fault::dispatch_look_dropped); ++site) {
        const Result result = bench.check_code(Fault::dispatch_look_dropped, site);
        if (result.reason.find("it leaves something enabled") == std::string::npos) continue;
        reported = true;
        EXPECT_EQ(result.outcome, Outcome::differs);
        ASSERT_TRUE(result.api_difference);
        EXPECT_NE(result.api_difference->dispatched.state.find("state=Check"), std::string::npos)
            << result.api_difference->dispatched.state;
    }
    EXPECT_TRUE(reported);
}

/// Without inputs, time passes only after all enabled transitions without triggers. Wait is left two time units after
/// its entry.
TEST(EventApi, PassIsACycleWithoutInputs) {
    test::Model model(reacts);
    test::Bench bench(model, model.machine_named("Reacts"));
    const Result result = bench.check_code(Fault::pass_not_quiet, 0);
    ASSERT_EQ(result.outcome, Outcome::differs) << result.reason;
    EXPECT_NE(result.reason.find("`pass`"), std::string::npos) << result.reason;
    ASSERT_TRUE(result.api_difference);
    EXPECT_EQ(result.api_difference->event, "");
    EXPECT_NE(result.api_difference->cycle.state, result.api_difference->dispatched.state);
}

/// `x` is output twice in the same instant, both in a cycle and after a dispatch.
TEST(EventApi, AnOutputMadeTwiceIsMadeAtOnce) {
    const test::ModelFolder folder(R"(
stm Twice {
    event go
    event x : nat
    initial i
    state A { }
    state B { entry x!1 ; x!2 }
    transition t0 { from i to A }
    transition t1 { from A to B trigger go }
    transition t2 { from B to A trigger go }
})");
    test::Model model(folder.path());
    test::Bench bench(model, model.machine_named("Twice"));
    const Result result = bench.check_code();
    EXPECT_EQ(result.outcome, Outcome::conforms) << result.reason;
    EXPECT_EQ(result.dispatched, 2U * 3);  // initial state, A, B; each with `go` and with no event
}

/// If the code asks its platform at choices, both APIs must ask the same questions and give the same results for every
/// answer. A `dispatch` that takes the first alternative without asking the platform differs from a `step` that asks.
/// This also holds if `dispatch` finds the transition in its table. In Reacts, `a` triggers a transition of A and one
/// of an enclosing state.
TEST(EventApi, AsksWhatTheCycleAsks) {
    for (const auto& [folder, machine, event] :
         {std::tuple("tests/conformance/models/either", "M", "go"), std::tuple(reacts, "Reacts", "a")}) {
        test::Model model(folder);
        test::Bench bench(model, model.machine_named(machine));
        const auto takes_first = bench.compile_fault(Fault::none, 0);
        bench.explore_choices();
        const auto asks = bench.compile_fault(Fault::none, 0);
        ASSERT_TRUE(takes_first && asks);
        const Result whole = bench.check_code(asks->interface());
        EXPECT_EQ(whole.outcome, Outcome::conforms) << whole.reason;
        EXPECT_GT(whole.dispatched, 0U);
        rc_interface mixed = asks->interface();
        ASSERT_EQ(mixed.state_size, takes_first->interface().state_size);
        mixed.dispatch = takes_first->interface().dispatch;
        const Result result = bench.check_code(mixed);
        EXPECT_EQ(result.outcome, Outcome::differs);
        EXPECT_EQ(result.reason,
                  std::string("the event API differs from the cycle: `dispatch` of ") + event + ": other choices");
    }
}

}  // namespace
}  // namespace robochart::conformance
