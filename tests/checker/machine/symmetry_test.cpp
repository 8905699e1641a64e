// SPDX-License-Identifier: Apache-2.0
// Tests symmetry reduction. Equal components of a compiled process are found, permutations of them are automorphisms,
// and the reduced state space gives the same answers as the full one.
#include <gtest/gtest.h>

#include <iostream>

#include "checker/machine/compiler.hpp"
#include "checker/refine/verdict/check.hpp"
#include "tests/checker/processes/random_cases.hpp"
#include "tests/checker/processes/translate.hpp"
#include "tests/rounds.hpp"

namespace robochart::machine {
namespace {

using process::Op;
using process::Scripted;
using refine::Outcome;
using refine::Verdict;

refine::Limits limits_of(bool reduction) {
    refine::Limits limits;
    limits.reduction = reduction;
    limits.threads = 1;
    return limits;
}

class SymmetryTest : public testing::Test {
protected:
    /// Returns a process that performs `own` events in turn between tocks. Its number is part of the names of these
    /// events.
    TermId robot(int number, int own) {
        const TermId robot = s.name("ROBOT" + std::to_string(number));
        TermId body = s.prefix("tock", robot);
        for (int i = own; i > 0; --i) body = s.prefix(event(number, i), body);
        s.bind(robot, body);
        return robot;
    }
    static std::string event(int number, int i) { return "e" + std::to_string(i) + "." + std::to_string(number); }
    std::vector<TermId> robots(int number, int own) {
        std::vector<TermId> result;
        for (int i = 1; i <= number; ++i) result.push_back(robot(i, own));
        return result;
    }
    TermId swarm(int number, int own) { return s.over(Op::parallel, robots(number, own), {"tock"}); }
    TermId hidden_swarm(int number, int own) {
        std::vector<std::string> hidden;
        for (int i = 1; i <= number; ++i)
            for (int j = 1; j <= own; ++j) hidden.push_back(event(i, j));
        return s.over(Op::hide, {swarm(number, own)}, hidden);
    }
    std::unique_ptr<SupercombinatorSystem> compiled(TermId term) {
        return compiler.compile(term, diagnostics::unlimited);
    }
    /// Returns the number of replicas in each set.
    std::vector<std::size_t> sets(TermId term) {
        std::vector<std::size_t> result;
        for (const lts::ReplicaSet& set : compiled(term)->replicas(diagnostics::unlimited))
            result.push_back(set.size());
        return result;
    }

    /// Decides whether the system refines a process that can always perform every event of n robots with k steps each.
    /// The check visits every state.
    Verdict refines_everything(lts::TransitionSystem& system, int n, int k, bool reduction) {
        const TermId any = s.name("ANY");
        std::vector<std::pair<std::string, TermId>> branches{{"tock", any}};
        for (int i = 1; i <= n; ++i)
            for (int step = 1; step <= k; ++step) branches.emplace_back(event(i, step), any);
        s.bind(any, s.menu(branches));
        process::TermSystem specification(semantics, any);
        return refine::refines(specification, system, refine::Model::traces, limits_of(reduction));
    }

