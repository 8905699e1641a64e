// SPDX-License-Identifier: Apache-2.0
// Tests searches by several programs. All but the first know only what they receive. The searches must give
// the same answers, figures and counterexamples as one rank.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <new>
#include <random>
#include <span>

#include "checker/machine/compiler.hpp"
#include "checker/machine/transfer.hpp"
#include "checker/process/term_system.hpp"
#include "checker/ranks/job.hpp"
#include "checker/ranks/served_ranks.hpp"
#include "checker/refine/levels/thread_exchange.hpp"
#include "checker/refine/search/steps.hpp"
#include "checker/refine/verdict/check.hpp"
#include "tests/checker/machine/random_rules.hpp"
#include "tests/checker/process/scripted.hpp"
#include "tests/checker/processes/random_cases.hpp"
#include "tests/checker/processes/verdict_text.hpp"
#include "tests/checker/ranks/faulty_exchange.hpp"
#include "tests/checker/ranks/program.hpp"

namespace robochart::ranks {
namespace {

using machine::RandomRules;
using machine::SupercombinatorSystem;
using process::Op;
using process::Scripted;
using process::TermId;
using refine::Outcome;
using refine::Verdict;

using Ask = std::function<std::vector<std::string>(const refine::Limits&)>;

/// Returns the answers of `ask` in the first program while the other programs serve. Each program has this many
/// threads.
std::vector<std::string> by_programs(unsigned programs, unsigned threads, bool reduction, const Ask& ask) {
    std::vector<std::string> answers;
    refine::as_ranks(programs, [&](refine::Exchange& exchange) {
        if (exchange.rank() != 0) return serve_searches(exchange, program);
        ServedRanks strategy(exchange, program);
        refine::Limits limits;
        limits.reduction = reduction;
        limits.threads = threads;
        limits.by_levels = &strategy;
        answers = ask(limits);
    });
    return answers;
}

std::vector<std::string> all_answers(lts::TransitionSystem& specification, lts::TransitionSystem& system,
                                     const refine::Limits& limits) {
    std::vector<std::string> answers;
    for (const refine::Model model :
         {refine::Model::traces, refine::Model::failures, refine::Model::failures_divergences})
        answers.push_back(complete_text(refine::refines(specification, system, model, limits)));
    answers.push_back(complete_text(refine::deadlock_free(system, refine::Model::failures, limits)));
    answers.push_back(complete_text(refine::deterministic(system, refine::Model::failures_divergences, limits)));
    answers.push_back(complete_text(refine::divergence_free(system, limits)));
    return answers;
}

TEST(ServedRanks, AnswerAsOneRankDoes) {
    const int rounds = refine::wanted_checks(1'000) / 50 + 1;
    Scripted s;
    for (process::Event i = 0; i < RandomRules::visible; ++i) s.event("e" + std::to_string(i));
    RandomRules rules(2028);
    for (int round = 0; round < rounds; ++round) {
        SupercombinatorSystem specification(rules.next(s.stop()), s.store);
        SupercombinatorSystem system(rules.next(s.stop()), s.store);
        for (const bool reduction : {false, true}) {
            const auto ask = [&](const refine::Limits& limits) { return all_answers(specification, system, limits); };
            refine::ThreadRanks one(1);
            refine::Limits limits;
            limits.reduction = reduction;
            limits.by_levels = &one;
            const std::vector<std::string> wanted_answers = ask(limits);
            for (const auto& [programs, threads] : std::vector<std::pair<unsigned, unsigned>>{{1, 1}, {3, 1}, {2, 2}})
                ASSERT_EQ(by_programs(programs, threads, reduction, ask), wanted_answers)
                    << "round " << round << ", programs " << programs << ", threads of each " << threads;
        }
    }
}

class Cells : public testing::Test {
protected:
    /// Returns equal cells of four states. The events of each cell have different names.
    TermId cells(int count = 6) {
        std::vector<TermId> all;
        for (int cell = 0; cell < count; ++cell) {
            const std::string name = std::to_string(cell);
            all.push_back(s.cycle("C" + name, {"a" + name, "b" + name, "c" + name, "d" + name}));
        }
        return s.over(Op::parallel, all, {});
    }

    Scripted s;
    process::OperationalSemantics semantics{s.store};
    machine::Compiler compiler{semantics};
};

/// Instead of 4096 states there are 84 multisets of six elements from four. The specification allows every event.
TEST_F(Cells, AreFoldedAtEachRank) {
    const auto system = compiler.compile(cells(), diagnostics::unlimited);
    const TermId any = s.name("ANY");
    std::vector<std::pair<std::string, TermId>> branches;
    for (int cell = 0; cell < 6; ++cell)
        for (const char* const event : {"a", "b", "c", "d"}) branches.emplace_back(event + std::to_string(cell), any);
    s.bind(any, s.menu(branches));
    process::TermSystem specification(semantics, any);
    const auto answers = by_programs(3, 2, true, [&](const refine::Limits& limits) {
        const Verdict verdict = refine::refines(specification, *system, refine::Model::traces, limits);
        EXPECT_EQ(verdict.statistics.states, 84U);
        EXPECT_EQ(verdict.statistics.replicas, 6U);
        EXPECT_EQ(verdict.statistics.ranks, 6U);
        return std::vector{complete_text(verdict)};
    });
    ASSERT_EQ(answers.size(), 1U);
    EXPECT_EQ(answers.front().front(), '0' + static_cast<int>(Outcome::holds));
}

TEST_F(Cells, AsTermsAreSearchedByTheFirstRank) {
    process::TermSystem system(semantics, cells());
    by_programs(2, 2, false, [&](const refine::Limits& limits) {
        const Verdict verdict = refine::deadlock_free(system, refine::Model::failures, limits);
        EXPECT_EQ(verdict.outcome, Outcome::holds);
        EXPECT_EQ(verdict.statistics.states, 4096U);
        EXPECT_EQ(verdict.statistics.ranks, 1U);
        return std::vector<std::string>{};
    });
}

TEST_F(Cells, EndAtLimitsOfTheFirstRank) {
    const auto system = compiler.compile(cells(), diagnostics::unlimited);
    by_programs(2, 2, false, [&](const refine::Limits& given) {
        refine::Limits limits = given;
        limits.max_states = 1000;
        EXPECT_EQ(refine::deadlock_free(*system, refine::Model::failures, limits).reason,
                  "the limit of 1000 states was reached");
        limits.max_states = 10'000;
        limits.interrupted = [] { return true; };
        EXPECT_EQ(refine::deadlock_free(*system, refine::Model::failures, limits).outcome, Outcome::inconclusive);
        limits.interrupted = {};
        EXPECT_EQ(refine::deadlock_free(*system, refine::Model::failures, limits).statistics.states, 4096U);
        return std::vector<std::string>{};
    });
}

/// All programs end, whichever program fails at whichever call. The first program knows that the others wait for it,
/// and starts no further search.
TEST_F(Cells, EndTogetherWhateverProgramFails) {
    const auto system = compiler.compile(cells(2), diagnostics::unlimited);
    for (const unsigned round : {0U, 1U, 2U, 3U})
        for (std::uint64_t call = 0;; ++call) {
            const unsigned failing = round < 2 ? 0 : 2;
            const unsigned threads = 1 + round % 2;
            const auto fault = call % 2 == 0 ? FaultyExchange::Fault::error : FaultyExchange::Fault::memory;
            bool failed = false;
            const auto work = [&](refine::Exchange& real) {
                const bool own = real.rank() == failing;
                FaultyExchange faulty(real, own ? call : ~std::uint64_t{0}, fault);
                if (real.rank() != 0) {
                    serve_searches(faulty, program);
                } else {
                    ServedRanks strategy(faulty, program);
                    refine::Limits limits;
                    limits.threads = threads;
                    limits.by_levels = &strategy;
                    std::string why;
                    try {
                        why = refine::deadlock_free(*system, refine::Model::failures, limits).reason;
                    } catch (const std::logic_error& error) {
                        why = error.what();
                    }
                    if (!faulty.has_failed()) {
                        strategy.end();
                    } else {
                        EXPECT_TRUE(strategy.others_wait()) << call;
                        EXPECT_NE(why, "") << call;
                        EXPECT_EQ(refine::deadlock_free(*system, refine::Model::failures, limits).outcome,
                                  Outcome::inconclusive);
                        failed = true;
                        throw std::runtime_error("the first rank ends");
                    }
                }
                if (own && faulty.has_failed()) failed = true;
            };
            bool all_ended_well = true;
            try {
                refine::as_ranks(3, work);
            } catch (const std::exception&) {
                all_ended_well = false;
            }
            if (all_ended_well) {
                EXPECT_GT(call, 10U);  // the call number exceeds the number of calls
                break;
            }
            ASSERT_LT(call, 10'000U) << failed;
        }
}

std::vector<refine::RunStep> steps(lts::TransitionSystem& system, lts::StateView state) {
    return refine::steps_from(system, state);
}

/// Damaged bytes are rejected, or describe another process that can be searched.
TEST(Transfer, DamagedBytesAreRefusedOrSearched) {
    Scripted s;
    for (process::Event i = 0; i < RandomRules::visible; ++i) s.event("e" + std::to_string(i));
    RandomRules rules(2029);
    std::mt19937 numbers(7);
    int refused = 0;
    for (int round = 0; round < 300; ++round) {
        SupercombinatorSystem system(rules.next(s.stop()), s.store);
        refine::LevelQuestion question;
        question.kind = refine::LevelQuestion::Kind::deadlock;
        question.rows.folder = "/shared/kept/search-0123456789abcdef";
        question.rows.run = "0123456789abcdef";
        question.rows.from = {7, 3, 9};
        refine::Limits limits;
        limits.deadline = std::chrono::steady_clock::now() + std::chrono::hours(1);
        std::string bytes = ranks::encode(system, question, limits, 1, program).value();
        if (round % 3 == 0)
            bytes.resize(numbers() % bytes.size());
        else
            bytes[numbers() % bytes.size()] = static_cast<char>(numbers());
        try {
            const Job job = decode(bytes, s.store);
            std::vector<lts::Word> state(job.system->width());
            job.system->initial(state);
            for (int step = 0; step < 10; ++step) {
                const auto next = steps(*job.system, state);
                if (next.empty()) break;
                state = next[numbers() % next.size()].state;
            }
        } catch (const lts::BadBytes&) {
            ++refused;
        }
    }
    EXPECT_GT(refused, 100);
}

// The other programs also observe the deadline of the first program.
TEST(Transfer, HasTheTimeThatIsLeft) {
    Scripted s;
    for (process::Event i = 0; i < RandomRules::visible; ++i) s.event("e" + std::to_string(i));
    RandomRules rules(2030);
    SupercombinatorSystem system(rules.next(s.stop()), s.store);
    refine::Limits limits;
    EXPECT_FALSE(decode(encode(system, {}, limits, 1, program).value(), s.store).deadline);
    for (const auto left : {std::chrono::hours(-1), std::chrono::hours(0), std::chrono::hours(5)}) {
        const auto now = std::chrono::steady_clock::now();
        limits.deadline = now + left;
        const auto got = decode(encode(system, {}, limits, 1, program).value(), s.store).deadline;
        ASSERT_TRUE(got);
        EXPECT_GE(*got, now + std::max(left, std::chrono::hours(0)));
        EXPECT_LT(*got, now + std::max(left, std::chrono::hours(0)) + std::chrono::hours(1));
    }
}

// Another build may have a different row format, so no search starts, and all programs know the reason.
TEST_F(Cells, AreNotSearchedByProgramsOfOtherBuilds) {
    const auto system = compiler.compile(cells(), diagnostics::unlimited);
    for (const unsigned threads : {1U, 2U})
        refine::as_ranks(3, [&](refine::Exchange& exchange) {
            if (exchange.rank() != 0) return serve_searches(exchange, exchange.rank() == 1 ? program : "another build");
            ServedRanks strategy(exchange, program);
            refine::Limits limits;
            limits.threads = threads;
            limits.by_levels = &strategy;
            for (int search = 0; search < 2; ++search) try {
                    (void)refine::deadlock_free(*system, refine::Model::failures, limits);
                    ADD_FAILURE() << "it is searched";
                } catch (const storage::BadFile& refused) {
                    EXPECT_STREQ(refused.what(),
                                 "program 2 is of another build than program 0: all must be one robochart-verify-mpi");
                }
            EXPECT_FALSE(strategy.others_wait());
        });
}

/// The exchange of a rank that runs out of memory in a sum. The other ranks do not learn of this.
class ShortOfMemory final : public refine::Exchange {
public:
    [[nodiscard]] unsigned rank() const override { return 1; }
    [[nodiscard]] unsigned ranks() const override { return 2; }
    void all_to_all(const refine::Messages& /*out*/, refine::Messages& /*in*/) override {}
    void sum(std::span<std::uint64_t> /*values*/) override { throw std::bad_alloc(); }
    [[nodiscard]] std::vector<refine::Words> gather(const refine::Words& own) override { return {own, own}; }
    void broadcast(std::string& bytes) override {
        bytes = served_ ? "" : "no job";
        served_ = true;
    }

private:
    bool served_ = false;
};

// If other ranks wait for a rank and cannot learn of its error, the rank must not ignore the error.
TEST(Transfer, AnErrorThatOthersDoNotHearOfEndsTheRank) {
    ShortOfMemory exchange;
    EXPECT_THROW(serve_searches(exchange, program), std::bad_alloc);
}

}  // namespace
}  // namespace robochart::ranks
