// SPDX-License-Identifier: Apache-2.0
// Tests refinement in tick-tock. Hand-written pairs show differences between failures-divergences and tick-tock. Random
// pairs are compared with model shifting (Mestel, Roscoe: refusals become events of lower priority, so that refinement
// of traces decides). For normal forms the two relations agree (docs/conformance.md, "Tick-tock").
#include "conformance/model/tick_tock.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

#include "checker/cspm/session.hpp"
#include "checker/cspm/syntax/build.hpp"
#include "checker/cspm/syntax/reader.hpp"
#include "tests/conformance/bench.hpp"
#include "tests/conformance/support.hpp"

namespace robochart::conformance {
namespace {

using test::Edge;
using test::GraphSystem;

struct Answers {
    refine::Verdict failures_divergences, tick_tock;
};

Answers compare_refinements(const std::vector<Edge>& specification, const std::vector<Edge>& implementation) {
    process::EventTable events;
    const process::Event tock = events.intern("tock");
    GraphSystem s(specification, events);
    GraphSystem i(implementation, events);
    return {refine::refines(s, i, refine::Model::failures_divergences, {}), tick_tock_refines(s, i, tock, {})};
}

/// A process whose behaviour after a time unit shows whether a was refused before. After a time unit in which a was
/// refused, b is offered forever. After a time unit in which a was offered and not taken, only time passes.
const std::vector<Edge> late_offer = {{0, "tau", 1}, {0, "tau", 2},  {1, "tock", 3}, {2, "a", 5},   {2, "tock", 4},
                                      {3, "b", 3},   {3, "tock", 3}, {4, "tock", 4}, {5, "tock", 5}};

TEST(TickTock, WhatWasRefusedBeforeTimePassedCounts) {
    // the process refuses a, lets time pass, and then refuses b, which the specification never does
    const Answers answers = compare_refinements(late_offer, {{0, "tock", 1}, {1, "tock", 1}});
    EXPECT_EQ(answers.failures_divergences.outcome, refine::Outcome::holds);
    ASSERT_EQ(answers.tick_tock.outcome, refine::Outcome::fails);
    EXPECT_EQ(answers.tick_tock.counterexample->kind, refine::ViolationKind::refusal);
    EXPECT_EQ(answers.tick_tock.counterexample->steps.size(), 1U);
    // if the process offers a instead, it may refuse b after the time unit
    const Answers offers = compare_refinements(late_offer, {{0, "tock", 1}, {0, "a", 1}, {1, "tock", 1}});
    EXPECT_EQ(offers.tick_tock.outcome, refine::Outcome::holds);
}

TEST(TickTock, ATockBehindARefusalThatNoStateHas) {
    // The specification lets time pass only in the state that offers a. In the state that refuses a, time stops until
    // b.
    const std::vector<Edge> specification = {{0, "tau", 1},  {0, "tau", 2}, {1, "a", 3},
                                             {1, "tock", 0}, {2, "b", 3},   {3, "tock", 3}};
    const Answers answers = compare_refinements(specification, {{0, "b", 1}, {0, "tock", 0}, {1, "tock", 1}});
    EXPECT_EQ(answers.failures_divergences.outcome, refine::Outcome::holds);
    ASSERT_EQ(answers.tick_tock.outcome, refine::Outcome::fails);
    EXPECT_EQ(answers.tick_tock.counterexample->kind, refine::ViolationKind::trace);
}

TEST(TickTock, TimelocksAndMissingEventsAreFound) {
    const std::vector<Edge> clock = {{0, "tock", 0}};
    EXPECT_EQ(compare_refinements(clock, {{0, "tock", 1}}).tick_tock.outcome, refine::Outcome::fails);  // time stops
    EXPECT_EQ(compare_refinements(clock, {{0, "a", 0}, {0, "tock", 0}}).tick_tock.outcome, refine::Outcome::fails);
    EXPECT_EQ(compare_refinements({{0, "a", 1}, {0, "tock", 0}, {1, "tock", 1}}, clock).tick_tock.outcome,
              refine::Outcome::fails);
    EXPECT_EQ(compare_refinements(clock, clock).tick_tock.outcome, refine::Outcome::holds);
    // Maximal progress: no time passes while a hidden event is possible.
    EXPECT_EQ(
        compare_refinements({{0, "a", 1}, {1, "tock", 1}}, {{0, "tau", 1}, {0, "tock", 3}, {1, "a", 2}, {2, "tock", 2}})
            .tick_tock.outcome,
        refine::Outcome::holds);
}

// ------------------------------------------------------------ against model shifting

constexpr const char* shifting = R"(
external prioritisepo
external prioritise
channel tock, a, b, silent
observed = {a, b, tock}
channel ref : {a, b, tock}
order = {(e, ref.e) | e <- observed}
refusals(P) = prioritisepo(P ||| RUN({|ref|}), union(observed, {|ref|}), order, observed)
events_first = ([] e : observed @ e -> events_first) [] ref?_ -> then_time
then_time = ref?_ -> then_time [] tock -> events_first
TT(P) = refusals(prioritise(P, <{}, {tock}>)) [| union(observed, {|ref|}) |] events_first
)";

/// Returns a process of a few states with random edges. It has no cycles of hidden events, because model shifting does
/// not handle divergence.
std::string random_process(const std::string& name, std::mt19937& random, std::vector<Edge>& edges) {
    const auto pick = [&](unsigned n) { return static_cast<unsigned>(random() % n); };
    const std::vector<std::string> events{"a", "b", "tock", "tock", "tau"};
    const unsigned states = 2 + pick(3);
    std::string text;
    for (unsigned s = 0; s < states; ++s) {
        std::string body;
        for (unsigned e = pick(4); e > 0; --e) {
            const std::string& event = events[pick(5)];
            if (event == "tau" && s + 1 == states) continue;
            const unsigned to = event == "tau" ? s + 1 + pick(states - s - 1) : pick(states);
            edges.push_back({s, event, to});
            body +=
                fmt::format("{}{} -> {}_({})", body.empty() ? "" : " [] ", event == "tau" ? "silent" : event, name, to);
        }
        text += fmt::format("{}_({}) = {}\n", name, s, body.empty() ? "STOP" : body);
    }
    return text + fmt::format("{0} = {0}_(0) \\ {{silent}}\nTT{0} = TT({0})\n", name);
}

TEST(TickTock, AgreesWithModelShiftingOnRandomPairs) {
    unsigned differ = 0, holding = 0;
    for (unsigned seed = 0; seed < 200; ++seed) {
        std::mt19937 random(seed);
        std::vector<Edge> p, q;
        std::string text = shifting + random_process("P", random, p);
        // Every second process is the specification with one edge removed, because random processes seldom refine each
        // other.
        text += random_process("Q", random, q);
        if (p.empty() || q.empty()) continue;
        diagnostics::SourceManager sources;
        diagnostics::Diagnostics found;
        cspm::Session session(cspm::read(sources, sources.add("pair.csp", text), found));
        ASSERT_TRUE(found.ok()) << text;
        const auto spec = session.system(cspm::build::name("TTP"));
        const auto impl = session.system(cspm::build::name("TTQ"));
        const auto expected = refine::refines(*spec, *impl, refine::Model::traces, {}).outcome;
        const Answers answers = compare_refinements(p, q);
        EXPECT_EQ(answers.tick_tock.outcome, expected) << text;
        holding += expected == refine::Outcome::holds ? 1U : 0U;
        differ += answers.failures_divergences.outcome != expected ? 1U : 0U;
        const auto itself = session.system(cspm::build::name("TTP"));
        EXPECT_EQ(compare_refinements(p, p).tick_tock.outcome, refine::Outcome::holds) << text;
    }
    EXPECT_GT(holding, 10U);
    EXPECT_GT(differ, 0U);
}

// ------------------------------------------------------------ on normal forms

TEST(TickTock, AgreesWithFailuresDivergencesOnNormalForms) {
    for (const char* folder : {"corpus/aggregation", "tests/conformance/models/nested"}) {
        test::Model model(folder);
        test::Bench bench(model, model.first_module());
        for (const auto fault : {cpp_emit::Fault::none, cpp_emit::Fault::wait_dropped, cpp_emit::Fault::action_dropped,
                                 cpp_emit::Fault::single_transition_step}) {
            if (fault != cpp_emit::Fault::none && bench.site_count(fault) == 0) continue;
            const auto object = bench.compile_fault(fault, 0);
            ASSERT_NE(object, nullptr);
            const Result one = bench.check_code(object->interface());
            const Result other = bench.check_code(object->interface(), Relation::tick_tock);
            EXPECT_EQ(one.outcome, other.outcome) << folder << " " << static_cast<int>(fault) << other.reason;
            EXPECT_TRUE(fault != cpp_emit::Fault::none || other.outcome == Outcome::conforms) << other.reason;
            EXPECT_EQ(one.cycles.size(), other.cycles.size()) << folder;
        }
    }
}

}  // namespace
}  // namespace robochart::conformance
