// SPDX-License-Identifier: Apache-2.0
// Compares end components and bottom components with their definitions.
#include "prism/markov/graph/graph.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/prism/markov/models/naive.hpp"
#include "tests/prism/markov/models/random_description.hpp"
#include "tests/rounds.hpp"

namespace robochart::markov {
namespace {

using States = std::vector<State>;

bool has(const States& states, State state) {
    return std::ranges::binary_search(states, state);
}

/// Returns the choices of these states that stay within the set, by their numbers in the model.
std::vector<std::uint32_t> choices_within_states(const Description& description, const States& states) {
    std::vector<std::uint32_t> found;
    std::uint32_t number = 0;
    for (State state = 0; state < description.states.size(); ++state)
        for (const Choice& choice : description.states[state]) {
            const auto inside = [&](const Branch& branch) { return has(states, branch.target); };
            if (has(states, state) && std::ranges::all_of(choice.branches, inside)) found.push_back(number);
            ++number;
        }
    return found;
}

/// Returns whether every state has a choice that stays within the set, and reaches every other state by such choices.
bool is_end_component(const Description& description, const States& states) {
    naive::Matrix edges(description.states.size(), std::vector<Rational>(description.states.size(), 0));
    std::vector<bool> moves(description.states.size(), false);
    for (const State state : states)
        for (const Choice& choice : description.states[state]) {
            if (!std::ranges::all_of(choice.branches, [&](const Branch& branch) { return has(states, branch.target); }))
                continue;
            moves[state] = true;
            for (const Branch& branch : choice.branches) edges[state][branch.target] = 1;
        }
    const auto reaches = naive::reachability(edges);
    for (const State from : states)
        for (const State to : states)
            if (!moves[from] || !reaches[from][to]) return false;
    return true;
}

std::optional<std::string> end_component_fault(const Description& description) {
    std::vector<States> all;
    for (std::uint32_t bits = 1; bits < 1U << description.states.size(); ++bits) {
        States states;
        for (State state = 0; state < description.states.size(); ++state)
            if ((bits >> state & 1U) != 0) states.push_back(state);
        if (is_end_component(description, states)) all.push_back(states);
    }
    std::vector<States> maximal;
    for (const States& states : all)
        if (std::ranges::none_of(all, [&](const States& other) {
                return other.size() > states.size() && std::ranges::includes(other, states);
            }))
            maximal.push_back(states);
    std::ranges::sort(maximal);
    const Model model = model_of(description);
    const std::vector<EndComponent> found = end_components(Graph(model));
    if (found.size() != maximal.size()) return "number of end components";
    for (std::size_t index = 0; index < found.size(); ++index) {
        if (found[index].states != maximal[index]) return "states";
        if (found[index].choices != choices_within_states(description, maximal[index])) return "choices";
    }
    return std::nullopt;
}

TEST(EndComponents, AreTheMaximalSetsThatCanBeStayedIn) {
    std::mt19937_64 numbers(4);
    for (std::size_t count = 0; count < tests::rounds(3'000); ++count) {
        const Description description = random_description(numbers, Kind::mdp, {.states = 6});
        if (end_component_fault(description)) FAIL() << smallest(description, end_component_fault);
    }
}

TEST(EndComponents, UseOnlyAdmittedChoices) {
    // States 0 and 1 lead to each other. State 1 may also stay, by its second choice.
    const Model model = model_of(mdp({{{{{1, 1}}}}, {{{{0, 1}}}, {{{1, 1}}}}}));
    const Graph graph(model);
    EXPECT_EQ(end_components(graph).front().states, (States{0, 1}));
    const auto without_first = end_components(graph, {StateSet(2, true), {true, false, true}});
    ASSERT_EQ(without_first.size(), 1U);
    EXPECT_EQ(without_first.front().states, States{1});
    EXPECT_EQ(without_first.front().choices, (std::vector<std::uint32_t>{2}));
    EXPECT_TRUE(end_components(graph, {{true, false}, {true, true, true}}).empty());
}

std::optional<std::string> bottom_fault(const Description& description) {
    const auto reaches =
        naive::reachability(naive::matrix(description, naive::Scheduler(description.states.size(), 0)));
    std::vector<States> expected;
    for (State state = 0; state < reaches.size(); ++state) {
        States component;
        bool bottom = true;
        for (State to = 0; to < reaches.size(); ++to) {
            if (!reaches[state][to]) continue;
            component.push_back(to);
            bottom = bottom && reaches[to][state];
        }
        if (bottom && component.front() == state) expected.push_back(component);
    }
    if (bottom_components(model_of(description)) != expected) return "bottom components";
    return std::nullopt;
}

TEST(BottomComponents, AreTheClassesOfRecurrentStates) {
    std::mt19937_64 numbers(5);
    for (std::size_t count = 0; count < tests::rounds(3'000); ++count) {
        const Description description = random_description(numbers, Kind::dtmc, {.states = 7});
        if (bottom_fault(description)) FAIL() << smallest(description, bottom_fault);
    }
}

}  // namespace
}  // namespace robochart::markov
