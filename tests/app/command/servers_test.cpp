// SPDX-License-Identifier: Apache-2.0
// Tests output for continuous integration servers (JUnit's XML and SARIF, for assertions and code), and colours, which
// appear only on terminals.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <algorithm>

#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "app/base/junit.hpp"
#include "tests/app/command.hpp"

namespace robochart::app::testing::servers_test {
namespace {

using nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

/// An element of an XML document.
struct Element {
    std::string name;
    std::map<std::string, std::string> attributes;
    std::string inside;  ///< names of the elements from the root on
};

/// Parses an XML 1.0 document without comments, processing instructions and similar constructs. Fails the test if the
/// document is not well-formed.
std::vector<Element> elements(const std::string& document) {
    static const std::regex tag("<(/?)([a-z-]+)((?: [a-z]+=\"[^\"<]*\")*)(/?)>"), attribute("([a-z]+)=\"([^\"<]*)\"");
    static const std::regex entity("&(?:amp|lt|gt|quot|#39|#45);");
    const std::string head = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
    EXPECT_TRUE(document.starts_with(head));
    const std::string text = document.substr(head.size());
    EXPECT_EQ(std::regex_replace(text, entity, "").find('&'), std::string::npos) << "a bare &";
    for (const char c : text) EXPECT_TRUE(static_cast<unsigned char>(c) >= 0x20U || c == '\n') << static_cast<int>(c);
    std::vector<Element> found;
    std::vector<std::string> open;
    for (auto at = std::sregex_iterator(text.begin(), text.end(), tag); at != std::sregex_iterator(); ++at) {
        const std::string name = (*at)[2];
        if ((*at)[1] == "/") {
            if (open.empty() || open.back() != name) {
                ADD_FAILURE() << "not open: " << name;
                return found;
            }
            open.pop_back();
            continue;
        }
        Element one{name, {}, ""};
        for (const std::string& ancestor : open) one.inside += ancestor + "/";
        const std::string list = (*at)[3];
        for (auto a = std::sregex_iterator(list.begin(), list.end(), attribute); a != std::sregex_iterator(); ++a)
            EXPECT_TRUE(one.attributes.emplace((*a)[1], (*a)[2]).second) << "twice: " << (*a)[1];
        found.push_back(one);
        if ((*at)[4] != "/") open.push_back(name);
    }
    EXPECT_TRUE(open.empty());
    EXPECT_EQ(std::regex_replace(text, tag, "").find('<'), std::string::npos) << "a bare <";
    return found;
}

std::size_t count(const std::vector<Element>& all, const std::string& name) {
    return static_cast<std::size_t>(
        std::ranges::count_if(all, [&](const Element& element) { return element.name == name; }));
}

TEST(Junit, IsWellFormedWhateverItHolds) {
    const std::string hostile = "a\"b'c<d>&e]]>--\x1b[31m\x01\xff\xc2\x9b</failure>\nsecond\tline";
    using Kind = JunitCase::Kind;
    std::vector<JunitCase> cases;
    for (const Kind kind : {Kind::passed, Kind::failed, Kind::error, Kind::skipped})
        cases.push_back({hostile, hostile, kind, hostile, hostile, 0.5});
    const auto all = elements(junit_document(hostile, cases));
    EXPECT_EQ(count(all, "testcase"), 4U);
    EXPECT_EQ(count(all, "failure"), 1U);
    EXPECT_EQ(count(all, "error"), 1U);
    EXPECT_EQ(count(all, "skipped"), 1U);
    EXPECT_EQ(count(all, "system-out"), 1U);
    for (const std::size_t at : {0U, 1U}) {
        const auto& attributes = all.at(at).attributes;
        EXPECT_EQ(attributes.at("tests"), "4");
        EXPECT_EQ(attributes.at("failures"), "1");
        EXPECT_EQ(attributes.at("errors"), "1");
        EXPECT_EQ(attributes.at("skipped"), "1");
        EXPECT_EQ(attributes.at("time"), "2.000");
    }
}

/// Checks the attributes that all schemas of JUnit's XML have in common, and an order of elements that all of them
/// allow.
TEST(Junit, HasWhatAllSchemasHave) {
    const auto all = elements(junit_document(
        "s", {{"g", "n", JunitCase::Kind::failed, "m", "t", 0}, {"g", "n", JunitCase::Kind::passed, "", "t", 0}}));
    const std::map<std::string, std::pair<std::string, std::set<std::string>>> expected{
        {"testsuites", {"", {"name", "tests", "failures", "errors", "skipped", "time"}}},
        {"testsuite", {"testsuites/", {"name", "tests", "failures", "errors", "skipped", "time"}}},
        {"testcase", {"testsuites/testsuite/", {"classname", "name", "time"}}},
        {"failure", {"testsuites/testsuite/testcase/", {"message", "type"}}},
        {"system-out", {"testsuites/testsuite/", {}}}};
    for (const Element& element : all) {
        std::set<std::string> names;
        for (const auto& [name, value] : element.attributes) names.insert(name);
        EXPECT_EQ(names, expected.at(element.name).second) << element.name;
        EXPECT_EQ(element.inside, expected.at(element.name).first) << element.name;
    }
}

// The folder has four models: a machine that stops, an assertion that holds, an assertion that fails, and an assertion
// that this tool cannot decide.
constexpr const char* files = R"(
echo 'stm S { event e initial i state A { } state B { } transition t0 { from i to A } transition t1 { from A to B trigger e } }' > m.rct
printf 'untimed assertion Good : S is divergence-free\nuntimed assertion Bad : S is deadlock-free\n' > m.assertions
mkdir other; cp m.rct other; printf 'prob property P : Prob=? of [Finally S is in S::A] using sim with CI at alpha=0.01, n=1000\n' > other/p.assertions
printf 'channel a, b\nP = a -> P\nprint 1\nassert P :[deadlock free [F]]\nassert STOP [T= P\n' > s.csp
)";

Ran run_on(const std::string& command) {
    return run_shell(std::string(files) + "timeout 100 \"$verify\" " + command);
}

TEST(Junit, HasACaseForEachAssertion) {
    for (const char* verb : {"check", "verify"}) {
        const Ran ran = run_on(std::string(verb) + " m.rct --format junit --untimed");
        EXPECT_EQ(ran.exit, 1) << ran.err;
        const auto all = elements(ran.out);
        EXPECT_EQ(count(all, "failure"), 1U) << ran.out;
        EXPECT_EQ(count(all, "error"), 0U) << ran.out;
        EXPECT_EQ(count(all, "testcase"), std::string(verb) == "check" ? 2U : 3U) << ran.out;
        EXPECT_THAT(ran.out, AllOf(HasSubstr("classname=\"m.assertions\" name=\"Good"), HasSubstr("m.rct:1"),
                                   HasSubstr("input e"), HasSubstr("claimed at m.assertions:2")));
    }
}

TEST(Junit, SkipsWhatIsNotDecidedHere) {
    const Ran ran = run_on("check other --format junit");
    EXPECT_EQ(ran.exit, 3) << ran.err;
    EXPECT_EQ(count(elements(ran.out), "skipped"), 1U) << ran.out;
}

TEST(Junit, OfCodeHasACaseForEachComponent) {
    const Ran ran = run_on("conform m.rct --format junit");
    EXPECT_EQ(ran.exit, 0) << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("<testcase classname=\"conformance\" name=\"S\""));
    EXPECT_EQ(run_on("conform m.rct --format junit --traces m.rct").exit, 4);
}

