// `--html`: the page says what the JSON says, marks elements that are there, and lets nothing of the model act.
#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <string>

#include "diagnostics/cache/digest.hpp"
#include "tests/app/command.hpp"
#include "tests/app/command/page.hpp"
#include "tests/contents.hpp"

namespace robochart::app::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using tests::contents;

struct Both {
    std::string page;
    nlohmann::json json;
};

Both reported(const std::vector<std::string>& models) {
    const Folder folder;
    std::vector<std::string> words{"check", "--format", "json", "--no-cache", "--html", folder / "page.html"};
    words.insert(words.end(), models.begin(), models.end());
    const Ran ran = run(words);
    return {contents(folder / "page.html"), nlohmann::json::parse(ran.out)};
}

TEST(Html, HasTheStepsOfEachCounterexample) {
    for (const std::string study : {"aggregation", "swarm_taxis"}) {
        const Both both =
            reported({repository("corpus/" + study), repository("corpus/false_claims/" + study + ".assertions")});
        std::size_t failing = 0;
        const std::vector<std::string> claims = between(both.page, "<section class=\"claim\"", "</section>");
        for (const auto& assertion : both.json["assertions"]) {
            if (!assertion.contains("counterexample")) continue;
            ASSERT_LT(failing, claims.size());
            const std::string& claim = claims[failing++];
            EXPECT_EQ(between(claim, "<tr class=\"step\"", ">").size(),
                      assertion["counterexample"]["steps"].size() + 1);
        }
        EXPECT_GT(failing, 0U);
        EXPECT_EQ(claims.size(), failing);
        EXPECT_EQ(between(both.page, "<td class=\"answer", ">").size(), both.json["assertions"].size());
    }
}

// "0:e5 1:e9" in `data-on` and `data-fired`: element e5 of the first figure of the claim.
TEST(Html, MarksElementsOfItsDiagrams) {
    const Both both =
        reported({repository("corpus/aggregation"), repository("corpus/false_claims/aggregation.assertions")});
    std::size_t marks = 0;
    for (const std::string& claim : between(both.page, "<section class=\"claim\"", "</section>"))
        for (const std::string& list : all(claim, "data-(?:on|fired)=\"([^\"]*)\""))
            for (const std::string& mark : all(list, "([0-9]+:e[0-9]+)")) {
                ++marks;
                EXPECT_THAT(claim, HasSubstr("data-element=\"" + mark.substr(mark.find(':') + 1) + "\"")) << mark;
            }
    EXPECT_GT(marks, 10U);
}

TEST(Html, ActiveStatesAreThoseOfTheRun) {
    const Folder folder(
        {{"m.rct", R"(package p stm S { event e initial i state A { } state B { }
transition t0 { from i to A } transition t1 { from A to B trigger e } })"},
         {"m.assertions", "package q import p::* untimed assertion X : p::S::B is not reachable in p::S"}});
    const Both both = reported({folder.path()});
    const std::string claim = between(both.page, "<section class=\"claim\"", "</section>").at(0);
    const auto id_of = [&](const std::string& name) {
        return all(claim, "data-element=\"(e[0-9]+)\"><title>" + name + "</title>").at(0);
    };
    const auto on = all(claim, "data-on=\"([^\"]*)\"");
    EXPECT_EQ(on.front(), "") << "at the initial junction";
    EXPECT_EQ(on.back(), "0:" + id_of("state B"));
    EXPECT_THAT(claim, HasSubstr("data-fired=\"0:" +
                                 all(claim, "class=\"edge[^\"]*\" id=\"[^\"]*\" data-element=\"(e[0-9]+)\"").at(1)));
}

// Without script: the diagrams are as they are behind the last step, in which t1 has led to B.
TEST(Html, ShowsTheEndWithoutScript) {
    const Folder folder(
        {{"m.rct", R"(package p stm S { event e initial i var x : nat state A { } state B { }
transition t0 { from i to A action x = 2 } transition t1 { from A to B trigger e }
transition t2 { from B to B trigger e condition x == 2 } })"},
         {"m.assertions", "package q import p::* untimed assertion X : p::S::B is not reachable in p::S"}});
    const Both both = reported({folder.path()});
    const std::string claim = between(both.page, "<section class=\"claim\"", "</section>").at(0);
    EXPECT_THAT(all(claim, "<g class=\"node on[^\"]*\"[^>]*><title>([^<]*)</title>"),
                ::testing::ElementsAre("state B"));
    EXPECT_THAT(between(claim, "<p class=\"values\">", "</p>"), ::testing::ElementsAre("x = 2"));
    EXPECT_THAT(claim, Not(HasSubstr(">time</th>"))) << "untimed";
    // The row in which x is written has it as changed, the others no variable.
    EXPECT_EQ(all(claim, "data-values=\"([^\"]*&quot;x&quot;,&quot;2&quot;,true[^\"]*)\"").size(), 1U);
}

