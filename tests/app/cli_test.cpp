// SPDX-License-Identifier: Apache-2.0
// Tests the command as users and CI servers run it: exit codes, hostile input, the case studies.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <iterator>

#include "tests/app/command.hpp"

namespace robochart::app::testing::cli_test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

std::string repeat(const std::string& text, std::size_t times) {
    std::string result;
    result.reserve(text.size() * times);
    for (std::size_t i = 0; i < times; ++i) result += text;
    return result;
}

TEST(Cli, HelpNamesTheExitCodes) {
    const Ran ran = run({"--help"});
    EXPECT_EQ(ran.exit, 0);
    EXPECT_THAT(ran.out, HasSubstr("Exit status:"));
    EXPECT_THAT(ran.out, HasSubstr("conform"));
    EXPECT_THAT(ran.err, IsEmpty());
}

TEST(Cli, WrongUsageIsExit4) {
    for (const auto& arguments : {std::vector<std::string>{},
                                  {"check"},
                                  {"check", "x", "--no-such-option"},
                                  {"emit"},
                                  {"check", "x", "--max-states", "0"}}) {
        const Ran ran = run(arguments);
        EXPECT_EQ(ran.exit, 4) << ran.err;
        EXPECT_THAT(ran.err, HasSubstr("try: robochart-verify ")) << ran.err;
        EXPECT_THAT(ran.err, HasSubstr("--help"));
    }
}

TEST(Cli, MalformedOptionValuesAreSaid) {
    const std::string model = repository("corpus/aggregation");
    EXPECT_EQ(run({"check", model, "--range", "nat=4..1"}).exit, 4);
    EXPECT_THAT(run({"check", model, "--range", "nat=x"}).err, AllOf(HasSubstr("RC-A01"), HasSubstr("TYPE=LOW..HIGH")));
    EXPECT_THAT(run({"check", model, "--const", "=3"}).err, HasSubstr("NAME=VALUE"));
    EXPECT_EQ(run({"check", model, "--const", "NoSuchConstant=3"}).exit, 4);
}

TEST(Cli, WarningsCanBeLeftOutOrDenied) {
    const TemporaryFile model("careless.rct",
                              "stm S {\n var v : nat\n initial i\n state A { }\n transition t0 { from i to A }\n}\n");
    const std::vector<std::string> emit{"emit", "csp", model.path()};
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.begin(), emit.begin(), emit.end());
        return run(more);
    };
    EXPECT_THAT(with({}).err, HasSubstr("warning[RC-W07]"));
    EXPECT_EQ(with({}).exit, 0);
    const Ran denied = with({"--deny-warnings"});
    EXPECT_EQ(denied.exit, 2);
    EXPECT_THAT(denied.err, AllOf(HasSubstr("warning[RC-W07]"), HasSubstr("--deny-warnings")));
    EXPECT_THAT(with({"--deny-warnings", "--format", "json"}).out, HasSubstr("\"code\":\"RC-W07\""));
    const Ran allowed = with({"--deny-warnings", "--allow", "RC-W02", "--allow", "rc-w07"});
    EXPECT_EQ(allowed.exit, 0);
    EXPECT_THAT(allowed.err, Not(HasSubstr("RC-W07")));
    EXPECT_EQ(run({"validate", model.path()}).exit, 0);
    EXPECT_EQ(run({"validate", model.path(), "--allow", "RC-W07", "--deny-warnings"}).out, "valid\n");
    const Ran invalid = run({"validate", model.path(), "--deny-warnings"});
    EXPECT_EQ(invalid.exit, 2);
    EXPECT_THAT(invalid.out, IsEmpty());
    EXPECT_THAT(invalid.err, HasSubstr("--deny-warnings"));
    for (const char* code : {"RC-N01", "nonsense"}) {
        const Ran wrong = with({"--allow", code});
        EXPECT_EQ(wrong.exit, 4) << wrong.err;
        EXPECT_THAT(wrong.err, HasSubstr("is not the code of a warning"));
    }
}