    Scripted s;
    process::OperationalSemantics semantics{s.store};
    Compiler compiler{semantics};
};

using Sets = std::vector<std::size_t>;

/// n robots with k states each share only tock. Their states are multisets of n elements out of k, so there are (n+k-1
/// over n).
TEST_F(SymmetryTest, StatesAreMultisets) {
    const auto system = compiled(swarm(6, 3));
    EXPECT_EQ(refines_everything(*system, 6, 3, false).statistics.states, 4096U);
    const Verdict verdict = refines_everything(*system, 6, 3, true);
    EXPECT_EQ(verdict.outcome, Outcome::holds);
    EXPECT_EQ(verdict.statistics.states, 84U);
    EXPECT_EQ(verdict.statistics.replicas, 6U);
    EXPECT_EQ(verdict.statistics.distinguished, 0U);
}

/// The robots are those of benchmarks/models/robots.csp.
TEST_F(SymmetryTest, TwelveRobotsOfEightStates) {
    const auto system = compiled(swarm(12, 7));
    const Verdict verdict = refines_everything(*system, 12, 7, true);
    EXPECT_EQ(verdict.outcome, Outcome::holds);
    EXPECT_EQ(verdict.statistics.states, 50'388U) << "(12 + 7 over 7), of 8^12";
}

/// Robots of two components are permuted as wholes. Equal components inside a robot are ignored.
TEST_F(SymmetryTest, ReplicasMayHaveSeveralComponents) {
    std::vector<TermId> pairs;
    for (int i = 1; i <= 3; ++i)
        pairs.push_back(s.over(Op::parallel, {robot(i, 2), s.prefix(event(i, 1), robot(i, 1))}, {event(i, 1)}));
    EXPECT_EQ(sets(s.over(Op::parallel, pairs, {"tock"})), Sets{3});
}

TEST_F(SymmetryTest, WhatDiffersIsNoReplica) {
    std::vector<TermId> different = robots(3, 2);
    different.push_back(robot(4, 3));
    EXPECT_EQ(sets(s.over(Op::parallel, different, {"tock"})), Sets{3}) << "one with a state more";
    different.back() = s.prefix("tock", robot(5, 2));
    EXPECT_EQ(sets(s.over(Op::parallel, different, {"tock"})), Sets{3}) << "one that begins later";
    EXPECT_EQ(sets(s.over(Op::hide, {swarm(3, 2)}, {event(2, 1)})), Sets{2}) << "one whose event is hidden";
    EXPECT_EQ(sets(s.prioritise(swarm(3, 2), {{event(3, 1)}, {"tock"}})), Sets{2}) << "one whose event comes first";
    std::vector<TermId> watched{swarm(3, 2), s.prefix(event(1, 1), s.stop())};
    EXPECT_EQ(sets(s.over(Op::parallel, watched, {event(1, 1)})), Sets{2}) << "one that another one watches";
}

/// Random tests found this error: the packed state of a component that always runs cannot represent that another
/// component is off.
TEST_F(SymmetryTest, ComponentsThatMayBeOffAreNoReplicasOfPermanentOnes) {
    const TermId never = s.over(Op::parallel, {s.stop(), s.stop()}, {});
    const TermId first = s.op(Op::exception, {never, s.skip()}, static_cast<std::uint32_t>(s.set({})));
    const auto system = compiled(s.over(Op::parallel, {first, s.skip()}, {}));
    for (const bool reduction : {false, true})
        EXPECT_EQ(refine::deadlock_free(*system, refine::Model::failures, limits_of(reduction)).outcome,
                  Outcome::fails);
    EXPECT_EQ(sets(s.over(Op::parallel, {first, s.skip()}, {})), Sets{});
}

TEST_F(SymmetryTest, WhatIsAlikeIsFoundUnderPrioritiesAndInterrupts) {
    EXPECT_EQ(sets(s.prioritise(hidden_swarm(3, 2), {{"tock"}})), Sets{3});
    EXPECT_EQ(sets(s.op(Op::interrupt, {hidden_swarm(3, 2), s.prefix("stop", s.skip())})), Sets{3});
    std::vector<TermId> urgent;
    for (int i = 1; i <= 3; ++i) {
        const TermId two =
            s.over(Op::parallel, {robot(i, 90), s.over(Op::parallel, {robot(i, 40), robot(i, 30)}, {})}, {});
        urgent.push_back(s.prioritise(two, {{event(i, 1)}, {"tock"}}));
    }
    EXPECT_EQ(sets(s.over(Op::parallel, urgent, {"tock"})), Sets{3}) << "regions of their own";
}

/// A specification that requires robot 1 before robot 2 distinguishes them. A specification that accepts any robot does
/// not.
TEST_F(SymmetryTest, TheSpecificationMayDistinguishThem) {
    const auto system = compiled(s.over(Op::hide, {swarm(3, 1)}, {"tock"}));
    const TermId first = s.name("FIRST");
    s.bind(first, s.menu({{event(1, 1), first}, {event(2, 1), first}}));
    process::TermSystem distinguishing(semantics, first);
    const Verdict apart = refine::refines(distinguishing, *system, refine::Model::traces, limits_of(true));
    EXPECT_EQ(apart.outcome, Outcome::fails);
    EXPECT_EQ(apart.statistics.replicas, 2U);
    EXPECT_EQ(apart.statistics.distinguished, 3U);
    ASSERT_TRUE(apart.counterexample);
    EXPECT_EQ(apart.counterexample->event, s.event(event(3, 1)));

    const TermId any = s.name("ANY");
    s.bind(any, s.menu({{event(1, 1), any}, {event(2, 1), any}, {event(3, 1), any}}));
    process::TermSystem indifferent(semantics, any);
    for (const refine::Model model : {refine::Model::traces, refine::Model::failures}) {
        const Verdict verdict = refine::refines(indifferent, *system, model, limits_of(true));
        EXPECT_EQ(verdict.statistics.replicas, 3U);
        EXPECT_EQ(verdict.outcome, model == refine::Model::traces ? Outcome::holds : Outcome::fails);
    }
}

/// After an event of any robot, the specification forbids a second event of the same robot. So the second event shows
/// which robot it is.
TEST_F(SymmetryTest, RunsHaveEveryReplicaInItsPlace) {
    const auto system = compiled(swarm(4, 2));
    const TermId one = s.name("ONE");
    std::vector<std::pair<std::string, TermId>> branches;
    for (int i = 1; i <= 4; ++i) branches.emplace_back(event(i, 1), one);
    s.bind(one, s.menu(branches));
    process::TermSystem specification(semantics, one);
    const Verdict reduced = refine::refines(specification, *system, refine::Model::traces, limits_of(true));
    const Verdict whole = refine::refines(specification, *system, refine::Model::traces, limits_of(false));
    EXPECT_EQ(reduced.statistics.replicas, 4U);
    ASSERT_TRUE(reduced.counterexample);
    ASSERT_EQ(reduced.counterexample->steps.size(), 2U);
    EXPECT_EQ(whole.counterexample->steps.size(), 2U);
    // The counterexample was already replayed, so it only remains to check that the second event of a robot follows its
    // own first event.
    const auto number = [&](const refine::Step& step) { return s.events.name(step.event).substr(3); };
    EXPECT_EQ(number(reduced.counterexample->steps[0]), number(reduced.counterexample->steps[1]));
}

/// In this loop of taus the replicas take turns. The loop closes when each replica is in its original place again.
TEST_F(SymmetryTest, LoopsAreClosed) {
    const auto system = compiled(hidden_swarm(3, 2));
    const auto endless =
        compiled(s.over(Op::hide, {swarm(3, 2)},
                        {event(1, 1), event(1, 2), event(2, 1), event(2, 2), event(3, 1), event(3, 2), "tock"}));
    for (const bool reduction : {false, true}) {
        EXPECT_EQ(refine::divergence_free(*system, limits_of(reduction)).outcome, Outcome::holds);
        const Verdict verdict = refine::divergence_free(*endless, limits_of(reduction));
        ASSERT_EQ(verdict.outcome, Outcome::fails);
        EXPECT_EQ(verdict.counterexample->loop.size(), 7U) << "six hidden events and tock";
    }
}

/// Random processes in parallel with copies of themselves, with and without renaming. The answers are compared with the
/// definitions.
class RandomReplicas : public testing::Test {
protected:
    using Process = refine::naive::Process;
    using Tree = refine::naive::Tree;
    using Kind = refine::naive::Kind;

    static Process tree(Kind kind, std::vector<Process> operands, std::set<int> set = {},
                        std::vector<std::pair<int, int>> renaming = {}) {
        Tree made;
        made.kind = kind;
        made.operands = std::move(operands);
        made.set = std::move(set);
        made.renaming = std::move(renaming);
        return std::make_shared<const Tree>(std::move(made));
    }
    static Process exchanged(const Process& process) { return tree(Kind::rename, {process}, {}, {{0, 1}, {1, 0}}); }
    static Process make_parallel(std::vector<Process> operands) {
        return tree(Kind::parallel, std::move(operands), {2});
    }

    /// Composes copies of a random process so that parts can be permuted.
    static Process replicated(const Process& process, int way) {
        switch (way % 4) {
            case 0:
                return make_parallel({process, process});
            case 1:
                return make_parallel({process, exchanged(process)});
            case 2:
                return tree(Kind::hide, {make_parallel({process, process, process})}, {0});
            default:
                return make_parallel({process, make_parallel({exchanged(process), process})});
        }
    }

    /// Returns the first difference between the engine's answers and the definitions, or "" if there is none.
    std::string find_disagreement(const refine::Case& test_case, const refine::Graphs& graphs) {
        refine::Translation translation(test_case.script);
        Compiler compiler(translation.semantics());
        const auto system = compiler.compile(translation.term(test_case.script.mains[1]), diagnostics::unlimited);
        if (!system) return "";
        process::TermSystem left = translation.system(test_case.script.mains[0]);
        ++compared_;
        for (const refine::Question& question : refine::questions()) {
            if (question.kind == refine::Question::Kind::has_trace || question.right != 1) continue;
            if (question.kind != refine::Question::Kind::refinement && question.left != 1) continue;
            const Verdict verdict = ask(question, left, *system);
            folded_ += verdict.statistics.replicas > 0 ? 1 : 0;
            distinguished_ += verdict.statistics.distinguished > 0 ? 1 : 0;
            const bool holds = refine::expected(question, graphs, test_case.trace);
            if (verdict.outcome != (holds ? Outcome::holds : Outcome::fails))
                return refine::assertion(question, test_case.trace) + (holds ? " should hold" : " should fail");
            fails_ += holds ? 0 : 1;
        }
        return "";
    }
    static refine::Model model_of(refine::naive::Semantics semantics) {
        using Semantics = refine::naive::Semantics;
        switch (semantics) {
            case Semantics::T:
                return refine::Model::traces;
            case Semantics::F:
                return refine::Model::failures;
            case Semantics::FD:
                break;
        }
        return refine::Model::failures_divergences;
    }
    /// Decides a question that has no trace.
    static Verdict ask(const refine::Question& question, lts::TransitionSystem& left, lts::TransitionSystem& right) {
        const refine::Model model = model_of(question.semantics);
        switch (question.kind) {
            case refine::Question::Kind::refinement:
                return refine::refines(left, right, model, limits_of(true));
            case refine::Question::Kind::deadlock_free:
                return refine::deadlock_free(right, model, limits_of(true));
            case refine::Question::Kind::divergence_free:
                return refine::divergence_free(right, limits_of(true));
            case refine::Question::Kind::deterministic:
            case refine::Question::Kind::has_trace:
                break;
        }
        return refine::deterministic(right, model, limits_of(true));
    }

    int compared_ = 0, folded_ = 0, distinguished_ = 0, fails_ = 0;
};

TEST_F(RandomReplicas, AnswerAsTheDefinitionsSay) {
    const int comparisons = refine::wanted_checks(static_cast<int>(tests::rounds(30)));
    refine::RandomCases cases(2019);
    for (int way = 0; compared_ < comparisons; ++way) {
        refine::Case test_case = cases.next().test_case;
        test_case.script.mains[1] = replicated(test_case.script.mains[1], way);
        const auto graphs = refine::explore(test_case, refine::largest_graph);
        if (!graphs) continue;
        ASSERT_EQ(find_disagreement(test_case, *graphs), "") << show(test_case.script);
    }
    std::cout << compared_ << " processes, " << folded_ << " answers by symmetry, " << distinguished_
              << " where the specification distinguishes replicas, " << fails_ << " that something fails\n";
    EXPECT_GT(folded_, comparisons);
    EXPECT_GT(distinguished_ * 20, comparisons);
    EXPECT_GT(fails_, comparisons);
}

}  // namespace
}  // namespace robochart::machine
