// SPDX-License-Identifier: Apache-2.0
// Tests level searches, with threads as ranks and with programs of several ranks each. They must have the answers,
// figures and lengths of counterexamples of the ordinary search. The counterexample must be the same for every number
// of ranks. The tests use random rules and families of known size.
#include <gtest/gtest.h>

#include <iostream>

#include "checker/machine/compiler.hpp"
#include "checker/refine/levels/thread_exchange.hpp"
#include "checker/refine/verdict/check.hpp"
#include "checker/refine/verdict/level_strategy.hpp"
#include "tests/checker/machine/random_rules.hpp"
#include "tests/checker/process/scripted.hpp"
#include "tests/checker/processes/random_cases.hpp"
#include "tests/checker/processes/thread_programs.hpp"
#include "tests/rounds.hpp"

namespace robochart::machine {
namespace {

using process::Op;
using process::Scripted;
using refine::Outcome;
using refine::Verdict;

std::string words(const std::vector<refine::Step>& steps) {
    std::string text;
    for (const refine::Step& step : steps)
        text += " " + std::to_string(step.event) + "/" + std::to_string(step.revealed) + ">" + step.state;
    return text;
}

/// Returns everything that must be the same for every number of ranks.
std::string verdict_text(const Verdict& verdict) {
    const refine::Statistics& size = verdict.statistics;
    std::string text = std::to_string(static_cast<int>(verdict.outcome)) + verdict.reason;
    for (const std::uint64_t figure : {size.states, size.transitions, size.depth, size.chased, size.spec_nodes})
        text += " " + std::to_string(figure);
    if (!verdict.counterexample) return text;
    return text + " kind " + std::to_string(static_cast<int>(verdict.counterexample->kind)) + ":" +
           words(verdict.counterexample->steps) + " then" + words(verdict.counterexample->loop);
}

/// Returns everything that must be the same as in the ordinary search. The figures belong to it only if all states are
/// visited.
std::string in_common(const Verdict& verdict) {
    const refine::Statistics& size = verdict.statistics;
    std::string text = std::to_string(static_cast<int>(verdict.outcome)) + verdict.reason;
    if (verdict.outcome == Outcome::holds)
        for (const std::uint64_t figure : {size.states, size.transitions, size.depth, size.chased})
            text += " " + std::to_string(figure);
    if (!verdict.counterexample) return text;
    return text + " kind " + std::to_string(static_cast<int>(verdict.counterexample->kind)) + " after " +
           std::to_string(verdict.counterexample->steps.size());
}

using Ask = std::function<Verdict(const refine::Limits&)>;

/// Returns all questions about the two systems.
std::vector<Ask> questions(lts::TransitionSystem& specification, lts::TransitionSystem& system) {
    std::vector<Ask> all;
    for (const refine::Model model :
         {refine::Model::traces, refine::Model::failures, refine::Model::failures_divergences})
        all.push_back(
            [&, model](const refine::Limits& limits) { return refine::refines(specification, system, model, limits); });
    for (const refine::Model model : {refine::Model::failures, refine::Model::failures_divergences}) {
        all.push_back(
            [&, model](const refine::Limits& limits) { return refine::deadlock_free(system, model, limits); });
        all.push_back(
            [&, model](const refine::Limits& limits) { return refine::deterministic(system, model, limits); });
    }
    all.push_back([&](const refine::Limits& limits) { return refine::divergence_free(system, limits); });
    return all;
}

TEST(LevelSearch, FindsTheSameForEveryNumberOfRanks) {
    const int rounds = refine::wanted_checks(static_cast<int>(tests::rounds(1'000))) / 50 + 1;
    Scripted s;
    for (Event i = 0; i < RandomRules::visible; ++i) s.event("e" + std::to_string(i));
    RandomRules rules(2027);
    int fails = 0, decided = 0;
    for (int round = 0; round < rounds; ++round) {
        SupercombinatorSystem specification(rules.next(s.stop()), s.store);
        SupercombinatorSystem system(rules.next(s.stop()), s.store);
        for (const bool reduction : {false, true}) {
            for (const Ask& ask : questions(specification, system)) {
                refine::Limits limits;
                limits.reduction = reduction;
                const Verdict ordinary = ask(limits);
                std::string first;
                for (const auto& [programs, threads] :
                     std::vector<std::pair<unsigned, unsigned>>{{1, 1}, {1, 3}, {3, 1}, {2, 2}, {2, 3}}) {
                    refine::ThreadPrograms strategy(programs, threads);
                    limits.by_levels = &strategy;
                    const Verdict verdict = ask(limits);
                    const std::string by = "round " + std::to_string(round) + ", programs " + std::to_string(programs) +
                                           ", threads of each " + std::to_string(threads);
                    ASSERT_EQ(in_common(verdict), in_common(ordinary)) << by;
                    if (first.empty()) first = verdict_text(verdict);
                    ASSERT_EQ(verdict_text(verdict), first) << by;
                }
                ++decided;
                fails += ordinary.outcome == Outcome::fails ? 1 : 0;
            }
        }
    }
    std::cout << decided << " questions, " << fails << " fail\n";
    EXPECT_GT(fails * 20, decided);
    EXPECT_LT(fails * 20, 19 * decided);
}

class LevelFamilies : public testing::Test {
protected:
    std::unique_ptr<SupercombinatorSystem> cells(int count) {
        std::vector<TermId> all;
        for (int cell = 0; cell < count; ++cell) {
            const std::string name = std::to_string(cell);
            all.push_back(s.cycle("C" + name, {"a" + name, "b" + name, "c" + name, "d" + name}));
        }
        return compiler.compile(s.over(Op::parallel, all, {}), diagnostics::unlimited);
    }

    Scripted s;
    process::OperationalSemantics semantics{s.store};
    Compiler compiler{semantics};
};

/// Eight cells of four states have 4^8 states with eight transitions each, and 8 * 3 levels after the first. Each level
/// needs several rounds.
TEST_F(LevelFamilies, CountsAllStatesOfIndependentCells) {
    const auto system = cells(8);
    for (const unsigned ranks : {1U, 2U, 3U}) {
        refine::ThreadRanks strategy(ranks);
        refine::Limits limits;
        limits.by_levels = &strategy;
        const Verdict verdict = refine::deadlock_free(*system, refine::Model::failures_divergences, limits);
        EXPECT_EQ(verdict.outcome, Outcome::holds);
        EXPECT_EQ(verdict.statistics.states, 65'536U);
        EXPECT_EQ(verdict.statistics.transitions, 8 * 65'536U);
        EXPECT_EQ(verdict.statistics.depth, 24U);
        EXPECT_EQ(verdict.statistics.ranks, ranks);
    }
    refine::ThreadPrograms strategy(2, 3);
    refine::Limits limits;
    limits.by_levels = &strategy;
    const Verdict verdict = refine::deadlock_free(*system, refine::Model::failures_divergences, limits);
    EXPECT_EQ(verdict.statistics.states, 65'536U);
    EXPECT_EQ(verdict.statistics.transitions, 8 * 65'536U);
    EXPECT_EQ(verdict.statistics.ranks, 6U);
}

TEST_F(LevelFamilies, EndAtALimitTogether) {
    const auto system = cells(8);
    for (const unsigned programs : {1U, 2U}) {
        refine::ThreadPrograms strategy(programs, 2);
        refine::Limits limits;
        limits.by_levels = &strategy;
        limits.max_states = 10'000;
        const Verdict verdict = refine::deadlock_free(*system, refine::Model::failures, limits);
        EXPECT_EQ(verdict.outcome, Outcome::inconclusive);
        EXPECT_EQ(verdict.reason, "the limit of 10000 states was reached");
        limits.max_states = 100'000;
        limits.interrupted = [] { return true; };
        EXPECT_EQ(refine::deadlock_free(*system, refine::Model::failures, limits).outcome, Outcome::inconclusive);
    }
}

TEST(ThreadRanks, ARankThatFailsEndsAll) {
    for (unsigned failing = 0; failing < 3; ++failing) {
        const auto work = [failing](refine::Exchange& exchange) {
            if (exchange.rank() == failing) throw std::logic_error("broken");
            std::uint64_t values[1] = {1};
            exchange.sum(values);
        };
        EXPECT_THROW(refine::as_ranks(3, work), std::logic_error);
    }
}

/// As one of `count` ranks, sends to each rank r a message of r words, which identify the sender.
void exchange_everything(refine::Exchange& exchange, unsigned count) {
    const unsigned rank = exchange.rank();
    ASSERT_EQ(exchange.ranks(), count);
    refine::Messages out(count), in(count);
    for (int round = 0; round < 3; ++round) {
        out.words.clear();
        for (unsigned to = 0; to < count; ++to) {
            out.words.push_back(99);  // an additional word, which belongs to no message
            out.begins[to] = out.words.size();
            out.sizes[to] = to;
            out.words.insert(out.words.end(), to, 10 * rank + to);
        }
        exchange.all_to_all(out, in);
        for (unsigned from = 0; from < count; ++from)
            EXPECT_EQ(refine::Words(in.message_of(from).begin(), in.message_of(from).end()),
                      refine::Words(rank, 10 * from + rank));
        std::uint64_t values[2] = {rank, 1};
        exchange.sum(values);
        EXPECT_EQ(values[0], count * (count - 1) / 2);
        EXPECT_EQ(values[1], count);
        std::vector<refine::Words> gathered;
        for (unsigned from = 0; from < count; ++from) gathered.emplace_back(from, from);
        EXPECT_EQ(exchange.gather(refine::Words(rank, rank)), gathered);
        std::string text = "rank " + std::to_string(rank);
        exchange.broadcast(text);
        EXPECT_EQ(text, "rank 0");
    }
    // A rank sends messages to every rank except itself and rank 0, for which the message is empty.
    EXPECT_EQ(exchange.traffic().messages, 3 * (count - (rank == 0 ? 1 : 2)));
}

TEST(ThreadRanks, ExchangeRowsSumsAndTexts) {
    refine::as_ranks(3, [](refine::Exchange& exchange) { exchange_everything(exchange, 3); });
}

/// Checks that each program sends one message per round, which begins with a number for each pair of threads.
void exchange_by_programs(unsigned programs, unsigned threads) {
    refine::as_ranks(programs, [=](refine::Exchange& exchange) {
        refine::as_ranks(exchange, threads, [=](refine::Exchange& rank_exchange) {
            EXPECT_EQ(rank_exchange.ranks_here(), threads);
            exchange_everything(rank_exchange, programs * threads);
        });
        EXPECT_EQ(exchange.traffic().rounds, programs == 1 ? 0U : 3U);
        EXPECT_EQ(exchange.traffic().messages, 3 * (programs - 1));
        std::uint64_t words = 0;
        for (unsigned to = 0; to < programs * threads; ++to)
            if (to / threads != exchange.rank()) words += to * threads + threads;
        EXPECT_EQ(exchange.traffic().bytes, 3 * words * sizeof(lts::Word));
    });
}

TEST(ThreadPrograms, SendOneMessageToEachOtherProgram) {
    exchange_by_programs(1, 3);
    exchange_by_programs(2, 2);
    exchange_by_programs(3, 2);
    exchange_by_programs(2, 3);
}

/// An error in one thread ends all threads of all programs, including threads that wait for others.
TEST(ThreadPrograms, AThreadThatFailsEndsAll) {
    for (unsigned failing = 0; failing < 6; ++failing) {
        const auto work = [failing](refine::Exchange& exchange) {
            if (exchange.rank() == failing) throw std::logic_error("broken");
            std::uint64_t values[1] = {1};
            exchange.sum(values);
            ADD_FAILURE() << "rank " << exchange.rank() << " has a sum without that of rank " << failing;
        };
        EXPECT_THROW(refine::as_programs(3, 2, work), std::logic_error);
    }
}

}  // namespace
}  // namespace robochart::machine
