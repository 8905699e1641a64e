// SPDX-License-Identifier: Apache-2.0
// Tests additional output files: --json, --junit, --sarif and --html in one run, for every outcome.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/app/command.hpp"

namespace robochart::app::testing::beside_test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::Not;

// One claim holds, the other fails: state B has no outgoing transition.
constexpr const char* model = R"(
mkdir gate
echo 'stm Gate { event open initial i state A { } state B { } transition t0 { from i to A } transition t1 { from A to B trigger open } }' > gate/gate.rct
echo 'assertion Opens : Gate is divergence-free' > gate/gate.assertions
echo 'assertion Lasts : Gate is deadlock-free' >> gate/gate.assertions
)";

Ran gate(const std::string& arguments) {
    return run_shell(std::string(model) + "timeout 60 \"$verify\" " + arguments);
}

/// Prints the files that the run wrote.
constexpr const char* show_all =
    "; echo \"exit $?\"; for f in r.json r.xml r.sarif r.html; do echo \"== $f\"; cat $f; done";

std::string part(const std::string& shown, const std::string& file) {
    const std::string head = "== " + file + "\n";
    const std::size_t begin = shown.find(head);
    if (begin == std::string::npos) return "";
    const std::size_t text = begin + head.size();
    return shown.substr(text, shown.find("\n== ", text) - text);
}

TEST(Beside, AllFormatsComeFromOneRun) {
    const Ran ran =
        gate(std::string("check gate --json r.json --junit r.xml --sarif r.sarif --html r.html") + show_all);
    EXPECT_THAT(ran.out, HasSubstr("exit 1\n"));
    EXPECT_THAT(ran.out.substr(0, ran.out.find("exit 1")), HasSubstr("FAILS"));
    const json report = json::parse(part(ran.out, "r.json"));
    EXPECT_EQ(report.at("schema"), "robochart-verify/report/1");
    EXPECT_EQ(report.at("exit"), 1);
    EXPECT_THAT(part(ran.out, "r.xml"), HasSubstr("<failure "));
    const json log = json::parse(part(ran.out, "r.sarif"));
    EXPECT_FALSE(log.at("runs").at(0).at("results").empty());
    EXPECT_THAT(part(ran.out, "r.html"), HasSubstr("<!DOCTYPE html>"));
}

TEST(Beside, WhatIsPrintedStays) {
    const Ran alone = gate("check gate -q --format junit --no-cache | sed 's/time=\"[^\"]*\"//g'");
    const Ran beside = gate("check gate -q --format junit --no-cache --json r.json | sed 's/time=\"[^\"]*\"//g'");
    EXPECT_EQ(alone.out, beside.out);
}

TEST(Beside, ARefusedModelIsInTheFilesToo) {
    const Ran ran =
        run_shell(std::string("echo 'stm M { initial i' > m.rct; \"$verify\" check m.rct --json r.json --junit r.xml "
                              "--sarif r.sarif") +
                  show_all);
    EXPECT_THAT(ran.out, HasSubstr("exit 2\n"));
    EXPECT_EQ(json::parse(part(ran.out, "r.json")).at("schema"), "robochart-verify/diagnostics/1");
    EXPECT_THAT(part(ran.out, "r.xml"), HasSubstr("<error "));
    EXPECT_FALSE(json::parse(part(ran.out, "r.sarif")).at("runs").at(0).at("results").empty());
    EXPECT_THAT(ran.err, HasSubstr("error[")) << "findings are printed as ever";
}

TEST(Beside, AreWrittenWhereALimitEndsTheRun) {
    const Ran ran = gate(
        std::string("check gate --memory 1MiB --json r.json --junit r.xml --sarif r.sarif --html r.html") + show_all);
    EXPECT_THAT(ran.out, HasSubstr("exit 3\n"));
    EXPECT_THAT(std::string(json::parse(part(ran.out, "r.json")).at("limit")), HasSubstr("memory limit"));
    EXPECT_THAT(part(ran.out, "r.xml"), HasSubstr("name=\"limit\""));
    EXPECT_EQ(json::parse(part(ran.out, "r.sarif")).at("runs").at(0).at("invocations").at(0).at("executionSuccessful"),
              false);
    EXPECT_THAT(part(ran.out, "r.html"), HasSubstr("ended early: the memory limit"));
}

TEST(Beside, OneFileTakesOneFormat) {
    const Ran ran = gate("check gate --json r --sarif r");
    EXPECT_EQ(ran.exit, 4);
    EXPECT_THAT(ran.err, HasSubstr("r is given for two output formats"));
}

