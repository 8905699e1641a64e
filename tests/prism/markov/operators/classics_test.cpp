// SPDX-License-Identifier: Apache-2.0
// Tests models on which simpler methods fail. The values follow by reasoning.
#include <gtest/gtest.h>

#include "prism/markov/operators/bounded.hpp"
#include "prism/markov/operators/exact.hpp"
#include "prism/markov/operators/long_run.hpp"
#include "prism/markov/operators/unbounded.hpp"
#include "tests/prism/markov/models/description.hpp"

namespace robochart::markov {
namespace {

void expect_encloses(const Enclosure& found, const Rational& value, double width = 1e-12) {
    EXPECT_LE(Rational(found.low), value) << found.low << " .. " << found.high;
    EXPECT_GE(Rational(found.high), value) << found.low << " .. " << found.high;
    EXPECT_LE(found.relative_width(), width) << found.low << " .. " << found.high;
}

StateSet all_states(const Model& model) {
    return StateSet(model.states(), true);
}

/// Returns a model after Haddad and Monmege (Interval iteration algorithm for MDPs and IMDPs, 2018). From the middle,
/// `length` steps of probability 1/2 lead in one direction, and each of them may lead back to the middle instead. By
/// symmetry each end has probability 1/2. The states are 0 .. 2 length, and the middle is `length`.
Description slow_chain(State length) {
    std::vector<std::vector<Branch>> rows;
    for (State state = 0; state <= 2 * length; ++state) {
        const bool end = state == 0 || state == 2 * length;
        if (end) rows.push_back({{state, 1}});
        if (!end && state < length) rows.push_back({{state - 1, 1}, {length, 1}});
        if (state == length) rows.push_back({{state - 1, 1}, {state + 1, 1}});
        if (!end && state > length) rows.push_back({{length, 1}, {state + 1, 1}});
    }
    return dtmc(rows);
}

TEST(Classics, ASlowChainIsSolvedToTheLastDigits) {
    for (const State length : {10U, 20U, 60U, 300U}) {
        const Model model = model_of(slow_chain(length));
        const Solution solution =
            until(model, all_states(model), set_of(model.states(), {2 * length}), Direction::minimum);
        expect_encloses(solution.values[length], Rational(1, 2));
        EXPECT_EQ(solution.shortfall, "");
        // From the first state on the right, the end is reached directly with probability 2^(1-length). Otherwise it is
        // reached from the middle with probability 1/2.
        const Rational at_once(1, boost::multiprecision::cpp_int(1) << (length - 1));
        expect_encloses(solution.values[length + 1], at_once + (1 - at_once) / 2);
    }
}

/// The chain of the previous test, in which every state except the ends has a second choice: to stay. A maximising
/// scheduler never stays forever. The loops are end components without value.
TEST(Classics, ASlowMdpWithLoops) {
    for (const State length : {10U, 20U, 40U}) {
        Description description = slow_chain(length);
        description.kind = Kind::mdp;
        for (State state = 1; state < 2 * length; ++state) description.states[state].push_back({{{state, 1}}});
        const Model model = model_of(description);
        const StateSet end = set_of(model.states(), {2 * length});
        const Solution most = until(model, all_states(model), end, Direction::maximum);
        expect_encloses(most.values[length], Rational(1, 2), 1e-6);
        EXPECT_EQ(most.shortfall, "");
        EXPECT_EQ(until(model, all_states(model), end, Direction::minimum).values[length], (Enclosure{0, 0}));
        const ExactSolution exact = exact_until(model, all_states(model), end, Direction::maximum);
        EXPECT_EQ(*exact.values[length], Rational(1, 2));
    }
}

/// Every step has two equally good alternatives. One of them takes twice as long. Both are optimal. A proof that
/// considers only one of them would accept only that one.
TEST(Classics, EquallyGoodChoicesOfDifferentLength) {
    std::vector<std::vector<Choice>> states;
    constexpr State length = 30;
    for (State state = 0; state < length; ++state)
        states.push_back({{{{0, 1}, {state + 1, 1}}}, {{{0, 3}, {state, 1}, {state + 1, 3}, {length + 1, 1}}}});
    states.push_back({{{{length, 1}}}});
    states.push_back({{{{0, 3}, {length, 1}}}});
    const Model model = model_of(mdp(states));
    for (const Direction direction : {Direction::minimum, Direction::maximum}) {
        const Solution solution = until(model, all_states(model), set_of(model.states(), {length}), direction);
        expect_encloses(solution.values[0], 1);
    }
    Description earning = mdp(states);
    earning.rewards.assign(states.size(), 1);
    earning.rewards[length] = 0;
    for (const Direction direction : {Direction::minimum, Direction::maximum}) {
        const StateSet target = set_of(model.states(), {length});
        const Solution solution = reachability_reward(model, rewards_of(earning), target, direction);
        const ExactSolution exact = exact_reachability_reward(model, rewards_of(earning), target, direction);
        expect_encloses(solution.values[0], *exact.values[0], 1e-6);
    }
}

TEST(Classics, FreeLoopsAreNoWayToSave) {
    // States 0 and 1 lead to each other without cost. State 0 may also lead to 2 at cost 5.
    const Description description = mdp({{{{{1, 1}}}, {{{2, 1}}, 5}}, {{{{0, 1}}}}, {{{{2, 1}}}}});
    const Model model = model_of(description);
    const Rewards rewards = rewards_of(description);
    const StateSet end = set_of(3, {2});
    const Solution least = reachability_reward(model, rewards, end, Direction::minimum, {.strategy = true});
    EXPECT_EQ(least.values[0], (Enclosure{5, 5}));
    EXPECT_EQ(least.values[1], (Enclosure{5, 5}));
    EXPECT_EQ(least.strategy, (std::vector<std::uint32_t>{1, 2, 3}));
    EXPECT_EQ(reachability_reward(model, rewards, end, Direction::maximum).values[0], (Enclosure{infinity, infinity}));
    EXPECT_EQ(total_reward(model, rewards, Direction::minimum).values[0], (Enclosure{0, 0}));
    EXPECT_EQ(total_reward(model, rewards, Direction::maximum).values[0], (Enclosure{5, 5}));
}

TEST(Classics, ALoopIsNoWayToWin) {
    // State 0 leads to 1. State 1 leads back to 0, or to 2 or 3 with probability 1/2 each.
    const Model model = model_of(mdp({{{{{1, 1}}}}, {{{{0, 1}}}, {{{2, 1}, {3, 1}}}}, {{{{2, 1}}}}, {{{{3, 1}}}}}));
    const StateSet end = set_of(4, {2});
    EXPECT_EQ(until(model, all_states(model), end, Direction::maximum).values[0], (Enclosure{0.5, 0.5}));
    EXPECT_EQ(until(model, all_states(model), end, Direction::minimum).values[0], (Enclosure{0, 0}));
    EXPECT_EQ(bounded_until(model, all_states(model), end, 0, 1, Direction::maximum).values[0], (Enclosure{0, 0}));
    EXPECT_EQ(bounded_until(model, all_states(model), end, 0, 2, Direction::maximum).values[0], (Enclosure{0.5, 0.5}));
}

TEST(Classics, LongRunsByTheirShares) {
    // The chain goes to {1,2} with probability 1/4, where 2 is twice as frequent as 1, and to 3 with probability 3/4.
    Description description = dtmc({{{1, 1}, {3, 3}}, {{2, 1}}, {{1, 1}, {2, 1}}, {{3, 1}}});
    description.rewards = {0, 6, 0, 1};
    const Model model = model_of(description);
    EXPECT_EQ(long_run_probability(model, set_of(4, {3})).values[0], (Enclosure{0.75, 0.75}));
    expect_encloses(long_run_probability(model, set_of(4, {1})).values[0], Rational(1, 12));
    EXPECT_EQ(long_run_probability(model, set_of(4, {0})).values[0], (Enclosure{0, 0}));
    expect_encloses(long_run_reward(model, rewards_of(description)).values[0], Rational(5, 4));
    const Model decisions = model_of(mdp({{{{{0, 1}}}}}));
    EXPECT_THROW((void)long_run_probability(decisions, set_of(1, {0})), Unsupported);
}

TEST(Classics, NegativeRewardsNeedABound) {
    Description description = dtmc({{{1, 1}}, {{1, 1}}});
    description.rewards = {-2, 0};
    const Model model = model_of(description);
    const Rewards rewards = rewards_of(description);
    EXPECT_THROW((void)reachability_reward(model, rewards, set_of(2, {1}), Direction::minimum), Unsupported);
    EXPECT_THROW((void)total_reward(model, rewards, Direction::minimum), Unsupported);
    EXPECT_EQ(cumulative_reward(model, rewards, 3, Direction::minimum)[0], (Enclosure{-2, -2}));
}

TEST(Classics, ExactNeedsExactNumbers) {
    Model model = model_of(dtmc({{{0, 1}, {1, 2}}, {{1, 1}}}));
    model.exact.clear();
    EXPECT_THROW((void)exact_until(model, all_states(model), set_of(2, {1}), Direction::minimum), Unsupported);
}

TEST(Classics, TheBudgetEndsAnyOfThem) {
    diagnostics::Budget budget;
    budget.interrupt();
    const Model model = model_of(slow_chain(10));
    const StateSet end = set_of(model.states(), {20});
    EXPECT_THROW((void)until(model, all_states(model), end, Direction::maximum, {.budget = &budget}),
                 diagnostics::LimitReached);
    EXPECT_THROW((void)exact_until(model, all_states(model), end, Direction::maximum, &budget),
                 diagnostics::LimitReached);
    EXPECT_THROW((void)bounded_until(model, all_states(model), end, 0, 5, Direction::maximum, {.budget = &budget}),
                 diagnostics::LimitReached);
}

/// With a million states, the algorithms must not be recursive, quadratic or imprecise.
TEST(Classics, AMillionStates) {
    constexpr State length = 1'000'000;
    Model model;
    model.initial = {0};
    model.numbers = {{0.5, 0.5}, {1, 1}};
    model.first_choice = {0};
    model.first_branch = {0};
    for (State state = 0; state < length; ++state) {  // back or forward by one step; from the start only forward
        if (state == 0 || state + 1 == length) {
            model.target.push_back(state == 0 ? 1 : state);
            model.number.push_back(1);
        } else {
            model.target.insert(model.target.end(), {state - 1, state + 1});
            model.number.insert(model.number.end(), {0, 0});
        }
        model.first_branch.push_back(model.target.size());
        model.first_choice.push_back(state + 1);
    }
    Rewards steps;
    steps.state.assign(length, {1, 1});
    // Between reflecting ends the walk takes (length-1)^2 steps.
    const Solution solution = reachability_reward(model, steps, set_of(length, {length - 1}), Direction::minimum);
    expect_encloses(solution.values[0], Rational(boost::multiprecision::cpp_int(length - 1) * (length - 1)), 1e-6);
    EXPECT_EQ(solution.shortfall, "");
}

}  // namespace
}  // namespace robochart::markov