// B is never reached and t1 never taken; t2 is taken in the machine alone.
TEST(Html, WhatNoRunExercisesIsDashed) {
    const TemporaryFile file("m.rct", R"(package p stm S { event e initial i var x : nat state A { } state B { }
transition t0 { from i to A } transition t1 { from A to B trigger e condition x > 1 }
transition t2 { from A to A trigger e } })");
    const Both both = reported({file.path()});
    const std::string diagrams = between(both.page, "<section id=\"diagrams\"", "</section>").at(0);
    EXPECT_THAT(diagrams, HasSubstr("2 elements are dashed"));
    EXPECT_EQ(all(diagrams, "class=\"(node|edge) unexercised\"").size(), 2U);
    EXPECT_THAT(all(diagrams, "<g class=\"node unexercised\"[^>]*><title>([^<]*)</title>"),
                ::testing::ElementsAre("state B"));
}

// Both triggerless: it goes on for ever without time passing.
TEST(Html, AModelThatIsNotSchedulableIsSteppedThrough) {
    const TemporaryFile file("m.rct", R"(package p stm S { initial i state A { } state B { }
transition t0 { from i to A } transition t1 { from A to B } transition t2 { from B to A } })");
    const Folder folder;
    EXPECT_EQ(run({"conform", file.path(), "--no-cache", "--html", folder / "page.html"}).exit, 1);
    const std::string page = contents(folder / "page.html");
    const std::string claim = between(page, "<section class=\"claim\" id=\"c0\"", "</section>").at(0);
    EXPECT_THAT(claim, HasSubstr("S is not schedulable [RC-K01]"));
    EXPECT_THAT(claim, HasSubstr("then for ever:"));
    EXPECT_THAT(claim, HasSubstr("t1: A -&gt; B"));
    EXPECT_THAT(page, HasSubstr("0 of 1 components conform"));
    EXPECT_THAT(between(page, "<pre tabindex=\"0\">", "</pre>").at(0), HasSubstr("\n")) << "line by line";
}

TEST(Html, LetsNothingInButItsStylesAndItsScript) {
    for (const std::string study : {"aggregation", "swarm_taxis"})
        expect_closed(
            reported({repository("corpus/" + study), repository("corpus/false_claims/" + study + ".assertions")}).page);
}

// FIPS 180-2, appendix B.1: SHA-256 of "abc".
TEST(Html, HashesAreThoseOfTheStandard) {
    EXPECT_EQ(diagnostics::policy_hash("abc"), "sha256-ungWv48Bz+pBQUDeXa4iI7ADYaOWF3qctBD/YfIAFa0=");
}

TEST(Html, NothingOfTheModelActs) {
    const std::string evil = "</script><img src=x onerror=alert(1)>\\\"'";
    const Folder folder({{"<b>x.rct", "package p stm S { event e : string initial i state A { entry send e!\"" + evil +
                                          "\" } transition t0 { from i to A } }"},
                         {"m.assertions",
                          "package q import p::* untimed assertion X : p::S is not deadlock-free\n"
                          "untimed assertion Y : p::S is deadlock-free"}});
    const Both both = reported({folder.path()});
    EXPECT_THAT(both.page, Not(HasSubstr("<img")));
    EXPECT_THAT(both.page, Not(HasSubstr("<b>")));
    EXPECT_EQ(between(both.page, "<script", "</script>").size(), 1U);
    EXPECT_THAT(both.page, HasSubstr("&lt;img"));
}

// A log that the model has, and one that calls turn before forward: it is followed up to there.
TEST(Html, LogsAreSteppedThrough) {
    const Folder folder;
    const auto log = [&](const std::string& name, const std::string& cycle) {
        std::ofstream(folder / name) << "robochart-trace 1\ncomponent w::Robot\ncycle 1\nrun one\n" << cycle << "\n";
        return folder / name;
    };
    const std::string good = log("good.trace", "obstacle? forward! turn!90 tock");
    const std::string bad = log("bad.trace", "turn!90 tock");
    ASSERT_EQ(run({"init", folder / "w"}).exit, 0);
    const Ran ran = run({"conform", folder / "w", "--traces", good, "--traces", bad, "--html", folder / "page.html"});
    EXPECT_EQ(ran.exit, 1) << ran.err;
    const std::string page = contents(folder / "page.html");
    expect_closed(page);
    const auto claims = between(page, "<section class=\"claim\"", "</section>");
    ASSERT_EQ(claims.size(), 2U);
    EXPECT_THAT(claims[0], HasSubstr("call turn(90)"));
    EXPECT_THAT(claims[0], HasSubstr("class=\"holds\""));
    EXPECT_THAT(claims[1], Not(HasSubstr("call turn(90)")));
    EXPECT_THAT(claims[1], HasSubstr("cycle 1 cannot be followed"));
    EXPECT_THAT(page, HasSubstr("run one, cycle 1: turn!90; allowed: forward()"));
}

