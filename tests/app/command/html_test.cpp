// SPDX-License-Identifier: Apache-2.0
// Tests `--html`: the page agrees with the JSON, marks existing elements, and runs no code from the model.
#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <string>

#include "base/cache/digest.hpp"
#include "tests/app/command.hpp"
#include "tests/app/command/page.hpp"
#include "tests/contents.hpp"

namespace robochart::app::testing::html_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using tests::read_contents;

struct Both {
    std::string page;
    nlohmann::json json;
};

Both reported(const std::vector<std::string>& models) {
    const Folder folder;
    std::vector<std::string> words{"check", "--format", "json", "--no-cache", "--html", folder / "page.html"};
    words.insert(words.end(), models.begin(), models.end());
    const Ran ran = run(words);
    return {read_contents(folder / "page.html"), nlohmann::json::parse(ran.out)};
}

TEST(Html, HasTheStepsOfEachCounterexample) {
    for (const std::string study : {"aggregation", "swarm_taxis"}) {
        const Both both =
            reported({repository("corpus/" + study), repository("corpus/false_claims/" + study + ".assertions")});
        std::size_t failing = 0;
        const std::vector<std::string> claims = texts_between(both.page, "<section class=\"claim\"", "</section>");
        for (const auto& assertion : both.json["assertions"]) {
            if (!assertion.contains("counterexample")) continue;
            ASSERT_LT(failing, claims.size());
            const std::string& claim = claims[failing++];
            EXPECT_EQ(texts_between(claim, "<tr class=\"step\"", ">").size(),
                      assertion["counterexample"]["steps"].size() + 1);
        }
        EXPECT_GT(failing, 0U);
        EXPECT_EQ(claims.size(), failing);
        EXPECT_EQ(texts_between(both.page, "<td class=\"answer", ">").size(), both.json["assertions"].size());
    }
}

// `data-on` and `data-fired` contain, for example, "0:e5 1:e9". "0:e5" is element e5 of the first figure of the claim.
TEST(Html, MarksElementsOfItsDiagrams) {
    const Both both =
        reported({repository("corpus/aggregation"), repository("corpus/false_claims/aggregation.assertions")});
    std::size_t marks = 0;
    for (const std::string& claim : texts_between(both.page, "<section class=\"claim\"", "</section>"))
        for (const std::string& list : all_matches(claim, "data-(?:on|fired)=\"([^\"]*)\""))
            for (const std::string& mark : all_matches(list, "([0-9]+:e[0-9]+)")) {
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
    const std::string claim = texts_between(both.page, "<section class=\"claim\"", "</section>").at(0);
    const auto id_of = [&](const std::string& name) {
        return all_matches(claim, "data-element=\"(e[0-9]+)\"><title>" + name + "</title>").at(0);
    };
    const auto on = all_matches(claim, "data-on=\"([^\"]*)\"");
    EXPECT_EQ(on.front(), "") << "at the initial junction";
    EXPECT_EQ(on.back(), "0:" + id_of("state B"));
    EXPECT_THAT(claim,
                HasSubstr("data-fired=\"0:" +
                          all_matches(claim, "class=\"edge[^\"]*\" id=\"[^\"]*\" data-element=\"(e[0-9]+)\"").at(1)));
}

// Without scripts, the page shows the diagrams after the last step. There, t1 has led to B.
TEST(Html, ShowsTheEndWithoutScript) {
    const Folder folder(
        {{"m.rct", R"(package p stm S { event e initial i var x : nat state A { } state B { }
transition t0 { from i to A action x = 2 } transition t1 { from A to B trigger e }
transition t2 { from B to B trigger e condition x == 2 } })"},
         {"m.assertions", "package q import p::* untimed assertion X : p::S::B is not reachable in p::S"}});
    const Both both = reported({folder.path()});
    const std::string claim = texts_between(both.page, "<section class=\"claim\"", "</section>").at(0);
    EXPECT_THAT(all_matches(claim, "<g class=\"node on[^\"]*\"[^>]*><title>([^<]*)</title>"),
                ::testing::ElementsAre("state B"));
    EXPECT_THAT(texts_between(claim, "<p class=\"values\">", "</p>"), ::testing::ElementsAre("x = 2"));
    EXPECT_THAT(claim, Not(HasSubstr(">time</th>"))) << "untimed";
    // Only the row in which x is written marks it as changed.
    EXPECT_EQ(all_matches(claim, "data-values=\"([^\"]*&quot;x&quot;,&quot;2&quot;,true[^\"]*)\"").size(), 1U);
}