TEST(Junit, OfScriptsIsOneDocument) {
    const Ran ran = run_on("cspm s.csp s.csp m.rct --format junit");
    EXPECT_EQ(ran.exit, 2) << ran.err;
    const auto all = elements(ran.out);
    EXPECT_EQ(count(all, "testcase"), 5U) << ran.out;
    EXPECT_EQ(count(all, "failure"), 2U) << ran.out;
    EXPECT_EQ(count(all, "error"), 1U) << ran.out;
    EXPECT_EQ(run_on("cspm s.csp --types --format junit").exit, 4);
}

/// An undecided claim must not pass.
TEST(Junit, CountsWhatIsNotKnownAsAnError) {
    for (const char* command : {"check m.rct --untimed --max-states 1", "check m.rct --timeout 0.000001",
                                "conform m.rct --timeout 0.000001", "cspm s.csp --timeout 0.000001"}) {
        const Ran ran = run_on(std::string(command) + " --format junit");
        EXPECT_EQ(ran.exit, 3) << command << ran.err;
        EXPECT_GE(count(elements(ran.out), "error"), 1U) << command << ran.out;
    }
    const Ran ran = run_shell("echo 'stm S {' > m.rct; \"$verify\" check m.rct --format junit");
    EXPECT_EQ(ran.exit, 2);
    EXPECT_EQ(count(elements(ran.out), "error"), 1U) << ran.out;
    EXPECT_THAT(ran.out, HasSubstr("RC-P01"));
    const Ran nothing = run_on("check m.rct --timed --format junit");
    EXPECT_EQ(nothing.exit, 2) << nothing.out;
    EXPECT_EQ(count(elements(nothing.out), "error"), 1U) << nothing.out;
}