TEST(Beside, WhatCannotBeWrittenIsAnError) {
    const Ran ran = gate("check gate --json /dev/null/r.json");
    EXPECT_EQ(ran.exit, 2);
    EXPECT_THAT(ran.err, HasSubstr("/dev/null/r.json"));
}

TEST(Beside, OtherVerbsHaveThemToo) {
    const Ran ran = run_shell(
        "printf 'dtmc\\nmodule m s : [0..1]; [] s=0 -> (s\\047=1); endmodule\\n' > m.prism\n"
        "\"$verify\" prism m.prism --property 'P=? [ F s=1 ]' --json r.json > shown; echo \"exit $?\"; echo '== "
        "r.json'; cat r.json");
    EXPECT_THAT(ran.out, HasSubstr("exit 0\n")) << ran.err;
    EXPECT_TRUE(json::parse(part(ran.out, "r.json")).contains("schema"));
}

// The SARIF log must satisfy the requirements of GitHub's service and of Microsoft's validator.
TEST(Beside, ResultsOfCorePropertiesHavePlaces) {
    const Ran ran = run_shell(
        "echo 'stm Sitter { initial i state A { } transition t0 { from i to A } }' > m.rct\n"
        "\"$verify\" check m.rct --format sarif");
    const json run = json::parse(ran.out).at("runs").at(0);
    ASSERT_FALSE(run.at("results").empty());
    for (const json& result : run.at("results")) {
        const json& place = result.at("locations").at(0).at("physicalLocation");
        EXPECT_EQ(place.at("artifactLocation"), (json{{"uri", "m.rct"}, {"uriBaseId", "%SRCROOT%"}}));
        EXPECT_EQ(place.at("region").at("startLine"), 1);
        EXPECT_TRUE(result.at("partialFingerprints").contains("primaryLocationLineHash"));
    }
    for (const json& rule : run.at("tool").at("driver").at("rules"))
        for (const char* field : {"name", "shortDescription", "fullDescription", "help", "defaultConfiguration"})
            EXPECT_TRUE(rule.contains(field)) << field;
    EXPECT_EQ(run.at("automationDetails").at("id"), "check/m.rct/");
}

TEST(Beside, TitlesOfRulesHaveNoHoles) {
    const Ran ran = run_shell(
        "echo 'stm M { initial i state A { } transition t { from i to Q } }' > m.rct\n"
        "\"$verify\" validate m.rct --format sarif");
    const json run = json::parse(ran.out).at("runs").at(0);
    ASSERT_FALSE(run.at("tool").at("driver").at("rules").empty());
    for (const json& rule : run.at("tool").at("driver").at("rules")) {
        EXPECT_THAT(std::string(rule.at("shortDescription").at("text")), Not(HasSubstr("{}")));
        EXPECT_THAT(std::string(rule.at("fullDescription").at("text")), Not(HasSubstr("{}")));
    }
}

/// A slip on the command line must not overwrite a model. Answers of earlier runs may be replaced.
TEST(Beside, NothingThatIsReadIsOverwritten) {
    for (const char* arguments : {"check gate --json gate/gate.rct", "check gate/gate.rct --html gate/gate.assertions",
                                  "validate gate --sarif ./gate/../gate/gate.rct", "check gate --junit gate/gate.rct",
                                  "conform gate --export gate/gate.rct", "draw gate Gate --out gate/gate.rct"}) {
        const Ran ran = gate(std::string(arguments) + "; echo \"exit $?\"; cat gate/gate.rct gate/gate.assertions");
        EXPECT_THAT(ran.out, HasSubstr("exit 4\nstm Gate {")) << arguments;
        EXPECT_THAT(ran.out, HasSubstr("assertion Opens")) << arguments;
        EXPECT_THAT(ran.err, HasSubstr("would overwrite")) << arguments;
    }
    const Ran script = run_shell("echo 'P = STOP' > p.csp; \"$verify\" cspm p.csp --json p.csp; cat p.csp");
    EXPECT_EQ(script.out, "P = STOP\n") << script.err;
    const Ran twice =
        gate("check gate --json r.json > /dev/null; \"$verify\" check gate --json r.json > /dev/null; echo $?");
    EXPECT_EQ(twice.out, "1\n") << twice.err;
}

}  // namespace
}  // namespace robochart::app::testing::beside_test
