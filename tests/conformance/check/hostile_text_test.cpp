// SPDX-License-Identifier: Apache-2.0
// Tests models and file names that contain text with a meaning in the generated languages. The text must not be
// executed, the generated code must compile, and the verdict must be that of the same model with harmless text.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "conformance/check/conform.hpp"
#include "tests/conformance/bench.hpp"
#include "tests/conformance/check/expect_conforming.hpp"
#include "tests/temporary_folder.hpp"

namespace robochart::conformance {
namespace {

namespace fs = std::filesystem;

/// Escapes text for a RoboChart literal. Quotes and backslashes get a backslash, and line ends and tabs become `\n` and
/// `\t`.
std::string escape_text(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) {
        if (c == '\n')
            result += "\\n";
        else if (c == '\t')
            result += "\\t";
        else if (c == '"' || c == '\\')
            (result += '\\') += c;
        else
            result += c;
    }
    return result + '"';
}

/// Returns a machine with strings as values of events, variables, constants, conditions, predicates and assignments.
std::string machine(const std::string& text) {
    const std::string literal = escape_text(text);
    return "stm S { event e : string event f : string event g var s : string var b : boolean const c : string = " +
           literal + "\n initial i state A { } state B { entry f!" + literal +
           " }\n transition t0 { from i to A action s = c }\n transition t1 { from A to B trigger e?s condition s == " +
           literal + " }\n transition t2 { from B to A trigger g condition s != \"other\" action f!s } }\n";
}

Outcome outcome_of(const tests::TemporaryFolder& folder) {
    test::Model model(folder.path());
    return test::expect_conforming(model, model.machine_named("S")).outcome;
}

/// The value of this `let` refers to an outer variable with the same name as the bound variable.
TEST(HiddenNames, OfLetsMeanTheOuterOneInTheValue) {
    const test::ModelFolder folder(
        "stm S { event e : nat event f : boolean var v : nat = 1\n initial i state A { }\n"
        " transition t0 { from i to A action e ! (let v == v + 1 @ (let v == v, w == v @ (let w == v, v == w @ v)));\n"
        "  f ! (exists v : nat @ v > (let v == v @ (lambda v : nat @ v)(v))) } }\n");
    EXPECT_EQ(outcome_of(folder), Outcome::conforms);
}

class HostileText : public ::testing::TestWithParam<const char*> {};

TEST_P(HostileText, AsAStringIsAValue) {
    const test::ModelFolder folder(machine(GetParam()));
    EXPECT_EQ(outcome_of(folder), Outcome::conforms);
}

INSTANTIATE_TEST_SUITE_P(Strings, HostileText,
                         ::testing::Values("near", "\"", "\\", "a\nb", "\\n", "*/ //\\",
                                           "?"
                                           "?/",
                                           "?"
                                           "?/\n",
                                           "%s%n{}{0}", ")\"", ")--\"; #error", "'\"'", "\x1b[31m", "<b>&amp;]]>",
                                           "\", \"", "\xc3\xa9\xff", "e!?. tock", "\t ", "$(touch x)`touch x`",
                                           "\"}; static_assert(false); constexpr const char* q[] = {\""));

/// If the text were executed, it would create a file.
TEST(HostileText, IsNotCarriedOut) {
    const tests::TemporaryFolder folder;
    const std::string mark = folder.path() + "/carried_out";
    const std::string code =
        "\", }; extern \"C\" int creat(const char*, unsigned); [[gnu::used]] static const int made = "
        "creat(\"" +
        mark + "\", 0600); constexpr const char* q[] = {\"";
    folder.write("m.rct", machine(code));
    (void)outcome_of(folder);
    EXPECT_FALSE(fs::exists(mark));
}

class HostileFile : public ::testing::TestWithParam<const char*> {};

TEST_P(HostileFile, NamesNothingInTheCode) {
    const tests::TemporaryFolder folder;
    folder.write(std::string(GetParam()) + ".rct", machine("near"));
    EXPECT_EQ(outcome_of(folder), Outcome::conforms);
}

INSTANTIATE_TEST_SUITE_P(Files, HostileFile,
                         ::testing::Values("a\n#error carried out\n", "a\r#error\r", "ends with \\", "*\\ end",
                                           "?"
                                           "?",
                                           "\"", "-dash", "a b", "\xff", "\xe2\x80\xae", "$(touch x)", "%s{}",
                                           "@CLASS@"));

}  // namespace
}  // namespace robochart::conformance