TEST(Junit, OfSeveralProjectsHasThoseWithErrors) {
    const Ran ran = run_on("check m.rct broken.rct --format junit --untimed");
    EXPECT_EQ(ran.exit, 2);
    const Ran two = run_shell(std::string(files) +
                              "mkdir a b; mv m.* a; echo 'stm T { initial i }' > b/t.rct; \"$verify\" check a b "
                              "--format junit --untimed");
    EXPECT_EQ(two.exit, 2) << two.err;
    const auto all = elements(two.out);
    EXPECT_EQ(count(all, "failure"), 1U) << two.out;
    EXPECT_EQ(count(all, "error"), 1U) << two.out;
    EXPECT_THAT(two.err, HasSubstr("b/t.rct"));
}

TEST(AssertionSarif, HasAResultWithItsRunForWhatFails) {
    const Ran ran = run_on("check m.rct --format sarif --untimed");
    EXPECT_EQ(ran.exit, 1) << ran.err;
    const json run = json::parse(ran.out).at("runs").at(0);
    ASSERT_EQ(run.at("results").size(), 1U);
    const json& result = run.at("results").at(0);
    EXPECT_EQ(run.at("tool").at("driver").at("rules").at(result.at("ruleIndex").get<std::size_t>()).at("id"),
              result.at("ruleId"));
    EXPECT_EQ(result.at("level"), "error");
    EXPECT_EQ(result.at("kind"), "fail");
    EXPECT_THAT(result.at("message").at("text").get<std::string>(), HasSubstr("Bad [untimed]"));
    const json& place = result.at("locations").at(0).at("physicalLocation");
    EXPECT_EQ(place.at("artifactLocation").at("uri"), "m.assertions");
    EXPECT_EQ(place.at("region").at("startLine"), 2);
    const json& steps = result.at("codeFlows").at(0).at("threadFlows").at(0).at("locations");
    std::string text;
    for (const json& step : steps) {
        EXPECT_EQ(step.at("location").at("physicalLocation").at("artifactLocation").at("uri"), "m.rct");
        text += step.at("location").at("message").at("text").get<std::string>() + "\n";
    }
    EXPECT_THAT(text, AllOf(HasSubstr("t0: i -> A"), HasSubstr("input e")));
}

TEST(AssertionSarif, LeavesOpenWhatIsNotKnown) {
    const Ran ran = run_on("check m.rct --format sarif --untimed --max-states 1");
    EXPECT_EQ(ran.exit, 3) << ran.err;
    for (const json& result : json::parse(ran.out).at("runs").at(0).at("results")) {
        EXPECT_EQ(result.at("kind"), "open");
        EXPECT_EQ(result.at("level"), "none");
    }
    const Ran wrong = run_shell("echo 'stm S {' > m.rct; \"$verify\" check m.rct --format sarif");
    EXPECT_EQ(wrong.exit, 2);
    EXPECT_EQ(json::parse(wrong.out).at("runs").at(0).at("results").at(0).at("ruleId"), "RC-P01");
}

constexpr const char* green_holds = "\x1b[1m\x1b[32mholds\x1b[0m";
constexpr const char* red_fails = "\x1b[1m\x1b[31mFAILS\x1b[0m";

