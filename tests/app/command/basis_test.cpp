// SPDX-License-Identifier: Apache-2.0
// Tests that every format shows the assumptions of a verdict next to it, even if the claim holds or the output is
// brief.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>

#include "app/report/report.hpp"
#include "tests/app/command.hpp"
#include "tests/contents.hpp"

namespace robochart::app::basis_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

Report report_of(driver::Answer answer, driver::Basis basis) {
    driver::AssertionReport claim;
    claim.title = "Calm [untimed] Pump is deadlock-free";
    claim.answer = answer;
    claim.searched = true;
    claim.basis = std::move(basis);
    Report report;
    report.model = "pump.rct";
    report.assertions.push_back(std::move(claim));
    return report;
}

driver::Ground guard(const std::string& name, std::uint32_t line) {
    driver::Ground ground{driver::GroundKind::guard,
                          "the condition of `" + name + "` is taken for true",
                          "Pump::" + name,
                          "pump.rct:" + std::to_string(line),
                          runs::Place{"pump.rct", line, 3, line, 9},
                          "write `timed assertion`"};
    return ground;
}

std::string text_of(const Report& report, bool quiet) {
    Options options;
    options.output.quiet = quiet;
    return render_text(report, options);
}

TEST(Basis, StandsWithTheVerdictInEveryFormat) {
    for (const driver::Answer answer : {driver::Answer::holds, driver::Answer::fails, driver::Answer::inconclusive}) {
        const Report report = report_of(answer, {guard("late", 7)});
        const char* const warning = "the condition of `late` is taken for true";
        for (const bool quiet : {false, true})
            EXPECT_THAT(text_of(report, quiet), HasSubstr("rests on: the condition of `late` is taken for true "
                                                          "(pump.rct:7)\n               write `timed assertion`"));
        EXPECT_THAT(render_junit(report), HasSubstr(warning));
        const auto json = nlohmann::json::parse(render_json(report));
        EXPECT_EQ(json["assertions"][0]["basis"], nlohmann::json::parse(R"([{"kind": "guard",
            "text": "the condition of `late` is taken for true", "element": "Pump::late", "place": "pump.rct:7",
            "remedy": "write `timed assertion`"}])"));
        const auto result = nlohmann::json::parse(render_sarif(report))["runs"][0]["results"][0];
        EXPECT_THAT(result["message"]["text"], HasSubstr(warning));
        EXPECT_THAT(result["message"]["text"], HasSubstr("write `timed assertion`"));
        EXPECT_EQ(result["relatedLocations"][0]["physicalLocation"]["region"]["startLine"], 7);
        if (answer == driver::Answer::holds) {
            EXPECT_EQ(result["kind"], "informational");
            EXPECT_EQ(result["level"], "none");
        }
    }
}

TEST(Basis, IsNotMentionedWhereAVerdictRestsOnTheModelAlone) {
    const Report report = report_of(driver::Answer::holds, {});
    EXPECT_THAT(text_of(report, false), Not(HasSubstr("rests on")));
    EXPECT_THAT(text_of(report, true), Not(HasSubstr("Calm")));
    EXPECT_THAT(render_junit(report), Not(HasSubstr("system-out")));
    EXPECT_FALSE(nlohmann::json::parse(render_json(report))["assertions"][0].contains("basis"));
    EXPECT_TRUE(nlohmann::json::parse(render_sarif(report))["runs"][0]["results"].empty());
}

TEST(Basis, LinesNameAFewOfAKindAndEachRemedyOnce) {
    driver::Basis basis;
    for (std::uint32_t line = 1; line <= 5; ++line) add(basis, guard("t" + std::to_string(line), line));
    add(basis, guard("t2", 2));
    EXPECT_EQ(basis.size(), 5U);
    add(basis, {driver::GroundKind::never_asked, "no run does `halt`", {}, {}, {}, {}});
    EXPECT_EQ(basis_lines(basis, 2),
              (std::vector<std::string>{"rests on: the condition of `t1` is taken for true (pump.rct:1)",
                                        "rests on: the condition of `t2` is taken for true (pump.rct:2)",
                                        "and on 3 more of this kind", "write `timed assertion`",
                                        "rests on: no run does `halt`"}));
}

TEST(Basis, TextOfOthersIsEscaped) {
    driver::Ground ground = guard("late", 7);
    ground.text = "<script>\x1b[31m";
    const Report report = report_of(driver::Answer::holds, {ground});
    EXPECT_THAT(render_junit(report), Not(HasSubstr("<script>")));
    EXPECT_THAT(text_of(report, false), Not(HasSubstr("\x1b")));
}

// ---------------------------------------------------------------- what the command finds

using Kinds = std::vector<std::pair<std::string, std::string>>;  // kind and element of each assumption

