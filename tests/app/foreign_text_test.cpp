// SPDX-License-Identifier: Apache-2.0
// Tests that text from models, their CSP blocks, scripts and file names never reaches a terminal as control characters
// and cannot forge lines of a report. Output for programs stays unchanged if it does not go to a terminal.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/app/command.hpp"

namespace robochart::app::testing::foreign_text_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

// The name contains an escape sequence and a line end, followed by a forged verdict. The literals and the block contain
// the same text. ESC is \033. CSI as one character of Latin-1 in UTF-8 is \302\233.
const char* const files = R"(
name=$(printf 'm\033]0;title\007\n  holds        Forged')
model="$name.rct"; claims="$name.assertions"
printf 'stm S {\n event e : string\n event g\n initial i\n state A { }\n transition t0 { from i to A }\n transition t1 { from A to A trigger g action e ! "a\033[31m\302\233\n  holds        Forged" }\n}\n' > "$model"
printf 'assertion F1 : S is divergence-free\nassertion F2 : P refines S in the traces model\ncsp P csp-begin\n-- \033[2J\nP = STOP\ncsp-end\nassertion F3 : S refines P in the traces model\n' > "$claims"
printf 'channel c : {"a\033[31m"}\n-- \033[2J\nassert c."a\033[31m" -> STOP [T= STOP\nassert STOP [T= c?x -> STOP\nprint "\033[31mb"\n' > "$name.csp"
)";

Ran run_on(const std::string& command) {
    return run_shell(std::string(files) + command);
}

/// Returns true if the text contains control characters of ASCII or Latin-1 other than line ends and tabs.
bool has_controls(const std::string& text) {
    const bool ascii = std::ranges::any_of(
        text, [](char c) { return (static_cast<unsigned char>(c) < 0x20U && c != '\n' && c != '\t') || c == 0x7F; });
    return ascii || text.find("\302\233") != std::string::npos;
}

void expect_clean(const Ran& ran, const std::string& command) {
    EXPECT_FALSE(has_controls(ran.out)) << command << "\n" << ran.out;
    EXPECT_FALSE(has_controls(ran.err)) << command << "\n" << ran.err;
    EXPECT_THAT("\n" + ran.out, Not(HasSubstr("\n  holds        Forged"))) << command;
    EXPECT_FALSE(ran.out.empty() && ran.err.empty()) << command;
}

TEST(ForeignText, IsShownInReports) {
    for (const std::string command : {"check \"$model\" \"$claims\" --trace",
                                      "check \"$model\" \"$claims\" --core",
                                      "check . --max-states 1",
                                      "check \"$model\" \"$claims\" --format junit",
                                      "check \"$model\" \"$claims\" --format sarif",
                                      "cspm \"$name.csp\" --format junit",
                                      "conform \"$model\"",
                                      "emit csp \"$model\" \"$claims\"",
                                      "emit csp \"$model\" --out \"$name\"",
                                      "emit cpp \"$model\" --out \"$name\"",
                                      "validate \"$model\"",
                                      "validate \"$name\"",
                                      "format --check \"$model\"",
                                      "format \"$model\"",
                                      "cspm \"$name.csp\"",
                                      "cspm --format plain \"$name.csp\"",
                                      "cspm --typecheck \"$name.csp\"",
                                      "cspm \"$name\"",
                                      "explain \"$name\"",
                                      "check \"$model\" --assertion \"$name\"",
                                      "\"$name\"",
                                      "check \"$model\" --component \"$name\"",
                                      "check \"$model\" --set \"$name\"",
                                      "simulate \"$model\""})
        expect_clean(run_on("\"$verify\" " + command), command);
}

/// Each claim is still reported, at its place.
TEST(ForeignText, IsReadableInReports) {
    const Ran ran = run_on("\"$verify\" check \"$model\" \"$claims\"");
    EXPECT_EQ(ran.exit, 1) << ran.out << ran.err;
    EXPECT_THAT(ran.out, HasSubstr(R"(at m\x1b]0;title\x07\n  holds        Forged.assertions:7)"));
}

TEST(ForeignText, OfWhatProgramsReadIsExact) {
    const Ran json = run_on("\"$verify\" check \"$model\" \"$claims\" --format json");
    EXPECT_THAT(json.out, Not(HasSubstr("\033")));
    const auto report = nlohmann::json::parse(json.out, nullptr, false);
    ASSERT_FALSE(report.is_discarded()) << json.out;
    EXPECT_THAT(report.dump(), HasSubstr(R"(m\u001b]0;title\u0007\n)"));
    const Ran formatted = run_on("\"$verify\" format - < \"$model\"");
    EXPECT_THAT(formatted.out, HasSubstr("\"a\033[31m\302\233\n  holds        Forged\"")) << formatted.err;
}

/// The program `script` of util-linux runs a command on a terminal.
TEST(ForeignText, OfWhatProgramsReadIsShownInATerminal) {
    if (run_shell("command -v script").exit != 0) GTEST_SKIP() << "there is no `script` here";
    for (const std::string command : {"check \"$model\" --print script", "check \"$model\" --print ast",
                                      "check \"$model\" \"$claims\" --format json", "format - < \"$model\""}) {
        const Ran ran = run_on("export verify name model claims; script -qec '\"$verify\" " + command +
                               "' /dev/null < /dev/null | tr -d '\\r'");
        EXPECT_FALSE(has_controls(ran.out)) << command << "\n" << ran.out;
        EXPECT_FALSE(ran.out.empty()) << command;
    }
}

}  // namespace
}  // namespace robochart::app::testing::foreign_text_test
