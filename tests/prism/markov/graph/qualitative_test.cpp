// SPDX-License-Identifier: Apache-2.0
// Compares probabilities 0 and 1 with computed values, and CTL with its fixed points.
#include "prism/markov/graph/qualitative.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/prism/markov/models/naive.hpp"
#include "tests/prism/markov/models/random_description.hpp"
#include "tests/rounds.hpp"

namespace robochart::markov {
namespace {

StateSet states_with(const naive::Values& values, int value) {
    StateSet set;
    for (const auto& number : values) set.push_back(*number == value);
    return set;
}

std::optional<std::string> qualitative_fault(const Description& description) {
    const Model model = model_of(description);
    const Graph graph(model);
    const naive::Values least = naive::until(description, Direction::minimum);
    const naive::Values greatest = naive::until(description, Direction::maximum);
    if (prob0a(graph, description.left, description.right) != states_with(greatest, 0)) return "prob0a";
    if (prob0e(graph, description.left, description.right) != states_with(least, 0)) return "prob0e";
    if (prob1e(graph, description.left, description.right) != states_with(greatest, 1)) return "prob1e";
    if (prob1a(graph, description.left, description.right) != states_with(least, 1)) return "prob1a";
    return std::nullopt;
}

void expect_no_fault(std::uint64_t seed, Kind kind, std::size_t times, const Fault& fault) {
    std::mt19937_64 numbers(seed);
    for (std::size_t count = 0; count < times; ++count) {
        const Description description = random_description(numbers, kind);
        if (fault(description)) FAIL() << smallest(description, fault);
    }
}

TEST(Qualitative, DtmcsAgreeWithTheirValues) {
    expect_no_fault(1, Kind::dtmc, tests::rounds(3'000), qualitative_fault);
}

TEST(Qualitative, MdpsAgreeWithTheirValues) {
    expect_no_fault(2, Kind::mdp, tests::rounds(500), qualitative_fault);
}

/// Returns whether all, or some, successors of a state are in the set.
bool successors(const Description& description, State state, const StateSet& set, bool all) {
    for (const Choice& choice : description.states[state])
        for (const Branch& branch : choice.branches)
            if (set[branch.target] != all) return !all;
    return all;
}

/// Computes the fixed point from the empty or full set. The function is applied as many times as there are states.
template <class Step>
StateSet fixed_point(const Description& description, bool greatest, Step step) {
    StateSet set(description.states.size(), greatest);
    for (std::size_t round = 0; round <= description.states.size(); ++round) {
        StateSet after;
        for (State state = 0; state < set.size(); ++state) after.push_back(step(state, set));
        set = after;
    }
    return set;
}

std::optional<std::string> ctl_fault(const Description& description) {
    const Model model = model_of(description);
    const Graph graph(model);
    const StateSet& left = description.left;
    const StateSet& right = description.right;
    for (const bool all : {false, true}) {
        const auto next = [&](State state, const StateSet& set) { return successors(description, state, set, all); };
        const auto until = [&](State state, const StateSet& set) {
            return right[state] || (left[state] && next(state, set));
        };
        const auto globally = [&](State state, const StateSet& set) { return left[state] && next(state, set); };
        const auto finally = [&](State state, const StateSet& set) { return right[state] || next(state, set); };
        StateSet one_step;
        for (State state = 0; state < right.size(); ++state) one_step.push_back(next(state, right));
        const std::string who = all ? "always " : "exists ";
        if ((all ? always_next : exists_next)(graph, right) != one_step) return who + "next";
        if ((all ? always_until : exists_until)(graph, left, right) != fixed_point(description, false, until))
            return who + "until";
        if ((all ? always_globally : exists_globally)(graph, left) != fixed_point(description, true, globally))
            return who + "globally";
        if ((all ? always_finally : exists_finally)(graph, right) != fixed_point(description, false, finally))
            return who + "finally";
    }
    return std::nullopt;
}

TEST(Qualitative, CtlAgreesWithItsFixedPoints) {
    expect_no_fault(3, Kind::mdp, tests::rounds(1'000), ctl_fault);
}

TEST(Qualitative, ALongChainNeedsNoRecursion) {
    constexpr State length = 1'000'000;
    Model model;
    model.numbers = {{1, 1}};
    model.initial = {0};
    for (State state = 0; state < length; ++state) {
        model.first_choice.push_back(state);
        model.first_branch.push_back(state);
        model.target.push_back(std::min(state + 1, length - 1));
        model.number.push_back(0);
    }
    model.first_choice.push_back(length);
    model.first_branch.push_back(length);
    const Graph graph(model);
    const StateSet all(length, true);
    const StateSet end = set_of(length, {length - 1});
    EXPECT_EQ(prob1e(graph, all, end), all);
    EXPECT_EQ(always_finally(graph, end), all);
    EXPECT_EQ(bottom_components(model), (std::vector<std::vector<State>>{{length - 1}}));
    EXPECT_EQ(end_components(graph).size(), 1U);
}

}  // namespace
}  // namespace robochart::markov
