// SPDX-License-Identifier: Apache-2.0
// Tests the output of lines that are wider than the terminal.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "app/command/output.hpp"
#include "tests/app/command.hpp"

namespace robochart::app::testing::width_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(Width, LinesAreContinuedFurtherToTheRight) {
    EXPECT_EQ(wrap_lines("  one two three four\nshort\n", 12), "  one two\n    three\n    four\nshort\n");
    EXPECT_EQ(wrap_lines("  one two three four\n", 0), "  one two three four\n");
    EXPECT_EQ(wrap_lines("", 10), "");
    EXPECT_EQ(wrap_lines("\n\n", 10), "\n\n");
}

TEST(Width, AWordThatIsTooWideStaysWhole) {
    EXPECT_EQ(wrap_lines("abcdefghijklmnop", 10), "abcdefghijklmnop");
    EXPECT_EQ(wrap_lines("a bcdefghijklmnop q", 10), "a\n  bcdefghijklmnop\n  q");
}

TEST(Width, ColoursAndBytesOfOneCharacterTakeNoColumns) {
    EXPECT_EQ(wrap_lines("\x1b[1;31mFAILS\x1b[0m a b", 9), "\x1b[1;31mFAILS\x1b[0m a b");
    EXPECT_EQ(wrap_lines("\xC3\xA9\xC3\xA9\xC3\xA9 \xC3\xA9", 5), "\xC3\xA9\xC3\xA9\xC3\xA9 \xC3\xA9");
}

// The width is COLUMNS or the width of the terminal. A pipe has no width.
TEST(Width, IsThatOfColumns) {
    constexpr const char* model =
        "echo 'stm M { event a event b initial i state AStateWithARatherLongNameForOne { } state "
        "AnotherStateWithARatherLongNameForOne { } transition t0 { from i to "
        "AStateWithARatherLongNameForOne } transition t1 { from AStateWithARatherLongNameForOne to "
        "AnotherStateWithARatherLongNameForOne trigger a } }' > m.rct; ";
    const auto widest = [](const std::string& text) {
        std::size_t most = 0, column = 0;
        for (const char c : text) most = std::max(most, column = c == '\n' ? 0 : column + 1);
        return most;
    };
    const Ran wide = run_shell(std::string("unset COLUMNS; ") + model + "\"$verify\" check m.rct");
    const Ran narrow = run_shell(std::string("export COLUMNS=60; ") + model + "\"$verify\" check m.rct");
    EXPECT_GT(widest(wide.out), 80U) << "else this shows nothing";
    EXPECT_LE(widest(narrow.out), 60U) << narrow.out;
}

TEST(Width, ExcerptsFitToo) {
    const Ran narrow = run_shell(
        "echo 'stm M { initial i state A { } state B { } state C { } state D { } state E { } transition t { from i to "
        "Nowhere } transition u { from A to B } transition v { from B to C } }' > m.rct; COLUMNS=60 \"$verify\" "
        "validate m.rct");
    std::istringstream lines(narrow.err);
    for (std::string line; std::getline(lines, line);)
        EXPECT_TRUE(line.find(" | ") == std::string::npos || line.size() <= 60) << line;
    EXPECT_THAT(narrow.err, HasSubstr("Nowhere"));
}

}  // namespace
}  // namespace robochart::app::testing::width_test