// The page lists the possible events at the end and the events that the specification allows. The specification forbids
// f, which the machine sends.
TEST(Html, SaysWhatIsAllowedWhereItEnds) {
    const Folder folder({{"m.rct", R"(package p stm S { event e event f initial i state A { } state B { }
transition t0 { from i to A } transition t1 { from A to B trigger e action send f } })"},
                         {"m.assertions",
                          "package q import p::*\nuntimed csp Only csp-begin\nOnly = p::S::e.in -> Only\ncsp-end\n"
                          "untimed assertion X : p::S refines Only in the traces model"}});
    const Both both = reported({folder.path()});
    const std::string claim = texts_between(both.page, "<section class=\"claim\"", "</section>").at(0);
    const std::string end = texts_between(claim, "<summary>where it ends</summary>", "</details>").at(0);
    EXPECT_THAT(end, HasSubstr("<dt>the specification allows</dt><dd>input e</dd>"));
}

// The page describes each diagram as text, for readers who cannot see the picture.
TEST(Html, DiagramsAreThereAsText) {
    const TemporaryFile file("m.rct", R"(package p stm S { event e initial i var x : nat state A { } junction j
transition t0 { from i to A } transition t1 { from A to j trigger e condition x < 1 } transition t2 { from j to A } }
controller C { event f sref a = S connection C on f to a on e })");
    const Both both = reported({file.path()});
    const std::string diagrams = texts_between(both.page, "<section id=\"diagrams\"", "</section>").at(0);
    EXPECT_THAT(diagrams, HasSubstr("<summary>transitions as text</summary>"));
    EXPECT_THAT(diagrams, HasSubstr("<li>initial junction i -&gt; A</li>"));
    EXPECT_THAT(diagrams, HasSubstr("<li>A -&gt; junction j: e[x &lt; 1]</li>"));
    EXPECT_THAT(diagrams, HasSubstr("<summary>connections as text</summary>"));
    EXPECT_THAT(diagrams, HasSubstr("<li>C, f -&gt; ref a = S, e</li>"));
}

// The page draws dashed what no run exercises: B and t1 are never reached, and t2 is taken only in the machine without
// its context.
TEST(Html, WhatNoRunExercisesIsDashed) {
    const TemporaryFile file("m.rct", R"(package p stm S { event e initial i var x : nat state A { } state B { }
transition t0 { from i to A } transition t1 { from A to B trigger e condition x > 1 }
transition t2 { from A to A trigger e } })");
    const Both both = reported({file.path()});
    const std::string diagrams = texts_between(both.page, "<section id=\"diagrams\"", "</section>").at(0);
    EXPECT_THAT(diagrams, HasSubstr("2 elements are dashed"));
    EXPECT_EQ(all_matches(diagrams, "class=\"(node|edge) unexercised\"").size(), 2U);
    EXPECT_THAT(all_matches(diagrams, "<g class=\"node unexercised\"[^>]*><title>([^<]*)</title>"),
                ::testing::ElementsAre("state B"));
}