/// Output files are named after the input folder, however the command line writes the path of the folder.
TEST(Cli, TheCurrentFolderHasItsOwnName) {
    const Ran ran = run_shell(
        "mkdir -p rover/empty && cd rover\n"
        "echo 'stm S { initial i state A { } transition t { from i to A } }' > m.rct\n"
        "\"$verify\" emit csp . -q --out here && ls here/csp-gen/rover.csp\n"
        "cd empty && \"$verify\" emit csp .. -q --out there && ls there/csp-gen/rover.csp\n");
    EXPECT_EQ(ran.out, "here/csp-gen/rover.csp\nthere/csp-gen/rover.csp\n") << ran.err;
}

TEST(Cli, AnUnknownComponentIsSaid) {
    const Ran ran = run({"conform", repository("corpus/aggregation"), "--component", "NoSuch"});
    EXPECT_EQ(ran.exit, 4);
    EXPECT_THAT(ran.err, AllOf(HasSubstr("RC-A01"), HasSubstr("NoSuch")));
}

TEST(Cli, AnUnwritableFolderIsSaid) {
    const Ran ran = run({"emit", "csp", repository("corpus/aggregation"), "--out", "/dev/null/out"});
    EXPECT_EQ(ran.exit, 2);
    EXPECT_THAT(ran.err, AllOf(HasSubstr("RC-A03"), HasSubstr("/dev/null/out")));
}

const char* const counter =
    "stm S { const step : nat  var x : nat  event e : nat\n"
    "  initial i  state A { entry e ! step } transition t0 { from i to A } transition t1 { from A to A condition x > "
    "step } }\n";

TEST(Cli, AConstantOutsideItsTypesRangeIsWarnedOf) {
    const TemporaryFile file("model.rct", counter);
    EXPECT_THAT(run({"check", file.path(), "--const", "step=5", "--range", "nat=0..1"}).err, HasSubstr("RC-S17"));
}

TEST(Cli, ABlockThatNamesNothingIsBadInput) {
    const TemporaryFile model("model.rct", counter);
    const TemporaryFile block("model.assertions",
                              "csp P csp-begin\nP = Nowhere\ncsp-end\nassertion A1 : P is divergence-free\n");
    const Ran ran = run({"check", model.path(), block.path()});
    EXPECT_EQ(ran.exit, 2) << ran.out << ran.err;
    EXPECT_THAT(ran.err, AllOf(HasSubstr("Nowhere"), HasSubstr("model.assertions:2")));
}

TEST(Cli, ABlockThatIsIllTypedIsBadInput) {
    const TemporaryFile model("model.rct", counter);
    const TemporaryFile block(
        "model.assertions",
        "csp P csp-begin\nchannel c : {0..1}\nP = c.true -> STOP\ncsp-end\nassertion A1 : P is divergence-free\n");
    for (const char* const verb : {"check", "emit"}) {
        const Ran ran = verb == std::string("check")
                            ? run({verb, model.path(), block.path()})
                            : run({verb, "csp", model.path(), block.path(), "--out", block.path() + ".out"});
        EXPECT_EQ(ran.exit, 2) << ran.out << ran.err;
        EXPECT_THAT(ran.err, AllOf(HasSubstr("CSPM-T"), HasSubstr("model.assertions:3"), HasSubstr("c.true")));
    }
    const TemporaryFile right(
        "model.assertions",
        "csp P csp-begin\nchannel c : {0..1}\nP = c.1 -> STOP\ncsp-end\nassertion A1 : P is divergence-free\n");
    EXPECT_EQ(run({"check", model.path(), right.path()}).exit, 0);
}

// A block may repeat the `transparent` declarations of the library, and may redefine names of the library.
TEST(Cli, ABlockMayDefineWhatTheLibraryDefines) {
    const TemporaryFile model("model.rct", counter);
    const TemporaryFile block("model.assertions",
                              "timed csp P csp-begin\ntransparent sbisim\nTimed(OneStep) {\nEndBy(p,d) = p /\\ STOP\n"
                              "P = sbisim(EndBy(STOP, 1))\n}\ncsp-end\ntimed assertion A1 : P is divergence-free\n");
    const Ran ran = run({"check", model.path(), block.path()});
    EXPECT_EQ(ran.exit, 0) << ran.out << ran.err;
}

