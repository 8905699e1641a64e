// SPDX-License-Identifier: Apache-2.0
#include "tests/prism/markov/models/random_description.hpp"

#include <algorithm>

namespace robochart::markov {
namespace {

/// Returns a remainder, which is the same for every standard library.
std::size_t below(std::mt19937_64& numbers, std::size_t bound) {
    return static_cast<std::size_t>(numbers() % bound);
}

/// Returns a random weight. Some weights are rare events, and some are not representable as doubles.
Rational random_weight(std::mt19937_64& numbers) {
    switch (below(numbers, 12)) {
        case 0:
            return Rational(1, 1'000'000'007);
        case 1:
            return Rational(1, std::int64_t{1} << 40U);
        default:
            return Rational(1 + below(numbers, 6));
    }
}

Rational random_reward(std::mt19937_64& numbers, const RandomSizes& sizes) {
    const Rational reward =
        below(numbers, 2) == 0 ? Rational(0) : Rational(1 + below(numbers, 20), 1 + below(numbers, 3));
    return sizes.negative_rewards && below(numbers, 3) == 0 ? Rational(-reward) : reward;
}

Choice random_choice(std::mt19937_64& numbers, std::size_t states, const RandomSizes& sizes) {
    Choice choice;
    for (std::size_t count = 1 + below(numbers, sizes.branches); count > 0; --count) {
        const State target = static_cast<State>(below(numbers, states));
        if (std::ranges::find(choice.branches, target, &Branch::target) == choice.branches.end())
            choice.branches.push_back({target, random_weight(numbers)});
    }
    choice.reward = random_reward(numbers, sizes);
    return choice;
}

/// Returns all models that are one change smaller.
std::vector<Description> smaller(const Description& description) {
    std::vector<Description> found;
    const auto changed = [&](const auto& change) {
        found.push_back(description);
        change(found.back());
    };
    for (State state = 0; state < description.states.size(); ++state) {
        const std::vector<Choice>& choices = description.states[state];
        for (std::size_t number = 0; number < choices.size(); ++number) {
            const auto erase = [](auto& from, std::size_t at) {
                from.erase(from.begin() + static_cast<std::ptrdiff_t>(at));
            };
            if (choices.size() > 1) changed([&](Description& it) { erase(it.states[state], number); });
            if (choices[number].reward != 0) changed([&](Description& it) { it.states[state][number].reward = 0; });
            for (std::size_t branch = 0; branch < choices[number].branches.size(); ++branch) {
                if (choices[number].branches.size() > 1)
                    changed([&](Description& it) { erase(it.states[state][number].branches, branch); });
                if (choices[number].branches[branch].weight != 1)
                    changed([&](Description& it) { it.states[state][number].branches[branch].weight = 1; });
            }
        }
        if (!description.rewards.empty() && description.rewards[state] != 0)
            changed([&](Description& it) { it.rewards[state] = 0; });
    }
    return found;
}

}  // namespace

Description random_description(std::mt19937_64& numbers, Kind kind, const RandomSizes& sizes) {
    Description description;
    description.kind = kind;
    const std::size_t states = 1 + below(numbers, sizes.states);
    for (std::size_t state = 0; state < states; ++state) {
        std::vector<Choice>& choices = description.states.emplace_back();
        for (std::size_t count = kind == Kind::dtmc ? 1 : 1 + below(numbers, sizes.choices); count > 0; --count)
            choices.push_back(random_choice(numbers, states, sizes));
        description.rewards.push_back(below(numbers, 2) == 0 ? Rational(0) : random_reward(numbers, sizes));
        description.left.push_back(below(numbers, 5) != 0);
        description.right.push_back(below(numbers, 4) == 0);
    }
    return description;
}

std::string smallest(Description description, const Fault& fault) {
    for (bool more = true; more;) {
        more = false;
        for (Description& candidate : smaller(description)) {
            if (!fault(candidate)) continue;
            description = std::move(candidate);
            more = true;
            break;
        }
    }
    return description_text(description) + fault(description).value_or("");
}

}  // namespace robochart::markov