// Both transitions have no trigger, so the machine can take them indefinitely without time passing.
TEST(Html, AModelThatIsNotSchedulableIsSteppedThrough) {
    const TemporaryFile file("m.rct", R"(package p stm S { initial i state A { } state B { }
transition t0 { from i to A } transition t1 { from A to B } transition t2 { from B to A } })");
    const Folder folder;
    EXPECT_EQ(run({"conform", file.path(), "--no-cache", "--html", folder / "page.html"}).exit, 1);
    const std::string page = read_contents(folder / "page.html");
    const std::string claim = texts_between(page, "<section class=\"claim\" id=\"c0\"", "</section>").at(0);
    EXPECT_THAT(claim, HasSubstr("S is not schedulable [RC-K01]"));
    EXPECT_THAT(claim, HasSubstr("then for ever:"));
    EXPECT_THAT(claim, HasSubstr("t1: A -&gt; B"));
    EXPECT_THAT(page, HasSubstr("0 of 1 components conform"));
    EXPECT_THAT(texts_between(page, "<pre tabindex=\"0\">", "</pre>").at(0), HasSubstr("\n")) << "line by line";
}

/// Returns shell commands that put a wrapper before the compiler. The wrapper changes the generated code with this sed
/// script.
std::string with_changed_code(const std::string& change) {
    return R"sh(mkdir bin; cat > bin/c++ <<'END'
#!/bin/sh
for each in "$@"; do
    case "$each" in *.cpp) sed -i "$CHANGE" "$(dirname "$each")"/*_core.hpp ;; esac
done
PATH="${PATH#*:}" exec c++ "$@"
END
chmod +x bin/c++; export PATH="$PWD/bin:$PATH"; export CHANGE=)sh" +
           ("'" + change + "'\n");
}

// The changed code turns the other way. The model's run ends before that turn, in the state whose action turns.
TEST(Html, CodeThatDiffersIsSteppedThrough) {
    const Ran ran = run_shell(with_changed_code("s/Real(90.0)/Real(-90.0)/") +
                              "\"$verify\" init w > /dev/null\n"
                              "\"$verify\" conform w --no-cache --html page.html > /dev/null\ncat page.html");
    EXPECT_EQ(ran.err, "");
    expect_closed(ran.out);
    const auto claims = texts_between(ran.out, "<section class=\"claim\" id=\"c0\"", "</section>");
    ASSERT_EQ(claims.size(), 1U);
    const std::string& claim = claims.front();
    EXPECT_THAT(claim, HasSubstr("the code writes turn(-90), which the model does not allow here"));
    EXPECT_THAT(claim, HasSubstr("the model: turn(90)"));
    EXPECT_THAT(claim, HasSubstr(">here: the code writes turn(-90)"));
    EXPECT_THAT(claim, HasSubstr("data-text=\"input obstacle (met: Driving -&gt; Turning)\""));
    EXPECT_THAT(claim, HasSubstr("<dt>possible</dt><dd>call turn(90)"));
    EXPECT_THAT(all_matches(claim, "<g class=\"node on[^\"]*\"[^>]*><title>([^<]*)</title>"),
                ::testing::ElementsAre("state Turning"));
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
    EXPECT_EQ(texts_between(both.page, "<script", "</script>").size(), 1U);
    EXPECT_THAT(both.page, HasSubstr("&lt;img"));
}

// The model accepts the first log. The second log calls turn before forward, and the page follows it up to that call.
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
    const std::string page = read_contents(folder / "page.html");
    expect_closed(page);
    const auto claims = texts_between(page, "<section class=\"claim\"", "</section>");
    ASSERT_EQ(claims.size(), 2U);
    EXPECT_THAT(claims[0], HasSubstr("call turn(90)"));
    EXPECT_THAT(claims[0], HasSubstr("class=\"holds\""));
    EXPECT_THAT(claims[1], Not(HasSubstr("call turn(90)")));
    EXPECT_THAT(claims[1], HasSubstr("cycle 1 cannot be followed"));
    EXPECT_THAT(page, HasSubstr("run one, cycle 1: turn!90; allowed: forward()"));
}

TEST(Html, ShowsTheErrorsOfARefusedModel) {
    const std::string bad = "stm S {\n initial i\n state A { entry lost<1> = 1 }\n transition t { from i to B }\n}\n";
    const Folder folder({{"bad.rct", bad}});
    const Ran ran = run({"check", folder / "bad.rct", "--html", folder / "page.html", "--json", folder / "r.json"});
    EXPECT_EQ(ran.exit, 2);
    const std::string page = read_contents(folder / "page.html");
    EXPECT_THAT(page, HasSubstr("refused, with errors"));
    const std::vector<std::string> errors = texts_between(page, "<section id=\"errors\"", "</section>");
    ASSERT_EQ(errors.size(), 1U);
    EXPECT_THAT(errors.front(), HasSubstr("bad.rct:3:"));
    EXPECT_THAT(errors.front(), HasSubstr("lost&lt;1&gt;"));
    EXPECT_GT(nlohmann::json::parse(read_contents(folder / "r.json"))["errors"], 0);
}

// Wrong usage gives no answer about the model, so no page is written.
TEST(Html, IsNotWrittenForWrongUsage) {
    const std::string good = "stm S {\n initial i\n state A {}\n transition t { from i to A }\n}\n";
    const Folder folder({{"good.rct", good}});
    const Ran ran = run({"check", folder / "good.rct", "--html", folder / "page.html", "--const", "lost=1"});
    EXPECT_EQ(ran.exit, 4);
    EXPECT_FALSE(std::ifstream(folder / "page.html").good());
}

TEST(Html, ThatCannotBeWrittenIsAnError) {
    const Ran ran = run({"check", repository("corpus/aggregation"), "--untimed", "--html", "/proc/page.html"});
    EXPECT_EQ(ran.exit, 2);
    EXPECT_THAT(ran.err, HasSubstr("/proc/page.html"));
    EXPECT_THAT(ran.out, HasSubstr("checks hold")) << "what was found is printed all the same";
}

class HtmlInABrowser : public InABrowser {};

/// For each step, the page shows a sentence and the active states of each machine, also in the diagrams of its
/// operations.
const std::string shown =
    "print [document.querySelector('#ID .status').textContent, Array.from(new Set(Array.from(document.querySelectorAll("
    "'#ID figure'), (figure) => figure.dataset.machine)), (machine) => Array.from(document.querySelectorAll("
    "'#ID figure[data-machine=\"' + machine + '\"] .on > title'), (title) => title.textContent.trim().split(' "
    "').at(-1)))]\n";

/// Returns the active states of each machine according to the JSON, in the order of the figures.
std::vector<std::vector<std::string>> states_of(const nlohmann::json& machines,
                                                const std::vector<std::string>& components) {
    std::vector<std::vector<std::string>> result(components.size());
    for (const auto& machine : machines) {
        const auto at = std::ranges::find(components, machine["component"].get<std::string>()) - components.begin();
        for (const std::string element : machine["active"])
            result.at(static_cast<std::size_t>(at)).push_back(element.substr(element.rfind(':') + 1));
    }
    return result;
}

/// The checks of one counterexample in the browser: its figures, each step from the beginning to the end (selected by
/// keyboard), and the steps that Home and End select. `lines` returns how many lines the checks print.
struct Tour {
    std::string id, commands;
    const nlohmann::json* run = nullptr;

    Tour(std::string claim, const nlohmann::json& data) : id(std::move(claim)), run(&data) {
        const std::string look = std::regex_replace(shown, std::regex("ID"), id);
        commands =
            "print Array.from(document.querySelectorAll('#" + id +
            " figcaption'), (each) => each.textContent).filter((text) => !text.includes(': operation '))\nopen #" + id +
            "/s/0\n";
        for (std::size_t step = 0; step <= steps(); ++step) commands += look + "key ArrowRight\n";
        commands += "key Home\n" + look + "print location.hash\nkey End\nprint location.hash\n";
    }
    [[nodiscard]] std::size_t steps() const { return (*run)["steps"].size(); }
    [[nodiscard]] std::size_t lines() const { return steps() + 5; }

    void expect(const std::vector<std::string>& lines, std::size_t at) const {
        const std::vector<std::string> components = nlohmann::json::parse(lines[at]);
        for (std::size_t step = 0; step <= steps(); ++step) {
            const auto line = nlohmann::json::parse(lines[at + step + 1]);
            const auto& machines = step == 0 ? (*run)["initial"] : (*run)["steps"][step - 1]["machines"];
            EXPECT_EQ(line[1].get<std::vector<std::vector<std::string>>>(), states_of(machines, components))
                << lines[at + step + 1];
            EXPECT_THAT(line[0].get<std::string>(), ::testing::StartsWith("step " + std::to_string(step) + " of "));
        }
        const std::size_t behind = at + steps() + 2;
        EXPECT_THAT(lines[behind], HasSubstr("step 0 of "));
        EXPECT_EQ(lines[behind + 1], "\"#" + id + "/s/0\"");
        EXPECT_EQ(lines[behind + 2], "\"#" + id + "/s/" + std::to_string(steps()) + "\"");
    }
};

// Each step highlights the states that are active in its data, in both colour schemes, and the browser reports no
// problem.
TEST_F(HtmlInABrowser, EachStepFillsTheStatesOfItsData) {
    for (const std::string study : {"aggregation", "swarm_taxis"}) {
        const std::string arguments = repository("corpus/" + study) + " " +
                                      repository("corpus/false_claims/" + study + ".assertions") + " --no-cache";
        const auto report = nlohmann::json::parse(run_shell("\"$verify\" check " + arguments + " --format json").out);
        std::vector<Tour> tours;
        std::string commands;
        for (std::size_t i = 0; i < report["assertions"].size(); ++i) {
            if (!report["assertions"][i].contains("counterexample")) continue;
            tours.emplace_back("a" + std::to_string(i), report["assertions"][i]["counterexample"]);
            const bool dark = (tours.size() % 2 == 0) == (study == "aggregation");
            commands += (dark ? "scheme dark\n" : "scheme light\n") + tours.back().commands;
        }
        const auto lines = play_page("(\"$verify\" check " + arguments + " --html page.html; true)", commands);
        std::size_t at = 0;
        for (const Tour& tour : tours) at += tour.lines();
        ASSERT_EQ(lines.size(), at) << ::testing::PrintToString(lines);
        EXPECT_GT(tours.size(), 0U);
        at = 0;
        for (const Tour& tour : tours) {
            tour.expect(lines, at);
            at += tour.lines();
        }
    }
}

// On the way to the forbidden event, the machine is in a state of the operation that it has called.
TEST(Html, OperationsThatAreCalledAreDrawnToo) {
    const Folder folder(
        {{"m.rct",
          R"(package p interface I { op() } operation unused() { initial i state V { } transition u0 { from i to V } }
operation op() { initial i state W { } final F transition u0 { from i to W } transition u1 { from W to F } }
stm S { requires I event e event f initial i state A { } state B { entry op(); send f }
  transition t0 { from i to A } transition t1 { from A to B trigger e } }
controller C { event e event f opref r = op sref a = S connection C on e to a on e connection a on f to C on f })"},
         {"m.assertions",
          "package q import p::*\nuntimed csp Only csp-begin\nOnly = p::C::e.in -> Only\ncsp-end\n"
          "untimed assertion X : p::C refines Only in the traces model"}});
    const Both both = reported({folder.path()});
    const std::string claim = texts_between(both.page, "<section class=\"claim\"", "</section>").at(0);
    EXPECT_EQ(texts_between(claim, "<figcaption>", "</figcaption>"),
              (std::vector<std::string>{"p::C::a", "p::C::a: operation op"}));
    const std::string state = all_matches(claim, "data-element=\"(e[0-9]+)\"><title>state W</title>").at(0);
    EXPECT_THAT(all_matches(claim, "data-on=\"([^\"]*)\""), ::testing::Contains("0:" + state));
}

// A click on a state or transition goes to the next step that marks it. After the last such step it continues with the
// first one.
TEST_F(HtmlInABrowser, AClickOnTheDiagramGoesToItsStep) {
    const std::string where = "print location.hash\n";
    const std::string click =
        "print Array.from(document.querySelectorAll('#a0 svg [data-element] > title')).find((each) "
        "=> each.textContent.startsWith('NAME')).parentNode.dispatchEvent(new MouseEvent('click', "
        "{ bubbles: true })) && ";
    const auto to = [&](const std::string& name) {
        return std::regex_replace(click, std::regex("NAME"), name) + "location.hash\n";
    };
    const auto lines = play_page(
        "cat > m.rct <<'EOT'\npackage p stm S { event e initial i state A { } state B { } state C { }\n"
        "transition t0 { from i to A } transition t1 { from A to B trigger e } }\nEOT\n"
        "cat > m.assertions <<'EOT'\npackage q import p::* untimed assertion X : p::S::B is not reachable in "
        "p::S\nEOT\n"
        "(\"$verify\" check m.rct m.assertions --html page.html; true)",
        "open #a0/s/0\n" + to("transition t1") + to("state A") + to("state B") + to("state C") + where);
    ASSERT_EQ(lines.size(), 5U) << ::testing::PrintToString(lines);
    EXPECT_THAT(lines, ::testing::Each(::testing::StartsWith("\"#a0/s/")));
    const auto step = [&](std::size_t line) { return std::stoi(lines[line].substr(7)); };
    EXPECT_GT(step(0), step(1)) << "t1 fires behind a step in A";
    EXPECT_GE(step(2), step(0));
    EXPECT_EQ(lines[3], lines[2]) << "C is never marked";
}

/// A page with a counterexample of several steps.
const std::string reached_page =
    "cat > m.rct <<'EOT'\npackage p stm S { event e initial i state A { } state B { }\n"
    "transition t0 { from i to A } transition t1 { from A to B trigger e } }\nEOT\n"
    "cat > m.assertions <<'EOT'\npackage q import p::* untimed assertion X : p::S::B is not reachable in p::S\n"
    "untimed assertion A : p::S is deadlock-free\nuntimed assertion M : p::S::A is reachable in p::S\nEOT\n"
    "(\"$verify\" check m.rct m.assertions --html page.html; true)";

// The test replaces the browser's timer. The page has requested a call of `due` after `asked` milliseconds.
TEST_F(HtmlInABrowser, PlaysFromTheBeginningToTheEnd) {
    const std::string look = "print [location.hash, document.querySelector('#a0 .play').textContent]\n";
    const std::string clock =
        "print void (window.setTimeout = (call, ms) => { window.due = call; window.asked = ms; })\n";
    const std::string speed =
        "print void (document.querySelector('#a0 .speed').value = '250')\nclick #a0 .play\nprint asked\n";
    const auto lines =
        play_page(reached_page, "open #a0/s/1\n" + clock + "click #a0 .play\n" + look + "print void due()\n" + look +
                                    "key ArrowLeft\n" + look + "key p\n" + look + "key End\n" + look + speed + look +
                                    "print void due()\nclick #a0 .play\ncalm\nclick #a0 .play\nprint asked\n" + look);
    std::vector<std::string> values;
    for (const std::string& line : lines)
        if (line != "undefined") values.push_back(line);
    ASSERT_EQ(values.size(), 9U) << ::testing::PrintToString(lines);
    EXPECT_EQ(values[0], "[\"#a0/s/1\",\"pause\"]") << "it goes on from where it is";
    EXPECT_EQ(values[1], "[\"#a0/s/2\",\"pause\"]");
    EXPECT_EQ(values[2], "[\"#a0/s/1\",\"play\"]") << "a step chosen by hand ends it";
    EXPECT_EQ(values[3], "[\"#a0/s/1\",\"pause\"]") << "the key p plays";
    EXPECT_THAT(values[4], HasSubstr("\"play\""));
    EXPECT_EQ(values[5], "250");
    EXPECT_EQ(values[6], "[\"#a0/s/0\",\"pause\"]") << "behind the end it begins again";
    EXPECT_EQ(values[7], "3000") << "for readers who prefer less motion";
    EXPECT_EQ(values[8], "[\"#a0/s/1\",\"pause\"]");
}

TEST_F(HtmlInABrowser, CopiesALinkToAStep) {
    const std::string clipboard =
        "print void Object.defineProperty(navigator, 'clipboard', { configurable: true, value: { writeText: BODY } "
        "})\n";
    const auto with = [&](const char* body) { return std::regex_replace(clipboard, std::regex("BODY"), body); };
    const std::string status = "print document.querySelector('#a0 .status').textContent\n";
    const auto lines =
        play_page(reached_page, "open #a0/s/1\n" + with("async (text) => { window.copied = text; }") +
                                    "click #a0 .link\n" + status + "print copied.endsWith('page.html#a0/s/1')\n" +
                                    with("() => Promise.reject(new Error())") + "click #a0 .link\n" + status +
                                    "print document.querySelector('#a0 .address input').value === copied\n");
    EXPECT_THAT(lines, ::testing::ElementsAre("undefined", "\"the link to step 1 is copied\"", "true", "undefined",
                                              "\"the link to step 1, to be copied\"", "true"));
}

// The table is sorted by keyboard: descending, ascending, original order. Without scripts, the table has the original
// order and no buttons.
TEST_F(HtmlInABrowser, SortsTheVerdicts) {
    const std::string claims =
        "print Array.from(document.querySelectorAll('#verdicts tbody tr'), (row) => "
        "row.cells[1].textContent[0]).join('')\n";
    const std::string sorted = "print document.querySelector('#verdicts th:nth-child(2)').getAttribute('aria-sort')\n";
    const auto lines =
        play_page(reached_page,
                  claims + "print void document.querySelector('#verdicts th:nth-child(2) button').focus()\nkey  \n" +
                      claims + sorted + "key  \n" + claims + sorted + "key  \n" + claims + sorted);
    EXPECT_THAT(lines, ::testing::ElementsAre("\"XAM\"", "undefined", "\"AMX\"", "\"ascending\"", "\"XMA\"",
                                              "\"descending\"", "\"XAM\"", "null"));
    EXPECT_THAT(
        play_page(reached_page, claims + "print document.querySelectorAll('#verdicts th button').length\n", "noscript"),
        ::testing::ElementsAre("\"XAM\"", "0"));
}

// Printing uses dark ink on white paper, also for users of the dark scheme. Parts that scroll on the screen are printed
// completely.
TEST_F(HtmlInABrowser, IsPrintedWhole) {
    const std::string style = "print getComputedStyle(document.querySelector('SELECTOR')).PROPERTY\n";
    const auto of = [&](const char* selector, const char* property) {
        return std::regex_replace(std::regex_replace(style, std::regex("SELECTOR"), selector), std::regex("PROPERTY"),
                                  property);
    };
    const auto lines =
        play_page(reached_page, "paper\n" + of("body", "backgroundColor") + of("#a0 .controls", "display") +
                                    of("#a0 .steps", "maxHeight") + of("#a0 svg .box", "fill"));
    EXPECT_THAT(lines,
                ::testing::ElementsAre("\"rgb(255, 255, 255)\"", "\"none\"", "\"none\"", "\"rgb(255, 255, 255)\""));
}

}  // namespace
}  // namespace robochart::app::testing::html_test
