// SPDX-License-Identifier: Apache-2.0
// Tests the reduced form of a compiled process, in which confluent taus are followed. It is equivalent to the whole
// process under branching bisimilarity with explicit divergence. The tests use random processes and random rules.
#include <gtest/gtest.h>

#include <iostream>

#include "checker/machine/compiler.hpp"
#include "checker/machine/reduced_system.hpp"
#include "checker/refine/verdict/check.hpp"
#include "tests/checker/lts/bisimilar.hpp"
#include "tests/checker/machine/random_rules.hpp"
#include "tests/checker/processes/random_cases.hpp"
#include "tests/checker/processes/translate.hpp"
#include "tests/rounds.hpp"

namespace robochart::machine {
namespace {

using lts::Equivalence;
using lts::Graph;
using process::Op;
using process::Scripted;

constexpr std::size_t most_states = 100'000;

/// Counts comparisons, so that the tests can show that they are not vacuous.
struct Seen {
    int smaller = 0;    ///< systems whose reduction has fewer states
    int diverging = 0;  ///< of these, those with a cycle of taus
    std::uint64_t states = 0, reduced_states = 0;
};

bool loops_by_tau(const Graph& quotient) {
    for (lts::StateIndex state = 0; state < quotient.size(); ++state)
        for (const lts::Edge& edge : quotient.edges(state))
            if (edge.event == process::tau && edge.target == state) return true;
    return false;
}

/// Checks that the reduced system is equivalent to the whole. If no rule can be followed, there is no reduced system.
bool keeps_everything(lts::TransitionSystem& whole, Seen& seen) {
    const auto reduced = whole.make_reduced_system(lts::Followed::taus, diagnostics::unlimited);
    if (!reduced) return true;
    const Graph all = lts::graph_of(whole, most_states);
    const Graph reduced_graph = lts::graph_of(*reduced, most_states);
    const Graph quotient = lts::minimise(all, Equivalence::branching_with_divergence).graph;
    const Graph quotient_of_reduced = lts::minimise(reduced_graph, Equivalence::branching_with_divergence).graph;
    seen.states += all.size();
    seen.reduced_states += reduced_graph.size();
    if (reduced_graph.size() < all.size()) {
        ++seen.smaller;
        if (loops_by_tau(quotient)) ++seen.diverging;
    }
    return reduced_graph.size() <= all.size() && quotient.size() == quotient_of_reduced.size() &&
           quotient.edge_count() == quotient_of_reduced.edge_count() &&
           lts::are_bisimilar(all, reduced_graph, Equivalence::branching_with_divergence);
}

TEST(Reduction, KeepsRandomRules) {
    const int rounds = refine::wanted_checks(static_cast<int>(tests::rounds(1'000)));
    Scripted s;
    for (Event i = 0; i < RandomRules::visible; ++i) s.event("e" + std::to_string(i));
    RandomRules rules(2022);
    Seen seen;
    for (int round = 0; round < rounds; ++round) {
        SupercombinatorSystem whole(rules.next(s.stop()), s.store);
        ASSERT_TRUE(keeps_everything(whole, seen)) << "round " << round;
    }
    std::cout << seen.smaller << " of " << rounds << " with fewer states, " << seen.diverging
              << " of them divergent; states " << seen.states << ", kept " << seen.reduced_states << "\n";
    EXPECT_GT(seen.smaller * 10, rounds);
    EXPECT_GT(seen.diverging * 20, rounds);
}

bool has_deadlock(const Graph& graph) {
    for (lts::StateIndex state = 0; state < graph.size(); ++state)
        if (graph.edges(state).empty()) return true;
    return false;
}

/// If all steps are followed, the reduced system has a state without transitions if and only if the whole system has
/// one.
TEST(Reduction, ForDeadlocksKeepsDeadlocksOfRandomRules) {
    const int rounds = refine::wanted_checks(static_cast<int>(tests::rounds(1'000)));
    Scripted s;
    for (Event i = 0; i < RandomRules::visible; ++i) s.event("e" + std::to_string(i));
    RandomRules rules(2025);
    int smaller = 0, smaller_with_deadlock = 0;
    for (int round = 0; round < rounds; ++round) {
        SupercombinatorSystem whole(rules.next(s.stop()), s.store);
        const auto reduced = whole.make_reduced_system(lts::Followed::steps, diagnostics::unlimited);
        if (!reduced) continue;
        const Graph all = lts::graph_of(whole, most_states);
        const Graph reduced_graph = lts::graph_of(*reduced, most_states);
        ASSERT_LE(reduced_graph.size(), all.size()) << "round " << round;
        ASSERT_EQ(has_deadlock(all), has_deadlock(reduced_graph)) << "round " << round;
        if (reduced_graph.size() == all.size()) continue;
        ++smaller;
        if (has_deadlock(all)) ++smaller_with_deadlock;
    }
    std::cout << smaller << " of " << rounds << " with fewer states, " << smaller_with_deadlock
              << " of them with a deadlock\n";
    EXPECT_GT(smaller * 5, rounds);
    EXPECT_GT(smaller_with_deadlock * 10, rounds);
    EXPECT_LT(smaller_with_deadlock * 10, 9 * smaller);
}

/// Returns a verdict as text, with the trace of a violation. The text contains the size of the search if the sizes must
/// agree.
std::string described(const refine::Verdict& verdict, bool with_size) {
    std::string text = std::to_string(static_cast<int>(verdict.outcome)) + verdict.reason;
    if (with_size)
        for (const std::uint64_t size : {verdict.statistics.states, verdict.statistics.transitions,
                                         verdict.statistics.depth, verdict.statistics.chased})
            text += " " + std::to_string(size);
    if (!verdict.counterexample) return text;
    text += " kind " + std::to_string(static_cast<int>(verdict.counterexample->kind)) + ":";
    for (const refine::Step& step : verdict.counterexample->steps) text += " " + std::to_string(step.event);
    text += verdict.counterexample->shortest ? " then" : " at least then";
    for (const refine::Step& step : verdict.counterexample->loop) text += " " + std::to_string(step.event);
    return text;
}

std::vector<std::string> answer_texts(lts::TransitionSystem& specification, lts::TransitionSystem& system,
                                      bool with_size, const refine::Limits& limits) {
    std::vector<std::string> result;
    const auto add = [&](const refine::Verdict& verdict) { result.push_back(described(verdict, with_size)); };
    for (const refine::Model model :
         {refine::Model::traces, refine::Model::failures, refine::Model::failures_divergences})
        add(refine::refines(specification, system, model, limits));
    for (const refine::Model model : {refine::Model::failures, refine::Model::failures_divergences}) {
        add(refine::deadlock_free(system, model, limits));
        add(refine::deterministic(system, model, limits));
    }
    add(refine::divergence_free(system, limits));
    return result;
}

refine::Limits limits_of(bool reduction, unsigned threads) {
    refine::Limits limits;
    limits.reduction = reduction;
    limits.threads = threads;
    if (threads > 1) limits.wide_level = 1;
    return limits;
}

/// Checks every model, with one thread and with several. Counterexamples are the shortest ones of the full state space,
/// found in the same order.
TEST(Reduction, ChangesNoAnswerAndNoRun) {
    const int rounds = refine::wanted_checks(static_cast<int>(tests::rounds(1'000))) / 8 + 1;
    Scripted s;
    for (Event i = 0; i < RandomRules::visible; ++i) s.event("e" + std::to_string(i));
    RandomRules rules(2023);
    int fails = 0;
    for (int round = 0; round < rounds; ++round) {
        SupercombinatorSystem specification(rules.next(s.stop()), s.store);
        SupercombinatorSystem system(rules.next(s.stop()), s.store);
        ASSERT_EQ(answer_texts(specification, system, false, limits_of(true, 1)),
                  answer_texts(specification, system, false, limits_of(false, 1)))
            << "round " << round;
        ASSERT_EQ(answer_texts(specification, system, true, limits_of(true, 3)),
                  answer_texts(specification, system, true, limits_of(true, 1)))
            << "round " << round;
        if (refine::deadlock_free(system, refine::Model::failures, limits_of(true, 1)).counterexample) ++fails;
    }
    EXPECT_GT(fails * 20, rounds);
    EXPECT_LT(fails * 20, 19 * rounds);
}

/// Six processes perform four hidden steps each, and then one event together. They have 5^6 states. After the
/// reduction, at most the states on one path through the hidden steps remain.
class HiddenSteps : public testing::Test {
protected:
    HiddenSteps() {
        std::vector<TermId> chains;
        for (int i = 0; i < 6; ++i) {
            TermId chain = s.prefix("go", s.stop());
            for (int step = 0; step < 4; ++step) chain = s.prefix("h" + std::to_string(i), chain);
            chains.push_back(chain);
        }
        const TermId term =
            s.over(Op::hide, {s.over(Op::parallel, chains, {"go"})}, {"h0", "h1", "h2", "h3", "h4", "h5"});
        whole = compiler.compile(term, diagnostics::unlimited);
        nothing = compiler.compile(s.over(Op::parallel, {s.stop(), s.stop()}, {}), diagnostics::unlimited);
    }
    refine::Verdict ask(bool reduction, std::uint64_t max_states) {
        refine::Limits limits = limits_of(reduction, 1);
        limits.max_states = max_states;
        return refine::refines(*nothing, *whole, refine::Model::traces, limits);
    }

    Scripted s;
    process::OperationalSemantics semantics{s.store};
    Compiler compiler{semantics};
    std::unique_ptr<SupercombinatorSystem> whole, nothing;
};

TEST_F(HiddenSteps, AreFollowed) {
    EXPECT_EQ(ask(false, 1'000'000).statistics.states, 15'625U);
    const refine::Verdict verdict = ask(true, 1'000'000);
    EXPECT_EQ(verdict.outcome, refine::Outcome::fails);
    EXPECT_EQ(verdict.statistics.states, 1U);  // the state in which all hidden steps are done
    EXPECT_EQ(verdict.statistics.chased, 24U);
    ASSERT_TRUE(verdict.counterexample);
    EXPECT_TRUE(verdict.counterexample->shortest);
    EXPECT_EQ(verdict.counterexample->steps.size(), 25U);
}

/// The reduced search needs one state for the verdict. The search for a shortest counterexample visits all states.
TEST_F(HiddenSteps, CounterexampleMayBeLongerIfALimitIsReached) {
    EXPECT_EQ(ask(false, 100).outcome, refine::Outcome::inconclusive);
    const refine::Verdict verdict = ask(true, 100);
    EXPECT_EQ(verdict.outcome, refine::Outcome::fails);
    ASSERT_TRUE(verdict.counterexample);
    EXPECT_FALSE(verdict.counterexample->shortest);
    ASSERT_EQ(verdict.counterexample->steps.size(), 25U);
    EXPECT_EQ(verdict.counterexample->steps.back().event, s.event("go"));
}

TEST(Reduction, KeepsRandomProcesses) {
    const int comparisons = refine::wanted_checks(60);
    refine::RandomCases cases(22);
    Seen seen;
    int compared = 0;
    while (compared < comparisons) {
        const refine::RandomCases::Explored explored = cases.next();
        for (const refine::naive::Process& main : explored.test_case.script.mains) {
            refine::Translation translation(explored.test_case.script);
            Compiler compiler(translation.semantics());
            const auto whole = compiler.compile(translation.term(main), diagnostics::unlimited);
            if (!whole) continue;
            ++compared;
            ASSERT_TRUE(keeps_everything(*whole, seen)) << show(explored.test_case.script);
        }
    }
    std::cout << seen.smaller << " of " << compared << " with fewer states, " << seen.diverging
              << " of them divergent; states " << seen.states << ", kept " << seen.reduced_states << "\n";
    EXPECT_GT(seen.smaller * 10, compared);
}

}  // namespace
}  // namespace robochart::machine
