// SPDX-License-Identifier: Apache-2.0
// Tests AG EF of an event with verdicts by hand. For random processes, compares it with a forward search from each
// state.
#include "checker/refine/verdict/recurrence.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <algorithm>

#include <queue>
#include <random>
#include <set>

#include "checker/process/term_system.hpp"
#include "tests/checker/process/scripted.hpp"

namespace robochart::refine {
namespace {

using process::Event;
using process::Op;
using process::Scripted;
using process::TermId;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

class Recurrence : public testing::Test {
protected:
    Scripted s;
    process::OperationalSemantics semantics{s.store};
    Limits limits;

    Verdict decided(TermId term, const std::vector<std::string>& goal) {
        process::TermSystem system{semantics, term};
        return recurrent(system, s.store[s.set(goal)], limits);
    }
    std::vector<std::string> run_of(const Verdict& verdict) {
        std::vector<std::string> names;
        for (const Step& step : verdict.counterexample.value().steps) names.push_back(s.events.name(step.event));
        return names;
    }
};

TEST_F(Recurrence, WhatIsDoneAgainAndAgain) {
    const TermId turns = s.cycle("Turns", {"a", "b", "c"});
    for (const char* event : {"a", "b", "c"}) EXPECT_EQ(decided(turns, {event}).outcome, Outcome::holds) << event;
    const Verdict never = decided(turns, {"d"});
    EXPECT_EQ(never.outcome, Outcome::fails);
    EXPECT_EQ(never.counterexample.value().kind, ViolationKind::no_return);
    EXPECT_THAT(run_of(never), IsEmpty()) << "not even at the beginning";
    EXPECT_EQ(decided(turns, {}).outcome, Outcome::fails);
}

TEST_F(Recurrence, WhatHappensOnceCannotComeAgain) {
    const TermId once = s.prefix("a", s.cycle("Later", {"b"}));
    EXPECT_EQ(decided(once, {"b"}).outcome, Outcome::holds);
    const Verdict verdict = decided(once, {"a"});
    EXPECT_EQ(verdict.outcome, Outcome::fails);
    EXPECT_THAT(run_of(verdict), ElementsAre("a"));
    EXPECT_EQ(decided(once, {"a", "b"}).outcome, Outcome::holds) << "one of several suffices";
}

/// The goal can become unreachable after two and after three steps. The counterexample shows the shorter path.
TEST_F(Recurrence, TheNearestLossIsShown) {
    const TermId home = s.name("Home");
    const auto back_or = [&](const std::string& event, TermId target) {
        return s.menu({{"a", home}, {event, target}});
    };
    s.bind(home, s.menu({{"b", back_or("b", back_or("b", s.stop()))}, {"c", back_or("d", s.cycle("Lost", {"c"}))}}));
    const Verdict verdict = decided(home, {"a"});
    EXPECT_EQ(verdict.outcome, Outcome::fails);
    EXPECT_THAT(run_of(verdict), ElementsAre("c", "d"));
}

/// The goal is still reachable if one run reaches it, however internal choices are resolved on the way. If one internal
/// choice excludes the goal, the goal is lost.
TEST_F(Recurrence, InternalStepsCount) {
    const TermId good = s.name("Good");
    const TermId rest = s.name("Rest");
    s.bind(rest, s.op(Op::internal_choice, {good, rest}));
    s.bind(good, s.prefix("a", rest));
    EXPECT_EQ(decided(good, {"a"}).outcome, Outcome::holds);
    const TermId either = s.op(Op::internal_choice, {good, s.cycle("Bad", {"b"})});
    EXPECT_EQ(decided(either, {"a"}).outcome, Outcome::fails);
}

TEST_F(Recurrence, ALimitIsNoAnswer) {
    limits.max_states = 2;
    EXPECT_EQ(decided(s.cycle("Turns", {"a", "b", "c", "d"}), {"a"}).outcome, Outcome::inconclusive);
}

/// Processes of nine states with up to three events each.
TEST_F(Recurrence, RandomProcessesAgreeWithAForwardSearch) {
    std::mt19937 random(1);
    const auto below = [&](unsigned most) { return static_cast<std::size_t>(random() % most); };
    const std::vector<std::string> names{"a", "b", "c", "d"};
    constexpr std::size_t states = 9;
    int held = 0;
    for (int round = 0; round < 200; ++round) {
        std::vector<TermId> terms;
        for (std::size_t i = 0; i < states; ++i)
            terms.push_back(s.name("P" + std::to_string(round) + "_" + std::to_string(i)));
        std::vector<std::vector<std::pair<std::string, std::size_t>>> steps(states);
        for (std::size_t i = 0; i < states; ++i) {
            std::vector<std::pair<std::string, TermId>> branches;
            for (std::size_t k = below(4); k > 0; --k) {
                steps[i].emplace_back(names[below(4)], below(states));
                branches.emplace_back(steps[i].back().first, terms[steps[i].back().second]);
            }
            s.bind(terms[i], branches.empty() ? s.stop() : s.menu(branches));
        }
        const auto reached = [&](std::size_t from) {
            std::set<std::size_t> found{from};
            std::queue<std::size_t> open;
            for (open.push(from); !open.empty(); open.pop())
                for (const auto& [event, to] : steps[open.front()])
                    if (found.insert(to).second) open.push(to);
            return found;
        };
        const auto offers = [&](std::size_t state) {
            return std::ranges::any_of(steps[state], [](const auto& step) { return step.first == "a"; });
        };
        bool expected = true;
        for (const std::size_t state : reached(0)) {
            const auto behind = reached(state);
            expected = expected && std::ranges::any_of(behind, offers);
        }
        EXPECT_EQ(decided(terms[0], {"a"}).outcome, expected ? Outcome::holds : Outcome::fails) << round;
        held += expected ? 1 : 0;
    }
    EXPECT_GT(held, 5);
    EXPECT_LT(held, 195);
}

}  // namespace
}  // namespace robochart::refine
