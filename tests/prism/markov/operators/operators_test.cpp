// SPDX-License-Identifier: Apache-2.0
// Tests all operators on random models. Enclosures contain the naive solver's value and are narrow, rationals are equal
// to it, and strategies attain it.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <algorithm>

#include <limits>

#include "prism/markov/operators/bounded.hpp"
#include "prism/markov/operators/exact.hpp"
#include "prism/markov/operators/long_run.hpp"
#include "prism/markov/operators/unbounded.hpp"
#include "tests/prism/markov/models/naive.hpp"
#include "tests/prism/markov/models/random_description.hpp"
#include "tests/rounds.hpp"

namespace robochart::markov {
namespace {

using Faults = std::optional<std::string>;

std::string value_text(const std::optional<Rational>& value) {
    return value ? value->str() : "infinity";
}

bool holds(const Enclosure& enclosure, const std::optional<Rational>& value) {
    if (!value) return enclosure == Enclosure{infinity, infinity};
    return enclosure.high < infinity && Rational(enclosure.low) <= *value && *value <= Rational(enclosure.high);
}

Faults enclosure_fault(const std::string& what, const std::vector<Enclosure>& found, const naive::Values& expected,
                       double width) {
    if (found.size() != expected.size()) return what + ": number of values";
    for (State state = 0; state < expected.size(); ++state) {
        const auto& [low, high] = found[state];
        if (!holds(found[state], expected[state]))
            return fmt::format("{} of {}: {} .. {} without {}", what, state, low, high, value_text(expected[state]));
        if (found[state].relative_width() > width)
            return fmt::format("{} of {}: {} .. {} is wide", what, state, low, high);
    }
    return std::nullopt;
}

Faults exact_fault(const std::string& what, const ExactSolution& found, const naive::Values& expected) {
    for (State state = 0; state < expected.size(); ++state)
        if (found.values.at(state) != expected[state])
            return fmt::format("{} of {}: {} instead of {}", what, state, value_text(found.values[state]),
                               value_text(expected[state]));
    return std::nullopt;
}

/// Returns the choices of a strategy, numbered from the first choice of each state.
naive::Scheduler scheduler_of(const Description& description, const std::vector<std::uint32_t>& strategy) {
    const Model model = model_of(description);
    naive::Scheduler scheduler;
    for (State state = 0; state < model.states(); ++state) {
        const std::uint32_t number = strategy.at(state) - model.first_choice[state];
        EXPECT_LT(number, description.states[state].size());
        scheduler.push_back(number % description.states[state].size());
    }
    return scheduler;
}

const std::string& named(Direction direction) {
    static const std::string names[] = {"minimum", "maximum"};
    return names[direction == Direction::maximum ? 1 : 0];
}

/// Compares the values under a strategy with the optimal ones.
Faults strategy_fault(const std::string& what, const naive::Values& found, const naive::Values& expected,
                      const Rational& share) {
    for (State state = 0; state < expected.size(); ++state) {
        if (!expected[state] && !found[state]) continue;
        if (!expected[state] || !found[state] || abs(*found[state] - *expected[state]) > share * *expected[state])
            return fmt::format("strategy of {} from {}: {} instead of {}", what, state, value_text(found[state]),
                               value_text(expected[state]));
    }
    return std::nullopt;
}

constexpr Precision with_strategy{.strategy = true};
const Rational close(1, 1'000'000);

Faults until_fault(const Description& description) {
    const Model model = model_of(description);
    for (const Direction direction : {Direction::minimum, Direction::maximum}) {
        const std::string what = named(direction) + " of until";
        const naive::Values expected = naive::until(description, direction);
        const Solution found = until(model, description.left, description.right, direction, with_strategy);
        if (const Faults fault = enclosure_fault(what, found.values, expected, 1e-6)) return fault;
        if (!found.shortfall.empty()) return found.shortfall;
        const ExactSolution exact = exact_until(model, description.left, description.right, direction);
        if (const Faults fault = exact_fault(what, exact, expected)) return fault;
        const auto values = [&](const std::vector<std::uint32_t>& strategy) {
            return naive::until(description, scheduler_of(description, strategy));
        };
        if (const Faults fault = strategy_fault(what, values(found.strategy), expected, close)) return fault;
        if (const Faults fault = strategy_fault(what, values(exact.strategy), expected, 0)) return fault;
    }
    return std::nullopt;
}

Faults reachability_reward_fault(const Description& description) {
    const Model model = model_of(description);
    const Rewards rewards = rewards_of(description);
    for (const Direction direction : {Direction::minimum, Direction::maximum}) {
        const std::string what = named(direction) + " of reachability reward";
        const naive::Values expected = naive::reachability_reward(description, direction);
        const Solution found = reachability_reward(model, rewards, description.right, direction, with_strategy);
        if (const Faults fault = enclosure_fault(what, found.values, expected, 1e-6)) return fault;
        if (!found.shortfall.empty()) return found.shortfall;
        const ExactSolution exact = exact_reachability_reward(model, rewards, description.right, direction);
        if (const Faults fault = exact_fault(what, exact, expected)) return fault;
        const auto values = [&](const std::vector<std::uint32_t>& strategy) {
            return naive::reachability_reward(description, scheduler_of(description, strategy));
        };
        if (const Faults fault = strategy_fault(what, values(found.strategy), expected, close)) return fault;
        if (const Faults fault = strategy_fault(what, values(exact.strategy), expected, 0)) return fault;
    }
    return std::nullopt;
}

Faults total_reward_fault(const Description& description) {
    const Model model = model_of(description);
    const Rewards rewards = rewards_of(description);
    for (const Direction direction : {Direction::minimum, Direction::maximum}) {
        const std::string what = named(direction) + " of total reward";
        const naive::Values expected = naive::total_reward(description, direction);
        const Solution found = total_reward(model, rewards, direction, with_strategy);
        if (const Faults fault = enclosure_fault(what, found.values, expected, 1e-6)) return fault;
        const ExactSolution exact = exact_total_reward(model, rewards, direction);
        if (const Faults fault = exact_fault(what, exact, expected)) return fault;
        const auto values = [&](const std::vector<std::uint32_t>& strategy) {
            return naive::total_reward(description, scheduler_of(description, strategy));
        };
        if (const Faults fault = strategy_fault(what, values(found.strategy), expected, close)) return fault;
        if (const Faults fault = strategy_fault(what, values(exact.strategy), expected, 0)) return fault;
    }
    return std::nullopt;
}

naive::Values of_each_state(const Description& description, const std::function<Rational(State)>& value) {
    naive::Values values;
    for (State state = 0; state < description.states.size(); ++state) values.emplace_back(value(state));
    return values;
}

Faults bounded_fault(const Description& description) {
    const Model model = model_of(description);
    const Rewards rewards = rewards_of(description);
    for (const Direction direction : {Direction::minimum, Direction::maximum}) {
        const std::string which = named(direction) + " of ";
        for (const auto& [from, to] : {std::pair{0, 0}, {0, 3}, {1, 1}, {2, 4}}) {
            const auto first = static_cast<std::uint64_t>(from);
            const auto last = static_cast<std::uint64_t>(to);
            const naive::Values expected = of_each_state(description, [&](State state) {
                return naive::bounded_until(description, state, first, last, direction);
            });
            const std::string what = fmt::format("{}until {} to {}", which, from, to);
            const Solution found = bounded_until(model, description.left, description.right, first, last, direction);
            if (const Faults fault = enclosure_fault(what, found.values, expected, 1e-14)) return fault;
            const ExactSolution exact =
                exact_bounded_until(model, description.left, description.right, first, last, direction);
            if (const Faults fault = exact_fault(what, exact, expected)) return fault;
        }
        for (const std::uint64_t steps : {0U, 1U, 4U}) {
            const naive::Values sums = of_each_state(description, [&](State state) {
                return naive::cumulative_reward(description, state, steps, direction);
            });
            // Gains and losses may nearly cancel, so relative widths are unbounded.
            if (const Faults fault = enclosure_fault(
                    which + "cumulative reward", cumulative_reward(model, rewards, steps, direction), sums, infinity))
                return fault;
            if (const Faults fault = exact_fault(which + "cumulative reward",
                                                 exact_cumulative_reward(model, rewards, steps, direction), sums))
                return fault;
            const naive::Values last = of_each_state(description, [&](State state) {
                return naive::instantaneous_reward(description, state, steps, direction);
            });
            if (const Faults fault =
                    enclosure_fault(which + "instantaneous reward",
                                    instantaneous_reward(model, rewards, steps, direction), last, infinity))
                return fault;
            if (const Faults fault = exact_fault(which + "instantaneous reward",
                                                 exact_instantaneous_reward(model, rewards, steps, direction), last))
                return fault;
        }
        Description any = description;
        any.left.assign(any.states.size(), true);
        const naive::Values step =
            of_each_state(description, [&](State state) { return naive::bounded_until(any, state, 1, 1, direction); });
        if (const Faults fault =
                enclosure_fault(which + "next", next(model, description.right, direction), step, 1e-14))
            return fault;
        if (const Faults fault = exact_fault(which + "next", exact_next(model, description.right, direction), step))
            return fault;
    }
    return std::nullopt;
}

/// Compares U>=from with its definition: the value of the unbounded until after `from` steps.
Faults lower_bounded_fault(const Description& description) {
    const Model model = model_of(description);
    for (const Direction direction : {Direction::minimum, Direction::maximum}) {
        naive::Values expected = naive::until(description, direction);
        for (int step = 0; step < 2; ++step) {
            const naive::Values before = expected;
            for (State state = 0; state < before.size(); ++state) {
                std::vector<Rational> worths;
                for (const Choice& choice : description.states[state]) {
                    Rational sum = 0;
                    Rational weights = 0;
                    for (const Branch& branch : choice.branches) {
                        sum += branch.weight * *before[branch.target];
                        weights += branch.weight;
                    }
                    worths.emplace_back(sum / weights);
                }
                if (!description.left[state])
                    expected[state] = Rational(0);
                else if (direction == Direction::maximum)
                    expected[state] = *std::ranges::max_element(worths);
                else
                    expected[state] = *std::ranges::min_element(worths);
            }
        }
        const Solution found = bounded_until(model, description.left, description.right, 2, std::nullopt, direction);
        if (const Faults fault = enclosure_fault("until from 2", found.values, expected, 1e-6)) return fault;
        const ExactSolution exact =
            exact_bounded_until(model, description.left, description.right, 2, std::nullopt, direction);
        if (const Faults fault = exact_fault("until from 2", exact, expected)) return fault;
    }
    return std::nullopt;
}

Faults long_run_fault(const Description& description) {
    const Model model = model_of(description);
    const naive::Values expected = naive::long_run_reward(description);
    const Solution found = long_run_reward(model, rewards_of(description));
    if (const Faults fault = enclosure_fault("long-run reward", found.values, expected, infinity)) return fault;
    if (const Faults fault =
            exact_fault("long-run reward", exact_long_run_reward(model, rewards_of(description)), expected))
        return fault;
    Description share = description;
    for (State state = 0; state < share.states.size(); ++state) {
        share.rewards[state] = share.right[state] ? 1 : 0;
        share.states[state].front().reward = 0;
    }
    const naive::Values shares = naive::long_run_reward(share);
    const Solution probability = long_run_probability(model, description.right);
    if (const Faults fault = enclosure_fault("long-run probability", probability.values, shares, 1e-6)) return fault;
    return exact_fault("long-run probability", exact_long_run_probability(model, description.right), shares);
}

struct Setting {
    std::string name;
    Fault fault;
    Kind kind;
    RandomSizes sizes;
    std::size_t times;
};

void PrintTo(const Setting& setting, std::ostream* out) {
    *out << setting.name;
}

class Operators : public testing::TestWithParam<Setting> {};

TEST_P(Operators, AgreeWithTheNaiveSolver) {
    const Setting& setting = GetParam();
    std::mt19937_64 numbers(6);
    for (std::size_t count = 0; count < tests::rounds(setting.times); ++count) {
        const Description description = random_description(numbers, setting.kind, setting.sizes);
        if (setting.fault(description)) FAIL() << smallest(description, setting.fault);
    }
}

const RandomSizes larger{.states = 12, .choices = 1, .branches = 4};
const RandomSizes with_losses{.states = 5, .negative_rewards = true};

INSTANTIATE_TEST_SUITE_P(
    All, Operators,
    testing::Values(Setting{"UntilOfDtmcs", until_fault, Kind::dtmc, larger, 400},
                    Setting{"UntilOfMdps", until_fault, Kind::mdp, {}, 600},
                    Setting{"ReachabilityRewardsOfDtmcs", reachability_reward_fault, Kind::dtmc, larger, 400},
                    Setting{"ReachabilityRewardsOfMdps", reachability_reward_fault, Kind::mdp, {}, 600},
                    Setting{"TotalRewardsOfDtmcs", total_reward_fault, Kind::dtmc, larger, 400},
                    Setting{"TotalRewardsOfMdps", total_reward_fault, Kind::mdp, {}, 600},
                    Setting{"BoundedOnesOfDtmcs", bounded_fault, Kind::dtmc, with_losses, 200},
                    Setting{"BoundedOnesOfMdps", bounded_fault, Kind::mdp, with_losses, 100},
                    Setting{"UntilFromAStepOn", lower_bounded_fault, Kind::mdp, {}, 300},
                    Setting{
                        "LongRunsOfDtmcs", long_run_fault, Kind::dtmc, {.states = 8, .negative_rewards = true}, 600}),
    [](const auto& tested) { return tested.param.name; });

}  // namespace
}  // namespace robochart::markov