TEST(Colours, AreOfTheVerdicts) {
    const Ran check = run_on("check m.rct --untimed --color always");
    EXPECT_THAT(check.out, AllOf(HasSubstr(green_holds), HasSubstr(red_fails)));
    EXPECT_THAT(run_on("verify m.rct --untimed --color always").out,
                AllOf(HasSubstr(red_fails), HasSubstr("\x1b[32mconforms\x1b[0m")));
    EXPECT_THAT(run_on("cspm s.csp --color always").out, AllOf(HasSubstr(green_holds), HasSubstr(red_fails)));
}

TEST(Colours, AreForTerminalsAlone) {
    for (const char* command : {"check m.rct --untimed", "check m.rct --untimed --color never", "cspm s.csp"})
        EXPECT_THAT(run_on(command).out, Not(HasSubstr("\x1b"))) << command;
    for (const char* format : {"json", "junit", "sarif"})
        EXPECT_THAT(run_on(std::string("check m.rct --untimed --color always --format ") + format).out,
                    Not(HasSubstr("\x1b")));
    EXPECT_THAT(run_on("cspm s.csp --format plain --color always").out, Not(HasSubstr("\x1b")));
}

/// Without its colours, the output is the same as the plain output.
TEST(Colours, AreAllThatIsAdded) {
    static const std::regex escape("\x1b\\[[0-9;]*m"), milliseconds("[0-9.]+ m?s");
    const auto plain = [](const std::string& text) {
        return std::regex_replace(std::regex_replace(text, escape, ""), milliseconds, "T");
    };
    EXPECT_EQ(plain(run_on("check m.rct --untimed --color always").out), plain(run_on("check m.rct --untimed").out));
}

/// The program `script` runs the command on a terminal.
TEST(Colours, AreThereOnATerminalUnlessNoColorIsSet) {
    if (run_shell("command -v script").exit != 0) GTEST_SKIP() << "`script` is not installed";
    const std::string with = std::string(files) + "printf '%s' \"\\\"$verify\\\" check m.rct --untimed\" > run.sh; ";
    EXPECT_THAT(run_shell(with + "env -u NO_COLOR script -qec 'sh run.sh' /dev/null").out, HasSubstr(green_holds));
    EXPECT_THAT(run_shell(with + "NO_COLOR=1 script -qec 'sh run.sh' /dev/null").out, Not(HasSubstr("\x1b[32m")));
}

/// A single file is loaded with the files of its folder that it needs.
TEST(OneFile, FindsItsProject) {
    const std::string project = std::string(files) + "mkdir p; mv m.* p; cd p; ";
    for (const char* file : {"m.assertions", "m.rct", "./m.assertions"}) {
        const Ran ran = run_shell(project + "\"$verify\" check --untimed " + file);
        EXPECT_EQ(ran.exit, 1) << ran.err;
        EXPECT_THAT(ran.out, HasSubstr("1 of 2 checks hold, 1 fail"));
    }
    EXPECT_EQ(run_shell(project + "cd ..; \"$verify\" check --untimed p/m.assertions").exit, 1);
}

/// The assertions are in a subfolder of the folder with their models.
TEST(OneFile, FindsTheModelsAboveItsFolder) {
    const std::string project = std::string(files) + "mkdir -p p/claims; mv m.rct p; mv m.assertions p/claims; ";
    for (const char* command : {"check p/claims/m.assertions", "cd p; check claims/m.assertions",
                                "cd p/claims; check m.assertions", "cd p/claims; check ./m.assertions"}) {
        std::string line = command;
        line.replace(line.find("check"), 5, "\"$verify\" check --untimed");
        const Ran ran = run_shell(project + line);
        EXPECT_EQ(ran.exit, 1) << command << ran.err;
        EXPECT_THAT(ran.out, HasSubstr("1 of 2 checks hold, 1 fail")) << command;
    }
    // The parent folder is not searched if the file's own folder has a model, or if there are other inputs.
    EXPECT_EQ(run_shell(project + "echo 'stm T { initial i state A { } transition t { from i to A } }' > "
                                  "p/claims/t.rct; \"$verify\" check p/claims/m.assertions")
                  .exit,
              2);
    EXPECT_EQ(run_shell(project + "\"$verify\" check p/claims/m.assertions s.rct").exit, 2);
}

}  // namespace
}  // namespace robochart::app::testing::servers_test
