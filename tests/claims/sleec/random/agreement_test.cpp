// SPDX-License-Identifier: Apache-2.0
// Compares the conflicts that the analysis finds in random rule sets with those of a naive enumeration.
// ROBOCHART_RANDOM_CHECKS and ROBOCHART_RANDOM_SEED select the number and the seed (tests/long.sh rules).
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <set>

#include "claims/sleec/analysis/conflicts.hpp"
#include "tests/claims/sleec/random/naive_rules.hpp"
#include "tests/claims/sleec/support.hpp"
#include "tests/rounds.hpp"

namespace robochart::sleec {
namespace {

std::uint64_t setting(const char* name, std::uint64_t otherwise) {
    const char* const text = std::getenv(name);
    return text == nullptr ? otherwise : std::strtoull(text, nullptr, 10);
}

std::string text_of(const std::set<std::vector<std::size_t>>& conflicts) {
    std::string text;
    for (const auto& conflict : conflicts) {
        for (const std::size_t rule : conflict) text += "R" + std::to_string(rule) + " ";
        text += "; ";
    }
    return text;
}

/// The analysis' answers to all questions about a rule set.
struct Analysed {
    std::set<std::vector<std::size_t>> forbidden, endless, queried;
    bool decided = true;
};

Analysed analysed(const CheckedRules& rules) {
    Analysed result;
    for_each_question(rules, {}, [&](const ConflictAnswer& answer) {
        result.queried.insert(answer.rules);
        result.decided = result.decided && answer.conflict != Answer::not_decided;
        if (answer.conflict == Answer::yes)
            (answer.example->endless ? result.endless : result.forbidden).insert(answer.rules);
    });
    return result;
}

using Sets = std::set<std::vector<std::size_t>>;

/// Returns the sets that contain no smaller set of `others`.
Sets without_larger(Sets sets, const Sets& others) {
    std::erase_if(sets, [&](const auto& set) {
        return std::ranges::any_of(
            others, [&](const auto& other) { return other.size() < set.size() && std::ranges::includes(set, other); });
    });
    return sets;
}

/// Compares the answers for the queried sets that have no conflicting subset.
void compare_endless(const std::vector<testing::NaiveRule>& rules, const Analysed& found, const std::string& text) {
    for (const std::vector<std::size_t>& rule_set : found.queried) {
        std::vector<testing::NaiveRule> subset;
        for (const std::size_t rule : rule_set) subset.push_back(rules[rule]);
        const auto naive = testing::in_conflict(subset);
        const auto part = [&](const auto& other) {
            return other.size() < rule_set.size() && std::ranges::includes(rule_set, other);
        };
        if (!naive || std::ranges::any_of(found.endless, part) || std::ranges::any_of(found.forbidden, part)) continue;
        const bool endless = found.endless.contains(rule_set);
        const bool expected = *naive == testing::NaiveAnswer::endless;
        EXPECT_TRUE(endless == expected) << text << text_of({rule_set}) << (endless ? "" : "not ")
                                         << "said to be endless";
    }
}

TEST(RandomRules, ConflictsAgreeWithTheEnumeration) {
    const std::uint64_t checks = setting("ROBOCHART_RANDOM_CHECKS", tests::rounds(100));
    const std::uint64_t seed = setting("ROBOCHART_RANDOM_SEED", 1);
    std::uint64_t compared = 0, in_conflict = 0, of_three = 0, endless = 0;
    for (std::uint64_t round = 0; round < checks; ++round) {
        std::mt19937_64 random(seed + round);
        const auto rules = testing::random_rules(random);
        const std::string text = "seed " + std::to_string(seed + round) + "\n" + testing::text_of(rules);
        testing::Read read(testing::text_of(rules));
        ASSERT_TRUE(read.checked_too().checked) << text << read.report();
        const Analysed found = analysed(*read.checked);
        const auto expected = testing::smallest_conflicts(rules);
        if (!found.decided || !expected) continue;
        ++compared;
        in_conflict += expected->empty() ? 0U : 1U;
        endless += found.endless.size();
        for (const auto& conflict : *expected) of_three += conflict.size() > 2 ? 1U : 0U;
        const Sets smallest = without_larger(without_larger(found.forbidden, found.forbidden), found.endless);
        ASSERT_EQ(text_of(smallest), text_of(without_larger(*expected, found.endless))) << text;
        compare_endless(rules, found, text);
        if (HasFailure()) return;
    }
    std::printf(
        "%llu of %llu compared, %llu in conflict; %llu conflicts of three rules or more, %llu endless instants\n",
        static_cast<unsigned long long>(compared), static_cast<unsigned long long>(checks),
        static_cast<unsigned long long>(in_conflict), static_cast<unsigned long long>(of_three),
        static_cast<unsigned long long>(endless));
    EXPECT_GT(compared * 2, checks) << "too many were too large";
    EXPECT_GT(in_conflict * 10, compared) << "too few conflicts to tell";
}

}  // namespace
}  // namespace robochart::sleec