/// Returns the assumptions of each claim, by its name and time: "Free [untimed]".
std::map<std::string, Kinds> checked(const std::vector<std::pair<std::string, std::string>>& files) {
    const testing::Folder folder(files);
    const auto ran = testing::run({"check", folder.path(), "--format", "json", "--allow", "RC-U01"});
    const auto report = nlohmann::json::parse(ran.out, nullptr, false);
    std::map<std::string, Kinds> result;
    EXPECT_FALSE(report.is_discarded()) << ran.out << ran.err;
    if (report.is_discarded()) return result;
    for (const auto& claim : report["assertions"]) {
        const std::string title = claim["title"];
        const std::string name = title.substr(0, title.find(']') + 1) + ": " + claim["answer"].get<std::string>();
        result[name];
        for (const auto& ground : claim.value("basis", nlohmann::json::array()))
            result[name].emplace_back(ground["kind"], ground.value("element", ""));
    }
    return result;
}

const char* const pump = R"(
package pump
stm Pump {
	const most : nat = 1
	var fills : nat = 0
	event go
	event full
	event late
	clock T
	initial i
	state Idle { }
	state Filling { }
	state Failed { }
	transition t0 { from i to Idle }
	transition t1 { from Idle to Filling trigger go #T }
	transition t2 { from Filling to Failed condition since(T) >= 3 }
	transition t3 { from Filling to Idle trigger full condition since(T) < 9 /\ fills < most action fills = fills + 1 }
	transition t4 { from Failed to Idle trigger late }
}
)";

const char* const about_pump = R"(
package claims
import pump::*
untimed csp Once csp-begin
	Once = pump::Pump::full.in -> Rest [] pump::Pump::go.in -> Once [] pump::Pump::late.in -> Once
	Rest = pump::Pump::go.in -> Rest [] pump::Pump::late.in -> Rest
csp-end
untimed assertion Never : pump::Pump::Failed is not reachable in pump::Pump
untimed assertion Does : pump::Pump::Failed is reachable in pump::Pump
untimed assertion Free : pump::Pump is deadlock-free
untimed assertion FullOnce : pump::Pump refines Once in the traces model
timed assertion InTime : pump::Pump is deadlock-free
)";

// `FullOnce` holds without an assumption: the untimed semantics evaluates the guard `fills < most`, and time can only
// remove traces.
TEST(GuardBasis, NamesTheGuardsOfTheRun) {
    const auto found = checked({{"pump.rct", pump}, {"pump.assertions", about_pump}});
    const Kinds late{{"guard", "pump::Pump::t2"}};
    const std::map<std::string, Kinds> expected{
        {"Never [untimed]: fails", late},
        {"Does [untimed]: holds", late},
        {"Free [untimed]: holds", {{"guard", "pump::Pump::t2"}, {"guard", "pump::Pump::t3"}}},
        {"FullOnce [untimed]: holds", {}},
        {"InTime [timed]: holds", {}}};
    EXPECT_EQ(found, expected);
}

TEST(GuardBasis, IsInEveryFormatWhateverIsAllowed) {
    const testing::Folder folder({{"pump.rct", pump}, {"pump.assertions", about_pump}});
    const std::string part = "`since(T) < 9`";
    for (const char* const format : {"text", "json", "sarif", "junit"}) {
        const auto ran = testing::run({"check", folder.path(), "-q", "--format", format, "--allow", "RC-U01"});
        EXPECT_THAT(ran.out, HasSubstr(std::string_view(format) == "junit" ? "`since(T) &lt; 9`" : part)) << format;
    }
    const std::string page = folder.path() + "/page.html";
    (void)testing::run({"check", folder.path(), "-q", "--html", page, "--allow", "RC-U01"});
    EXPECT_THAT(tests::read_contents(page), HasSubstr("`since(T) &lt; 9`"));
}

TEST(TimeBasis, ASpecificationWithoutTimeIsNamed) {
    const std::string echo =
        "package echo\nstm Echo {\n event a\n initial i\n state S { }\n"
        "transition t0 { from i to S }\n transition t1 { from S to S trigger a }\n}\n";
    const auto claims = [](const std::string& spec) {
        return "package claims\nimport echo::*\ncsp Spec csp-begin\nSpec = " + spec +
               "\ncsp-end\nassertion A : echo::Echo refines Spec in the traces model\n";
    };
    const auto without = checked({{"r.rct", echo}, {"r.assertions", claims("echo::Echo::a.in -> Spec")}});
    EXPECT_EQ(without,
              (std::map<std::string, Kinds>{{"A [untimed]: holds", {}}, {"A [timed]: fails", {{"noTime", ""}}}}));
    // The specification that the note on the verdict suggests.
    const std::string open = "Once ||| RUN({tock})\nOnce = echo::Echo::a.in -> Once";
    const auto with =
        checked({{"r.rct", echo},
                 {"r.assertions", "package claims\nimport echo::*\ntimed csp Spec csp-begin\nSpec = " + open +
                                      "\ncsp-end\ntimed assertion A : echo::Echo refines Spec in the traces model\n"}});
    EXPECT_EQ(with, (std::map<std::string, Kinds>{{"A [timed]: holds", {}}}));
    // The specification forbids time only after the first event. In the initial state, time passes.
    const auto once = checked({{"r.rct", echo},
                               {"r.assertions",
                                "package claims\nimport echo::*\ntimed csp Spec csp-begin\n"
                                "Spec = echo::Echo::a.in -> STOP [] tock -> Spec\ncsp-end\n"
                                "timed assertion A : echo::Echo refines Spec in the traces model\n"}});
    EXPECT_EQ(once, (std::map<std::string, Kinds>{{"A [timed]: fails", {}}}));
}

