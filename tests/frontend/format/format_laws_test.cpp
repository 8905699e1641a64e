// SPDX-License-Identifier: Apache-2.0
// Tests the laws of the formatter (docs/format.md): no word or comment is lost, the tree stays the same, formatting is
// idempotent, and blanks of the input do not matter. The test uses all available texts and random ones.
#include <gtest/gtest.h>

#include "formatting.hpp"
#include "frontend/syntax/print.hpp"
#include "tests/random_models/syntax/any_syntax.hpp"
#include "tests/random_models/tests/seeds.hpp"
#include "tests/rounds.hpp"

namespace robochart::frontend {
namespace {

using random_models::Random;
using random_models::seeds;
using testing::Example;
using testing::examples;
using testing::expect_laws;
using testing::formatted;
using testing::is_correct;
using testing::is_read_whole;
using testing::lengthened;
using testing::respaced;

TEST(FormatLaws, HoldOverAllTexts) {
    EXPECT_GT(examples().size(), tests::size_of_input(100));
    for (const Example& example : examples()) expect_laws(example);
}

TEST(FormatLaws, HoldUnderRandomBlanksAndComments) {
    std::size_t correct = 0;
    std::size_t tried = 0;
    for (const std::uint64_t seed : seeds(3))
        for (const Example& example : examples()) {
            Random random(seed);
            const Example mutant = respaced(example, random);
            ++tried;
            if (!is_correct(mutant)) continue;
            ++correct;
            expect_laws(mutant);
            if (HasFailure()) return;
        }
    EXPECT_GT(correct, tried / 2) << "most mutants are not models any more";
}

/// Each example is tried with some of the forms of a comment. ROBOCHART_SEEDS=7 tries each example with all forms.
TEST(FormatLaws, HoldWithACommentInEveryGap) {
    const std::vector<std::string> comments = {" /* c */ ",  " // c\n",    "\n// c\n",  "\n/* c */\n",
                                               "\n/* c */ ", " /* c */\n", "/* c\nd */"};
    for (const std::uint64_t seed : seeds(1))
        for (std::size_t i = 0; i < examples().size(); ++i) {
            const std::string& comment = comments[(i + seed) % comments.size()];
            const auto choose = [&](std::string_view before) { return std::string(before) + comment; };
            const Example mutant = respaced(examples()[i], choose);
            if (is_correct(mutant)) expect_laws(mutant);
            if (HasFailure()) return;
        }
}

/// Names have several lengths, so that lines may break anywhere. Each example is tried with some of the lengths.
/// ROBOCHART_SEEDS=4 tries each example with all lengths.
TEST(FormatLaws, HoldForLongNames) {
    const std::vector<std::size_t> lengths = {2, 8, 30, 130};
    for (const std::uint64_t seed : seeds(1))
        for (std::size_t i = 0; i < examples().size(); ++i) {
            Random random(seed);
            const Example mutant = lengthened(examples()[i], random, lengths[(i + seed) % lengths.size()]);
            const Example spaced = respaced(mutant, random);
            expect_laws(mutant);
            if (is_correct(spaced)) expect_laws(spaced);
            if (HasFailure()) return;
        }
}

/// Random texts have every construct, names of any length, blanks and comments.
TEST(FormatLaws, HoldForRandomSyntax) {
    for (const std::uint64_t seed : seeds(300)) {
        Random random(seed);
        const bool is_assertions = random.chance(30);
        const auto file = is_assertions ? random_models::any_assertions(seed) : random_models::any_syntax(seed);
        const Example plain{"seed " + std::to_string(seed), to_text(*file), is_assertions};
        const Example mutant = lengthened(plain, random, random.pick(std::vector<std::size_t>{1, 5, 20, 60}));
        const Example spaced = respaced(mutant, random);
        expect_laws(plain);
        expect_laws(mutant);
        if (is_correct(spaced)) expect_laws(spaced);
        if (HasFailure()) return;
    }
}

/// Checks that only the words determine the layout of texts without empty lines and comments. Returns true if the text
/// can be parsed with other line ends.
bool expect_independence(const Example& example) {
    const Example joined = respaced(example, [](std::string_view) { return " "; });
    const Example split = respaced(example, [](std::string_view) { return "\n"; });
    if (!is_correct(joined) || !is_correct(split) || !is_read_whole(example)) return false;
    EXPECT_EQ(formatted(joined.text, joined.is_assertions), formatted(split.text, split.is_assertions))
        << example.origin;
    return true;
}

TEST(FormatLaws, TheLayoutDoesNotDependOnBlanksOfTheText) {
    std::size_t compared = 0;
    for (const Example& example : examples()) {
        if (example.text.find("//") != std::string::npos || example.text.find("/*") != std::string::npos) continue;
        if (expect_independence(example)) ++compared;
    }
    EXPECT_GT(compared, 50U);
    for (const std::uint64_t seed : seeds(100)) {
        if (expect_independence({"seed " + std::to_string(seed), to_text(*random_models::any_syntax(seed)), false}))
            ++compared;
        if (HasFailure()) return;
    }
    EXPECT_GT(compared, 100U);
}

std::string machines(std::size_t count) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i) {
        const std::string n = std::to_string(i);
        text += "stm S" + n +
                "{ var x : nat = 1 // c\n initial i state a { entry x=x+1 ; e!(x) }\ntransition t { from i to a }\n" +
                "transition u {from a to a trigger f?x condition x>1 /\\ x<(2+3)*4 \\/ g(x, x, 2) action x = x*2 ; e!x "
                "}\n}\n";
    }
    return text;
}

/// If formatting takes more than linear time, the test exceeds its time limit.
TEST(FormatLaws, LongFilesTakeLinearTime) {
    EXPECT_FALSE(formatted(machines(tests::size_of_input(30'000))).empty());  // 150,000 lines
}

TEST(FormatLaws, LongRunsOfBlanksAndLongLinesTakeLinearTime) {
    constexpr std::size_t many = tests::size_of_input(1'000'000);
    const std::string blanks(many, ' ');
    const std::string lines(many, '\n');
    EXPECT_EQ(formatted("// a" + blanks + "b" + blanks + "\ntype" + blanks + "A" + lines + "type B" + lines),
              "// a" + blanks + "b\ntype A\n\ntype B\n");
    EXPECT_EQ(formatted("/* a" + blanks + "b" + lines + "*/"), "/* a" + blanks + "b" + lines + "*/\n");
    const std::string name(many, 'a');
    EXPECT_EQ(formatted("type " + name), "type " + name + "\n");
    std::string list = "interface I { const c : Seq(nat) = <1";
    for (std::size_t i = 0; i < many / 10; ++i) list += ",1";
    EXPECT_FALSE(formatted(list + "> }").empty());
}

TEST(FormatLaws, DeepNestingIsFine) {
    const auto wrapped = [](std::size_t depth, const std::string& open, const std::string& close) {
        std::string text = "const c : nat = ";
        for (std::size_t i = 0; i < depth; ++i) text += open;
        text += "1";
        for (std::size_t i = 0; i < depth; ++i) text += close;
        return "interface I { " + text + " }";
    };
    expect_laws({"parentheses", wrapped(200, "(", ")")});
    expect_laws({"calls", wrapped(200, "f(1, ", ")")});
    expect_laws({"sum", wrapped(900, "1 + ", "")});
    expect_laws({"if", wrapped(200, "if b then 2 else ", " end")});
    expect_laws({"minus", wrapped(200, "- ", "")});
}

}  // namespace
}  // namespace robochart::frontend
