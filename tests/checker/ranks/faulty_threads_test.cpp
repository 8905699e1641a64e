// SPDX-License-Identifier: Apache-2.0
// Tests searches by programs with several threads each. If one thread fails, all threads of all programs end.
#include <gtest/gtest.h>

#include <array>
#include <atomic>

#include "checker/lts/graph.hpp"
#include "checker/refine/levels/thread_exchange.hpp"
#include "tests/checker/processes/thread_programs.hpp"
#include "tests/checker/ranks/faulty_exchange.hpp"

namespace robochart::ranks {
namespace {

using refine::LevelQuestion;
using refine::Violation;
using refine::ViolationKind;

/// Returns a binary tree of seven states. Its leaves return to the root by `back`, or have no transitions if there is
/// no such event.
lts::Graph tree(std::optional<process::Event> back) {
    lts::Graph graph;
    for (std::uint32_t state = 0; state < 7; ++state) {
        for (const std::uint32_t child : {2 * state + 1, 2 * state + 2})
            if (child < 7) graph.add_edge({process::tau, child});
        if (state >= 3 && back) graph.add_edge({*back, 0});
        graph.finish_state();
    }
    return graph;
}

/// The result of a search by two programs with two threads, in which the exchange of one thread fails at the given
/// call. It says whether the call was reached, and how many threads ended with an answer.
struct Ended {
    std::optional<Violation> found;
    bool failed = false, threw = false;
    unsigned answers = 0;
};

Ended search(const lts::Graph& graph, const LevelQuestion& question, unsigned failing, std::uint64_t call) {
    Ended ended;
    std::atomic<unsigned> answers{0};
    const process::EventTable events;
    const refine::Limits limits;
    const auto fault = call % 2 == 0 ? FaultyExchange::Fault::error : FaultyExchange::Fault::memory;
    try {
        refine::as_programs(2, 2, [&](refine::Exchange& real) {
            const bool fails = real.rank() == failing;
            FaultyExchange faulty(real, fails ? call : ~std::uint64_t{0}, fault);
            lts::GraphSystem system(graph, events);
            refine::Budget budget(limits);
            refine::Statistics statistics;
            try {
                auto found = refine::search_as_rank(system, question, faulty, budget, statistics);
                ++answers;
                if (real.rank() == 0) ended.found = std::move(found);
            } catch (...) {
                if (fails) ended.failed = faulty.has_failed();
                throw;
            }
        });
    } catch (const std::logic_error&) {
        ended.threw = true;
    } catch (const std::bad_alloc&) {
        ended.threw = true;
    }
    ended.answers = answers;
    return ended;
}

class FaultyThreads : public testing::Test {
protected:
    /// Lets each thread fail at each of its calls.
    static void fail_everywhere(const lts::Graph& graph, std::optional<ViolationKind> expected) {
        LevelQuestion question;
        question.kind = LevelQuestion::Kind::deadlock;
        question.divergence = true;
        for (unsigned failing = 0; failing < 4; ++failing)
            for (std::uint64_t call = 0;; ++call) {
                ASSERT_LT(call, 10'000U);
                const Ended ended = search(graph, question, failing, call);
                ASSERT_EQ(ended.threw, ended.failed) << call;
                if (ended.failed) {
                    ASSERT_EQ(ended.answers, 0U) << "rank " << failing << ", call " << call;
                    continue;
                }
                EXPECT_EQ(ended.answers, 4U);
                EXPECT_GT(call, 10U);  // the call number exceeds the number of calls
                ASSERT_EQ(ended.found.has_value(), expected.has_value());
                if (expected) {
                    EXPECT_EQ(ended.found->kind, *expected);
                }
                break;
            }
    }
};

TEST_F(FaultyThreads, EndAllWhereNothingIsFound) {
    fail_everywhere(tree(process::Event{5}), {});
}

TEST_F(FaultyThreads, EndAllWhereADeadlockIsFound) {
    fail_everywhere(tree({}), ViolationKind::deadlock);
}

TEST_F(FaultyThreads, EndAllWhereADivergenceIsFound) {
    fail_everywhere(tree(process::tau), ViolationKind::divergence);
}

/// A system that can be copied only once. This copy shows that copies are possible, but later attempts to copy fail.
class OnceMore final : public lts::TransitionSystem {
public:
    OnceMore(const lts::Graph& graph, const process::EventTable& events) : graph_(graph), system_(graph, events) {}
    [[nodiscard]] std::size_t width() const override { return 1; }
    void initial(std::span<lts::Word> state) override { system_.initial(state); }
    void successors(lts::StateView state, lts::SuccessorSink& sink) override { system_.successors(state, sink); }
    [[nodiscard]] std::unique_ptr<lts::TransitionSystem> clone_for_thread() const override {
        if (asked_.exchange(true)) return nullptr;
        return std::make_unique<lts::GraphSystem>(graph_, system_.events());
    }
    [[nodiscard]] const process::EventTable& events() const override { return system_.events(); }
    [[nodiscard]] std::string describe(lts::StateView state) const override { return system_.describe(state); }

private:
    const lts::Graph& graph_;
    lts::GraphSystem system_;
    mutable std::atomic<bool> asked_{false};
};

/// All threads learn of the error, so they can start another search.
TEST_F(FaultyThreads, LeaveTogetherWhereAThreadHasNoSystem) {
    const lts::Graph graph = tree(process::Event{5});
    const process::EventTable events;
    OnceMore once(graph, events);
    EXPECT_EQ(refine::threads_for(once, 1), 1U);
    EXPECT_EQ(refine::threads_for(once, 4), 4U);
    EXPECT_EQ(refine::threads_for(once, 4), 1U);
    std::array<bool, 2> left{}, failed{};
    refine::as_ranks(2, [&](refine::Exchange& programs) {
        lts::GraphSystem other(graph, events);
        lts::TransitionSystem& system = programs.rank() == 0 ? static_cast<lts::TransitionSystem&>(other) : once;
        const refine::Limits limits;
        refine::Budget budget(limits);
        refine::Statistics statistics;
        try {
            refine::search_by_threads(programs, 2, system, {}, budget, statistics);
        } catch (const std::logic_error&) {
            failed[programs.rank()] = true;
        } catch (const refine::RankFailed& error) {
            EXPECT_STREQ(error.what(), "rank 3: the system serves one thread only");
        }
        left[programs.rank()] = programs.left_together();
    });
    EXPECT_EQ(failed, (std::array{false, true}));
    EXPECT_EQ(left, (std::array{true, true}));
}

}  // namespace
}  // namespace robochart::ranks