TEST(Cli, ReplacedInstantiationsAreNoted) {
    const TemporaryFile model("model.rct", counter);
    const TemporaryFile block("model.assertions",
                              "csp Instantiations csp-begin\nnametype core_nat = {0..1}\ncsp-end\n"
                              "assertion A1 : S is divergence-free\n");
    EXPECT_THAT(run({"check", model.path(), block.path()}).err, HasSubstr("RC-C07"));
}

TEST(Cli, MissingFileIsBadInput) {
    const Ran ran = run({"no/such/model.rct"});
    EXPECT_EQ(ran.exit, 2);
    EXPECT_THAT(ran.err, HasSubstr("no/such/model.rct"));
}

TEST(Cli, HostileTextsAreDiagnosed) {
    const std::string nested = "stm S { initial i state A { entry x = " + repeat("(", 10'000) + "1" +
                               repeat(")", 10'000) + " } transition t { from i to A } }";
    const char garbage[] = {'\x7f', 'E', 'L', 'F', '\0', '\xff', '\xfe', '\x01',
                            '\x80', 'g', '{', '{', '{',  '\n',   '\0'};
    const std::pair<const char*, std::string> cases[] = {
        {"empty", ""},
        {"garbage", std::string(std::begin(garbage), std::end(garbage))},
        {"long line", "stm " + std::string(10'000'000, 'x')},
        {"long noise", std::string(10'000'000, '(')},
        {"nested", nested},
        {"truncated", "module M { robotic platform P {"},
        {"unterminated comment", "stm S { /* never closed"},
        {"huge number",
         "stm S { var x : nat = 99999999999999999999999999 initial i state A { } transition t { from i to A } }"},
    };
    for (const auto& [name, text] : cases) {
        const TemporaryFile file("model.rct", text);
        const Ran ran = run({file.path()});
        EXPECT_EQ(ran.exit, 2) << name << ": " << ran.err.substr(0, 400);
        EXPECT_THAT(ran.err, Not(IsEmpty())) << name;
        EXPECT_LT(ran.err.size(), 100'000U) << name;
    }
}

TEST(Cli, JsonOnBadInputIsJson) {
    const TemporaryFile file("model.rct", "stm S {");
    const Ran ran = run({file.path(), "--format", "json"});
    EXPECT_EQ(ran.exit, 2);
    EXPECT_THAT(ran.out, HasSubstr("robochart-verify/diagnostics/1"));
}

TEST(Cli, FalseClaimShowsThePath) {
    const Ran ran = run({"check", repository("corpus/aggregation"),
                         repository("corpus/false_claims/aggregation.assertions"), "--assertion", "F1"});
    EXPECT_EQ(ran.exit, 1) << ran.out << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("FAILS"));
    EXPECT_THAT(ran.out, HasSubstr("seeRobot"));
    EXPECT_THAT(ran.out, HasSubstr("aggregation.rct:"));
}

TEST(Cli, ALimitIsInconclusive) {
    const Ran ran = run({"check", repository("corpus/aggregation"), "--assertion", "A7", "--max-states", "2"});
    EXPECT_EQ(ran.exit, 3) << ran.out;
    EXPECT_THAT(ran.out, HasSubstr("inconclusive"));
}

TEST(Cli, ExplainKnowsRulesAndSuggests) {
    EXPECT_EQ(run({"explain", "J3"}).exit, 0);
    EXPECT_EQ(run({"explain", "NOSUCHRULE"}).exit, 4);
}

TEST(Cli, ScriptsAreChecked) {
    const TemporaryFile good("good.csp",
                             "channel a, b\nP = a -> b -> P\nassert P :[deadlock free]\nassert not STOP [T= P\n");
    EXPECT_EQ(run({"cspm", good.path()}).exit, 0);
    const TemporaryFile bad("bad.csp", "channel a\nassert STOP [T= a -> STOP\n");
    const Ran ran = run({"cspm", bad.path()});
    EXPECT_EQ(ran.exit, 1) << ran.out << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("<a>"));
    const TemporaryFile broken("broken.csp", "P = (\n");
    EXPECT_EQ(run({"cspm", broken.path()}).exit, 2);
}

TEST(Cli, ScriptsAreTypeCheckedFirst) {
    const TemporaryFile good("good.csp", "channel a : Int\nf(x) = a.x\nassert STOP [T= f(1) -> STOP\n");
    const Ran checked = run({"cspm", "--typecheck", good.path()});
    EXPECT_EQ(checked.exit, 0) << checked.err;
    EXPECT_THAT(checked.out, HasSubstr("types of 2 names"));
    EXPECT_EQ(run({"cspm", "--types", good.path()}).out, "a :: Int => Event\nf :: (Int) -> Event\n");
    const Ran json = run({"cspm", "--types", "--format", "json", good.path()});
    EXPECT_THAT(json.out, HasSubstr(R"("name":"f","type":"(Int) -> Event")"));
    const Ran brief = run({"cspm", "-b", good.path()});
    EXPECT_EQ(brief.exit, 1);
    EXPECT_THAT(brief.out, Not(HasSubstr("trace")));
    // The script is not evaluated: evaluation of the first assertion alone would fail.
    const TemporaryFile bad("bad.csp", "channel a : Int\nassert STOP [T= a.1 -> STOP\nP = a.true -> STOP\n");
    const Ran refused = run({"cspm", bad.path()});
    EXPECT_EQ(refused.exit, 2) << refused.out;
    EXPECT_THAT(refused.err, HasSubstr("CSPM-T08"));
    EXPECT_EQ(refused.out, "");
    EXPECT_THAT(run({"cspm", "--typecheck", "--format", "json", bad.path()}).out,
                HasSubstr("robochart-verify/diagnostics/1"));
}

/// Only the simulation and the comparison of code with its model need a compiler.
TEST(Cli, WithoutACompilerTheVerdictsAreKnown) {
    const std::string model = repository("corpus/aggregation");
    const Ran ran = run_shell("PATH=/nonexistent \"$verify\" '" + model + "'");
    EXPECT_EQ(ran.exit, 3) << ran.err;
    EXPECT_THAT(ran.out, AllOf(HasSubstr("holds        A1"), HasSubstr("22 of 22 checks hold"),
                               HasSubstr("conformance was not checked: cannot run c++"), HasSubstr("apt install g++")));
    EXPECT_EQ(run_shell("PATH=/nonexistent \"$verify\" check '" + model + "'").exit, 0);
    const Ran conform = run_shell("PATH=/nonexistent \"$verify\" conform --format junit '" + model + "'");
    EXPECT_EQ(conform.exit, 3) << conform.err;
    EXPECT_THAT(conform.out, HasSubstr("<error message=\"conformance was not checked"));
    const Ran simulated = run_shell("PATH=/nonexistent \"$verify\" simulate '" + model + "/aggregation.scenario'");
    EXPECT_EQ(simulated.exit, 3) << simulated.err;
    EXPECT_THAT(simulated.out, HasSubstr("apt install g++"));
}

class CaseStudy : public ::testing::TestWithParam<const char*> {};

TEST_P(CaseStudy, HoldsAndConforms) {
    const TemporaryFile beside("beside.txt", "");
    const std::string out = std::filesystem::path(beside.path()).parent_path() / "out";
    const Ran ran = run({repository(std::string("corpus/") + GetParam()), "--out", out});
    EXPECT_EQ(ran.exit, 0) << ran.out << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("conforms"));
    EXPECT_THAT(ran.out, Not(HasSubstr("FAILS")));
    EXPECT_THAT(ran.out, HasSubstr("out/csp-gen/timed/"));
    EXPECT_THAT(ran.out, HasSubstr("out/cpp/"));
    // All scripts exported for FDR, including the normal form, are well-typed.
    std::vector<std::string> words{"cspm", "--typecheck", "-q"};
    for (const auto& file : std::filesystem::recursive_directory_iterator(out)) {
        if (file.path().extension() == ".csp") words.push_back(file.path());
    }
    EXPECT_GT(words.size(), 6U);
    const Ran typed = run(words);
    EXPECT_EQ(typed.exit, 0) << typed.err;
}

INSTANTIATE_TEST_SUITE_P(Corpus, CaseStudy, ::testing::Values("aggregation", "swarm_taxis"));

}  // namespace
}  // namespace robochart::app::testing::cli_test