// The deadline of B cannot be met. The claim "`b` comes in time" is true because time cannot pass.
TEST(TimeBasis, TimeThatStopsAndAnEndAreNamed) {
    const char* const model = R"(
package late
stm Late {
	event a
	event b
	initial i
	state A { }
	state B { entry (wait(3); b) <{ 1 } }
	transition t0 { from i to A }
	transition t1 { from A to B trigger a }
}
stm Ends {
	event a
	initial i
	state A { }
	final f
	transition t0 { from i to A }
	transition t1 { from A to f trigger a }
}
)";
    const char* const claims = R"(
package claims
import late::*
timed csp Soon csp-begin
	Soon = late::Late::a.in -> Due(1) [] tock -> Soon
	Due(n) = late::Late::b.out -> Soon [] (if n == 0 then STOP else tock -> Due(n - 1))
csp-end
timed csp Stops csp-begin
	Stops = late::Late::a.in -> Then(1) [] tock -> Stops
	Then(n) = if n == 0 then STOP else tock -> Then(n - 1)
csp-end
timed assertion InTime : late::Late refines Soon in the traces model
timed assertion Stopped : late::Late refines Stops
timed assertion Free : late::Ends is deadlock-free
timed assertion Taken : event a is not missed in late::Late::A
)";
    const auto found = checked({{"late.rct", model}, {"late.assertions", claims}});
    EXPECT_EQ(found, (std::map<std::string, Kinds>{{"InTime [timed]: holds", {{"timeStops", ""}, {"neverAsked", ""}}},
                                                   {"Stopped [timed]: holds", {{"timeStops", ""}}},
                                                   {"Free [timed]: holds", {{"ended", ""}}},
                                                   {"Taken [timed]: holds", {{"timeStops", ""}}}}));
}

// `open` never occurs, so the rule Never requires nothing. Time stops before the deadline of the rule Soon, so Soon is
// not violated.
TEST(RuleBasis, TimeThatStopsAndRulesThatAskForNothingAreNamed) {
    const auto found = checked(
        {{"late.rct",
          "stm Late {\n event ring\n event open\n initial i\n state A { }\n state B { entry (wait(3); open) <{ 1 } }\n"
          " transition t0 { from i to A }\n transition t1 { from A to B trigger ring }\n}\n"},
         {"late.sleec",
          "def_start event ring event open def_end rule_start\nSoon when ring then open within 5 seconds\n"
          "Never when open then not ring within 2 seconds\nrule_end\n"},
         {"late.assertions",
          "sleec assertion A : Late conforms to Soon\nsleec assertion N : Late conforms to Never\n"}});
    EXPECT_EQ(found, (std::map<std::string, Kinds>{{"A [timed]: holds", {{"timeStops", ""}}},
                                                   {"N [timed]: holds", {{"neverAsked", ""}, {"timeStops", ""}}}}));
}

TEST(RestBasis, WhatNeverComesToRestIsNamedInTheFailuresModel) {
    const char* const model = R"(
package busy
stm Busy {
	event a
	event stop
	initial i
	state S { }
	transition t0 { from i to S }
	transition t1 { from S to S trigger a }
}
)";
    const std::string text = R"(
package claims
import busy::*
untimed csp Alone csp-begin
	Alone = busy::Busy::O__(0) \ {| busy::Busy::a |}
csp-end
untimed csp Quiet csp-begin
	Quiet = busy::Busy::stop.in -> Quiet
csp-end
untimed assertion Hidden : Alone refines Quiet in the failures model
untimed assertion Traces : Alone refines Quiet in the traces model
)";
    const auto found = checked({{"busy.rct", model}, {"busy.assertions", text}});
    EXPECT_EQ(found,
              (std::map<std::string, Kinds>{{"Hidden [untimed]: holds", {{"neverAtRest", ""}, {"neverAsked", ""}}},
                                            {"Traces [untimed]: holds", {{"neverAsked", ""}}}}));
}

TEST(AskedBasis, AStateThatIsNeverEnteredMissesNothing) {
    const char* const model = R"(
package shut
stm Shut {
	event a
	initial i
	state A { }
	state B { }
	transition t0 { from i to A }
	transition t1 { from A to B trigger a condition false }
	transition t2 { from B to A trigger a }
}
)";
    const char* const claims =
        "package claims\nimport shut::*\ntimed assertion M : event a is not missed in shut::Shut::B\n";
    const auto found = checked({{"shut.rct", model}, {"shut.assertions", claims}});
    EXPECT_EQ(found, (std::map<std::string, Kinds>{{"M [timed]: holds", {{"neverAsked", ""}}}}));
}

}  // namespace
}  // namespace robochart::app::basis_test
