// SPDX-License-Identifier: Apache-2.0
// Tests well-known families of processes. Their verdicts and sizes are published or follow by counting.
#include <gtest/gtest.h>

#include "checker/process/term_system.hpp"
#include "checker/refine/verdict/check.hpp"
#include "classics.hpp"

namespace robochart::refine {
namespace {

class Classics : public testing::Test {
protected:
    Scripted s;
    process::OperationalSemantics semantics{s.store};
    const Limits limits{};
    process::TermSystem system(TermId term) { return {semantics, term}; }
};

TEST_F(Classics, SymmetricPhilosophersDeadlock) {
    // The deadlock needs three events of each of the three philosophers: thinking, sitting down and picking up the left
    // fork.
    process::TermSystem table = system(dining_philosophers(s, 3, true));
    const Verdict verdict = deadlock_free(table, Model::failures, limits);
    ASSERT_EQ(verdict.outcome, Outcome::fails);
    EXPECT_EQ(verdict.counterexample->kind, ViolationKind::deadlock);
    EXPECT_EQ(verdict.counterexample->steps.size(), 9U);
    EXPECT_TRUE(verdict.counterexample->offered.empty());
    EXPECT_EQ(deadlock_free(table, Model::failures_divergences, limits).outcome, Outcome::fails);
}

TEST_F(Classics, AsymmetricPhilosophersDoNot) {
    process::TermSystem table = system(dining_philosophers(s, 3, false));
    const Verdict verdict = deadlock_free(table, Model::failures_divergences, limits);
    EXPECT_EQ(verdict.outcome, Outcome::holds);
    EXPECT_EQ(verdict.statistics.states, 347U);  // confirmed by other authors with four tools
    EXPECT_EQ(verdict.statistics.transitions, 947U);
    process::TermSystem five = system(dining_philosophers(s, 5, false));
    EXPECT_EQ(divergence_free(five, limits).statistics.states, 17711U);
}

TEST_F(Classics, MilnersSchedulerRunsInTurn) {
    constexpr int count = 6;
    const TermId scheduler = milner_scheduler(s, count);
    process::TermSystem whole = system(scheduler);
    process::TermSystem turns = system(hide_channels(s, scheduler, {"b", "c"}, count));
    process::TermSystem specification = system(round_robin(s, count));
    const Verdict verdict = refines(specification, turns, Model::failures_divergences, limits);
    EXPECT_EQ(verdict.outcome, Outcome::holds);
    EXPECT_EQ(verdict.statistics.states, 3U * count << (count - 1));  // Milner 1989 has 3 N 2^(N-1) states
    EXPECT_EQ(verdict.statistics.spec_nodes, static_cast<std::uint64_t>(count));
    EXPECT_EQ(deterministic(whole, Model::failures_divergences, limits).outcome, Outcome::holds);
    EXPECT_EQ(deadlock_free(whole, Model::failures_divergences, limits).outcome, Outcome::holds);
    process::TermSystem fewer = system(round_robin(s, count - 1));
    const Verdict wrong = refines(fewer, turns, Model::traces, limits);
    ASSERT_EQ(wrong.outcome, Outcome::fails);
    EXPECT_EQ(s.events.name(*wrong.counterexample->event), "a.5");  // the specification expects a.0 here
    EXPECT_EQ(wrong.counterexample->required, (std::vector<process::EventSet>{{s.event("a.0")}}));
}

TEST_F(Classics, ABufferChainIsABuffer) {
    constexpr int places = 5;
    process::TermSystem chain = system(buffer_chain(s, places));
    process::TermSystem whole = system(buffer(s, places));
    const Verdict forth = refines(whole, chain, Model::failures_divergences, limits);
    EXPECT_EQ(forth.outcome, Outcome::holds);
    EXPECT_EQ(forth.statistics.states, 243U);     // 3^5, because each place is empty, 0 or 1
    EXPECT_EQ(forth.statistics.spec_nodes, 63U);  // 2^6 - 1 contents
    EXPECT_EQ(refines(chain, whole, Model::failures_divergences, limits).outcome, Outcome::holds);
    EXPECT_EQ(deterministic(chain, Model::failures_divergences, limits).outcome, Outcome::holds);
}

TEST_F(Classics, AShorterChainIsNotTheSameBuffer) {
    process::TermSystem chain = system(s.rename(buffer_chain(s, 2), {{"ch.2.0", "ch.3.0"}, {"ch.2.1", "ch.3.1"}}));
    process::TermSystem three = system(buffer(s, 3));
    EXPECT_EQ(refines(three, chain, Model::traces, limits).outcome, Outcome::holds);
    const Verdict verdict = refines(three, chain, Model::failures, limits);
    ASSERT_EQ(verdict.outcome, Outcome::fails);
    // The buffer contains two items, and a tau has moved the first one on. There is no space for a third item.
    EXPECT_EQ(verdict.counterexample->kind, ViolationKind::refusal);
    EXPECT_EQ(verdict.counterexample->steps.size(), 3U);
    EXPECT_EQ(verdict.counterexample->offered.size(), 1U);
    ASSERT_EQ(verdict.counterexample->required.size(), 1U);
    EXPECT_EQ(verdict.counterexample->required[0].size(), 3U);
}

TEST_F(Classics, IndependentCyclesMultiply) {
    process::TermSystem cycles = system(independent_cycles(s, 7));
    const Verdict verdict = deadlock_free(cycles, Model::failures, limits);
    EXPECT_EQ(verdict.outcome, Outcome::holds);
    EXPECT_EQ(verdict.statistics.states, 16384U);  // 4^7
    EXPECT_EQ(verdict.statistics.transitions, 7U * 16384U);
    EXPECT_EQ(verdict.statistics.depth, 21U);
}

}  // namespace
}  // namespace robochart::refine
