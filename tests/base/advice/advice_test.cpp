// SPDX-License-Identifier: Apache-2.0
// Tests tables of advice: which row matches a position in a text.
#include "base/advice/advice.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace robochart::diagnostics {
namespace {

/// Returns the advice for a position in a text of words. `NUMBER` stands for digits, and the ends of the text for
/// positions outside.
std::string advice_for(const std::vector<Advice>& rows, const std::string& expected,
                       const std::vector<std::string>& text, std::size_t place) {
    return std::string(advice_on(rows, expected, [&](std::ptrdiff_t ahead) -> AdviceWord {
        const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(place) + ahead;
        if (at < 0 || at >= std::ssize(text)) return {WordKind::end, {}};
        const std::string& word = text[static_cast<std::size_t>(at)];
        if (word[0] >= '0' && word[0] <= '9') return {WordKind::number, word};
        if (word[0] == '"') return {WordKind::text, word};
        return {word[0] >= 'a' && word[0] <= 'z' ? WordKind::name : WordKind::other, word};
    }));
}

TEST(Advice, IsOfTheFirstRowWhoseWordsStandAroundThePlace) {
    const std::vector<Advice> rows = {{"", "clock NAME @ =", "in front"},
                                      {"a name", "@ NUMBER", "a number"},
                                      {"", "@ b END", "at the end"},
                                      {"", "@ TEXT", "a string"},
                                      {"a type", "@", "any"}};
    EXPECT_EQ(advice_for(rows, "x", {"clock", "t", "="}, 2), "in front");
    EXPECT_EQ(advice_for(rows, "x", {"clocks", "t", "="}, 2), "");
    EXPECT_EQ(advice_for(rows, "x", {"t", "="}, 1), "") << "a word is missing in front";
    EXPECT_EQ(advice_for(rows, "a name", {"3"}, 0), "a number");
    EXPECT_EQ(advice_for(rows, "x", {"3"}, 0), "") << "something else is expected";
    EXPECT_EQ(advice_for(rows, "x", {"b"}, 0), "at the end");
    EXPECT_EQ(advice_for(rows, "x", {"b", "b"}, 0), "");
    EXPECT_EQ(advice_for(rows, "x", {"\"s\""}, 0), "a string");
    EXPECT_EQ(advice_for(rows, "x", {"\"clock\"", "t", "="}, 2), "") << "what is in a string is no word";
    EXPECT_EQ(advice_for(rows, "a type", {"clock", "t", "="}, 2), "in front") << "the first row";
    EXPECT_EQ(advice_for(rows, "a type", {}, 0), "any");
}

}  // namespace
}  // namespace robochart::diagnostics
