// SPDX-License-Identifier: Apache-2.0
// Tests that an assertion file with errors does not stop the claims of other files, and that a component with errors
// does not stop the claims about others. Claims that may depend on the errors are undecided.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "tests/app/command.hpp"

namespace robochart::app::testing::broken_claims_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

const std::string model =
    "stm M {\n event go\n initial i state A { }\n transition t0 { from i to A }\n transition t1 { from A to A trigger "
    "go }\n}\n";
const std::string good = "untimed assertion Good : M is deadlock-free.\n";
const std::string syntax_error =
    "untimed assertion Broken : M is dedlock-free.\nuntimed assertion Beside : M is divergence-free.\n";
const std::string unknown_name = "untimed assertion Broken : N is deadlock-free.\n";

using Files = std::vector<std::pair<std::string, std::string>>;

/// Maps titles to answers of the JSON report. The answer is empty if the report has none.
std::map<std::string, std::string> answers(const Files& files, int exit, const std::vector<std::string>& options = {}) {
    const Folder folder(files);
    std::vector<std::string> arguments{"check", folder.path(), "--format", "json"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Ran ran = run(arguments);
    EXPECT_EQ(ran.exit, exit) << ran.out << ran.err;
    const auto json = nlohmann::json::parse(ran.out);
    std::map<std::string, std::string> result;
    if (!json.contains("assertions")) return result;
    for (const auto& assertion : json.at("assertions")) {
        const std::string title = assertion.at("title");
        result[title.substr(0, title.find(' '))] = assertion.at("answer");
    }
    return result;
}

TEST(BrokenClaims, DoNotStopClaimsFiles) {
    const std::string english = "claim Never of M : never go\n";
    const auto found = answers({{"m.rct", model}, {"b.assertions", unknown_name + good}, {"m.claims", english}}, 2);
    EXPECT_EQ(found, (std::map<std::string, std::string>{{"Good", "holds"}, {"Broken", "error"}, {"Never", "fails"}}));
}

TEST(BrokenClaims, OfAnotherFileAreReportedAndTheRestIsDecided) {
    const auto unread = answers({{"m.rct", model}, {"a.assertions", good}, {"b.assertions", syntax_error}}, 2);
    EXPECT_EQ(unread, (std::map<std::string, std::string>{{"Good", "holds"}, {"Beside", "holds"}}));
    const auto unresolved = answers({{"m.rct", model}, {"a.assertions", good}, {"b.assertions", unknown_name}}, 2);
    EXPECT_EQ(unresolved, (std::map<std::string, std::string>{{"Good", "holds"}, {"Broken", "error"}}));
    const Folder folder({{"m.rct", model}, {"a.assertions", good}, {"b.assertions", unknown_name}});
    const Ran text = run({"check", folder.path()});
    EXPECT_EQ(text.exit, 2);
    EXPECT_THAT(text.out, HasSubstr("holds        Good"));
    EXPECT_THAT(text.out, HasSubstr("error        Broken"));
    EXPECT_THAT(text.out, HasSubstr("refused, with errors: b"));
    EXPECT_THAT(text.err, HasSubstr("b.assertions:1"));
}

const std::string wrong_block = "csp Wrong csp-begin\nWrong = undeclared -> STOP\ncsp-end\n";

std::string refining(const std::string& name, const std::string& process) {
    return "untimed assertion " + name + " : M refines " + process + " in the traces model.\n";
}

TEST(BrokenClaims, OfABlockAreThoseThatMayDependOnIt) {
    const std::string right = "csp Right csp-begin\nRight = M::go.in -> Right\ncsp-end\n";
    const std::string through = "csp Through csp-begin\nThrough = M::go.in -> Wrong\ncsp-end\n";
    const std::map<std::string, std::string> expected{
        {"Good", "holds"}, {"Own", "error"}, {"Right", "holds"}, {"Through", "error"}};
    EXPECT_EQ(answers({{"m.rct", model},
                       {"a.assertions", good},
                       {"b.assertions", wrong_block + refining("Own", "Wrong")},
                       {"c.assertions", right + refining("Right", "Right") + through + refining("Through", "Through")}},
                      2),
              expected);
    EXPECT_EQ(answers({{"m.rct", model},
                       {"a.assertions", good + wrong_block + refining("Own", "Wrong") + right +
                                            refining("Right", "Right") + through + refining("Through", "Through")}},
                      2),
              expected)
        << "in one file";
}

TEST(BrokenClaims, OfAnotherFileMayNameTheBlock) {
    EXPECT_EQ(
        answers({{"m.rct", model}, {"a.assertions", good + refining("Uses", "Wrong")}, {"b.assertions", wrong_block}},
                2),
        (std::map<std::string, std::string>{{"Good", "holds"}, {"Uses", "error"}}));
    EXPECT_EQ(
        answers({{"m.rct", model}, {"a.assertions", refining("Uses", "Wrong")}, {"b.assertions", wrong_block}}, 2),
        (std::map<std::string, std::string>{{"Uses", "error"}}))
        << "nothing is left";
}

// ---- errors in components

/// A machine without errors, one with an error, and one that runs the second one.
const std::string components =
    model +
    "stm Wrong {\n var x : nat\n initial i state A { entry x = true }\n transition t0 { from i "
    "to A }\n}\ncontroller C { sref w = Wrong }\n";
const std::string about_each =
    "timed assertion Other : Wrong is deadlock-free.\ntimed assertion User : C is deadlock-free.\n";

TEST(BrokenComponents, DoNotStopClaimsAboutOthers) {
    const auto found = answers({{"m.rct", components}, {"a.assertions", good + about_each}}, 2);
    EXPECT_EQ(found, (std::map<std::string, std::string>{{"Good", "holds"}, {"Other", "error"}, {"User", "error"}}));
    const Folder folder({{"m.rct", components}, {"a.assertions", good + about_each}});
    const Ran text = run({"check", folder.path()});
    EXPECT_EQ(text.exit, 2);
    EXPECT_THAT(text.out, HasSubstr("holds        Good"));
    EXPECT_THAT(text.err, HasSubstr("m.rct:9"));
    EXPECT_THAT(text.err, HasSubstr("warning[RC-A06]: no claim about `Wrong` is decided, because it has errors"));
    EXPECT_THAT(text.err,
                HasSubstr("no claim about `C` is decided, because it refers to a definition that is set aside"));
    EXPECT_THAT(text.err, Not(HasSubstr("no claim about `M`")));
}

TEST(BrokenComponents, MayBeNamedByBlocksAndOtherClaims) {
    const std::string block = "csp Block csp-begin\nBlock = Wrong::terminate -> STOP\ncsp-end\n";
    EXPECT_EQ(answers({{"m.rct", components},
                       {"a.assertions", good + block + refining("Uses", "Block") + refining("Both", "Wrong")}},
                      2),
              (std::map<std::string, std::string>{{"Good", "holds"}, {"Uses", "error"}, {"Both", "error"}}));
    const std::string instantiation =
        "csp Instantiations csp-begin\n-- for Wrong\nnametype core_nat = {0..1}\ncsp-end\n";
    const auto replaced = answers({{"m.rct", components}, {"a.assertions", good + instantiation}}, 2);
    EXPECT_EQ(replaced.count("Good"), 0U) << "the block may set values of everything";
    const std::string english = "claim Never of Wrong : never terminate\n";
    const auto claimed = answers({{"m.rct", components}, {"a.assertions", good}, {"m.claims", english}}, 2);
    EXPECT_EQ(claimed.count("Good"), 0U) << "the claims file is about the whole model";
}

TEST(BrokenComponents, OfOtherKindsStopAllClaims) {
    const std::string wrong_interface = "interface I { var x : Nowhere }\n";
    EXPECT_TRUE(answers({{"m.rct", model + wrong_interface}, {"a.assertions", good}}, 2).empty());
    EXPECT_TRUE(answers({{"m.rct", model + "stm Wrong { initial\n"}, {"a.assertions", good}}, 2).empty());
}

TEST(BrokenComponents, MayBeFoundAfterOthers) {
    // lowering finds the second error, and it runs only if the model has no others
    const std::string later =
        "stm Later {\n cycleDef cycle == 0.5\n input context { uses I }\n output context { }\n initial i\n state A { "
        "}\n "
        "transition t0 { from i to A }\n transition t1 { from A to A exec }\n}\n";
    const Files files{
        {"m.rct", components + "interface I { event pressed }\n"}, {"l.rst", later}, {"a.assertions", good}};
    EXPECT_EQ(answers(files, 2), (std::map<std::string, std::string>{{"Good", "holds"}}));
    const Folder folder(files);
    const Ran text = run({"check", folder.path()});
    EXPECT_THAT(text.err, HasSubstr("no claim about `Wrong` is decided"));
    EXPECT_THAT(text.err, HasSubstr("no claim about `Later` is decided"));
}

// The text of a syntax error after a claim may have been meant as a part of the claim. If it precedes the claim on the
// same line, it may have been meant as the claim's time.
TEST(BrokenClaims, IncludeClaimsNextToASyntaxError) {
    const std::string before = "untimed assertion Before : M is deadlock-free\n";
    const std::string after = "untimed assertion After : M is deadlock-free\n";
    const auto with = [&](const std::string& between) {
        return answers({{"m.rct", model}, {"a.assertions", good + before + between + after + refining("Last", "M")}},
                       2);
    };
    using Answers = std::map<std::string, std::string>;
    EXPECT_EQ(with("wth constant k of M set to 2\n"),
              (Answers{{"Good", "holds"}, {"Before", "error"}, {"After", "holds"}, {"Last", "holds"}}));
    EXPECT_EQ(with("timd "), (Answers{{"Good", "holds"}, {"Before", "error"}, {"After", "error"}, {"Last", "holds"}}));
    EXPECT_EQ(with("untimed assertion Broken : M is dedlock-free\n"),
              (Answers{{"Good", "holds"}, {"Before", "holds"}, {"After", "holds"}, {"Last", "holds"}}));
}

TEST(BrokenClaims, OfASyntaxErrorAndOfABlockAreBothLeftOut) {
    EXPECT_EQ(answers({{"m.rct", model}, {"a.assertions", good}, {"b.assertions", wrong_block + syntax_error}}, 2),
              (std::map<std::string, std::string>{{"Good", "holds"}, {"Beside", "holds"}}));
}

// A block that replaces the instantiation replaces it for all files, so an error in the only such block affects all
// claims. A text that cannot be parsed may contain any block. An error before all claims may affect all of them.
TEST(BrokenClaims, ThatOthersMayDependOnStopThem) {
    const std::string values = "csp Instantiations csp-begin\nnametype core_nat = undeclared\ncsp-end\n";
    const std::map<std::string, std::string> none{{"Good", "error"}};
    EXPECT_EQ(answers({{"m.rct", model}, {"a.assertions", good}, {"b.assertions", values}}, 2), none);
    EXPECT_EQ(answers({{"m.rct", model}, {"a.assertions", good}, {"b.assertions", "cps" + wrong_block.substr(3)}}, 2),
              none);
    EXPECT_EQ(answers({{"m.rct", model}, {"a.assertions", "imprt x\n" + good}}, 2), none);
}

TEST(BrokenClaims, AreLeftOutByNameToo) {
    const Files files{{"m.rct", model}, {"a.assertions", good + unknown_name}};
    EXPECT_EQ(answers(files, 2, {"--assertion", "Good"}), (std::map<std::string, std::string>{{"Good", "holds"}}));
    EXPECT_EQ(answers(files, 2, {"--assertion", "Broken"}), (std::map<std::string, std::string>{{"Broken", "error"}}));
    EXPECT_TRUE(answers(files, 2, {"--assertion", "None"}).empty());
}

TEST(BrokenClaims, OfAModelStopEverything) {
    const auto found = answers(
        {{"m.rct", "stm M { initial i state A { } transition t0 { from i to B } }\n"}, {"a.assertions", good}}, 2);
    EXPECT_TRUE(found.empty());
}

const std::string instantiations = "csp Instantiations csp-begin\nnametype core_nat = {0..4}\ncsp-end\n";

// Imports may occur between blocks and claims.
TEST(BrokenClaims, LeaveTheBlockInstantiationsOfTheirFileAlone) {
    const std::string package = "package P ";
    EXPECT_EQ(
        answers({{"m.rct", package + model},
                 {"a.assertions", instantiations + "import P::*\n" + good + wrong_block + refining("Own", "Wrong")}},
                2),
        (std::map<std::string, std::string>{{"Good", "holds"}, {"Own", "error"}}));
}

// If no claim can be decided, the report keeps its usual form, and the page is written.
TEST(BrokenClaims, AloneAreReportedInEveryFormat) {
    const Folder folder({{"m.rct", model}, {"b.assertions", wrong_block + refining("Own", "Wrong")}});
    const Ran json = run({"check", folder.path(), "--format", "json", "--html", folder / "page.html"});
    EXPECT_EQ(json.exit, 2);
    const auto report = nlohmann::json::parse(json.out);
    EXPECT_EQ(report.at("schema"), "robochart-verify/report/1");
    EXPECT_EQ(report.at("assertions").at(0).at("answer"), "error");
    EXPECT_EQ(report.at("refused").size(), 1U);
    std::ifstream page(folder / "page.html");
    const std::string text{std::istreambuf_iterator<char>(page), {}};
    EXPECT_THAT(text, HasSubstr("Own"));
    const Ran shown = run({"check", folder.path()});
    EXPECT_EQ(shown.exit, 2);
    EXPECT_THAT(shown.out, HasSubstr("error        Own"));
    EXPECT_THAT(shown.err, HasSubstr("undeclared"));
    EXPECT_THAT(run({"check", folder.path(), "--format", "junit"}).out, HasSubstr("Own"));
    EXPECT_THAT(run({"check", folder.path(), "--format", "sarif"}).out, HasSubstr("Own"));
}

TEST(BrokenClaims, DoNotKeepScriptsFromBeingWritten) {
    const Folder folder({{"m.rct", model}, {"b.assertions", good + wrong_block + refining("Own", "Wrong")}});
    const Ran ran = run({"emit", "csp", folder.path(), "--out", folder / "out"});
    EXPECT_EQ(ran.exit, 2);
    EXPECT_THAT(ran.err, HasSubstr("b.assertions:3"));
    const auto written = [&](const std::string& file) {
        std::ifstream script(folder / ("out/csp-gen/" + file));
        return std::string{std::istreambuf_iterator<char>(script), {}};
    };
    const std::string name = std::filesystem::path(folder.path()).filename();
    EXPECT_THAT(written(name + ".csp"), HasSubstr("module M"));
    EXPECT_THAT(written(name + "_assertions.csp"), HasSubstr("Good"));
    EXPECT_THAT(written(name + "_assertions.csp"), Not(HasSubstr("Wrong")));
}

}  // namespace
}  // namespace robochart::app::testing::broken_claims_test