TEST(Html, ThatCannotBeWrittenIsAnError) {
    const Ran ran = run({"check", repository("corpus/aggregation"), "--untimed", "--html", "/proc/page.html"});
    EXPECT_EQ(ran.exit, 2);
    EXPECT_THAT(ran.err, HasSubstr("/proc/page.html"));
    EXPECT_THAT(ran.out, HasSubstr("checks hold")) << "what was found is printed all the same";
}

class HtmlInABrowser : public InABrowser {};

/// What a page shows of a step: the sentence, and the filled states by machine.
const std::string shown =
    "print [document.querySelector('#ID .status').textContent, Array.from(document.querySelectorAll('#ID "
    "figure')).map((figure) => Array.from(figure.querySelectorAll('.node.on > title')).map((title) => "
    "title.textContent))]\n";

/// The same of the JSON: the active states of each machine, those of one figure by one, as the figures stand.
std::vector<std::vector<std::string>> states_of(const nlohmann::json& machines,
                                                const std::vector<std::string>& components) {
    std::vector<std::vector<std::string>> result(components.size());
    for (const auto& machine : machines) {
        const auto at = std::find(components.begin(), components.end(), machine["component"]) - components.begin();
        for (const std::string element : machine["active"])
            result.at(static_cast<std::size_t>(at)).push_back("state " + element.substr(element.rfind(':') + 1));
    }
    return result;
}

// By keyboard from the beginning to the end of every counterexample, in the light and in the dark: each step fills the
// states that are active in its data, and the browser has nothing to say.
TEST_F(HtmlInABrowser, EachStepFillsTheStatesOfItsData) {
    for (const std::string study : {"aggregation", "swarm_taxis"}) {
        const Folder folder;
        const std::string arguments = repository("corpus/" + study) + " " +
                                      repository("corpus/false_claims/" + study + ".assertions") + " --no-cache";
        const Ran ran = run_shell("\"$verify\" check " + arguments + " --format json");
        const auto report = nlohmann::json::parse(ran.out);
        std::size_t claims = 0;
        for (std::size_t i = 0; i < report["assertions"].size(); ++i) {
            if (!report["assertions"][i].contains("counterexample")) continue;
            const auto& run = report["assertions"][i]["counterexample"];
            const std::string id = "a" + std::to_string(i);
            std::string commands = "open #" + id + "/s/0\n";
            const std::string look = std::regex_replace(shown, std::regex("ID"), id);
            for (std::size_t step = 0; step <= run["steps"].size(); ++step) commands += look + "key ArrowRight\n";
            commands += "key Home\n" + look + "print location.hash\nkey End\nprint location.hash\n";
            const auto lines = played("(\"$verify\" check " + arguments + " --html page.html; true)",
                                      "print Array.from(document.querySelectorAll('#" + id +
                                          " figcaption')).map((each) => each.textContent)\n" + commands,
                                      claims++ == 0 ? "" : "dark");
            ASSERT_EQ(lines.size(), run["steps"].size() + 5) << ::testing::PrintToString(lines);
            const std::vector<std::string> components = nlohmann::json::parse(lines[0]);
            for (std::size_t step = 0; step <= run["steps"].size(); ++step) {
                const auto line = nlohmann::json::parse(lines[step + 1]);
                const auto& machines = step == 0 ? run["initial"] : run["steps"][step - 1]["machines"];
                EXPECT_EQ(line[1].get<std::vector<std::vector<std::string>>>(), states_of(machines, components))
                    << lines[step + 1];
                EXPECT_THAT(line[0].get<std::string>(), ::testing::StartsWith("step " + std::to_string(step) + " of "));
            }
            const std::size_t behind = run["steps"].size() + 2;
            EXPECT_THAT(lines[behind], HasSubstr("step 0 of "));
            EXPECT_EQ(lines[behind + 1], "\"#" + id + "/s/0\"");
            EXPECT_EQ(lines[behind + 2], "\"#" + id + "/s/" + std::to_string(run["steps"].size()) + "\"");
        }
        EXPECT_GT(claims, 0U);
    }
}

}  // namespace
}  // namespace robochart::app::testing
