// SPDX-License-Identifier: Apache-2.0
// Tests the verb `rules`, with and without a model: answers, exit codes, formats, bad input.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "tests/app/command.hpp"
#include "tests/contents.hpp"
#include "tests/shared_folder.hpp"

namespace robochart::app::testing::rules_test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

const std::string head =
    "def_start\nevent Go event Halt event Stop\nmeasure near : boolean measure level : numeric\ndef_end\nrule_start\n";

Ran ask(const std::string& rules, const std::vector<std::string>& options = {}) {
    std::vector<std::string> arguments{"rules", "-"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run(arguments, head + rules + "\nrule_end\n");
}

TEST(Rules, ExitCodesFollowTheAnswers) {
    EXPECT_EQ(ask("A when Go then Stop within 5 seconds").exit, 0);
    EXPECT_EQ(ask("A when Go then Stop\nB when Go then Stop").exit, 0) << "redundancy is no failure";
    EXPECT_EQ(ask("A when Go then Stop within 5 seconds\nB when Halt then not Stop within 9 seconds").exit, 1);
    EXPECT_EQ(ask("A when Go then").exit, 2);
    EXPECT_EQ(ask("A when Gone then Stop").exit, 2);
    EXPECT_EQ(ask("A when Go and ({level} + 1 > 2) then Stop").exit, 3);
    EXPECT_EQ(run({"rules", "missing.sleec"}).exit, 2);
    EXPECT_THAT(run({"rules", "missing.sleec"}).err, HasSubstr("error[SLEEC-P07]"));
    EXPECT_EQ(run({"rules"}).exit, 4);
    EXPECT_EQ(ask("A when Go then Stop", {"--without-limit", "later"}).exit, 4);
    EXPECT_EQ(ask("A when Go then Stop", {"--without-limit", "now", "--as-sleec-tk"}).exit, 4);
    EXPECT_EQ(ask("A when Go and near or near and near then Stop", {"--deny-warnings"}).exit, 2);
    EXPECT_EQ(ask("A when Go and near or near and near then Stop", {"--deny-warnings", "--allow", "SLEEC-P10"}).exit,
              0);
    EXPECT_EQ(
        ask("A when Go then Stop within 50 seconds\nB when Halt then not Stop within 90 seconds", {"--max-states", "9"})
            .exit,
        3);
}

/// Stop is due 5 seconds after Go and forbidden for 9 seconds after Halt. The conflict arises if both start at the same
/// time.
TEST(Rules, TellTheSituation) {
    const Ran ran = ask("A when Go and near then Stop within 5 seconds\nB when Halt then not Stop within 9 seconds");
    EXPECT_THAT(ran.out, HasSubstr("conflict: A and B\n"));
    EXPECT_THAT(ran.out, HasSubstr("with Go, near: it asks for Stop up to second"));
    EXPECT_THAT(ran.out, HasSubstr("with Halt: it forbids Stop up to second"));
    EXPECT_THAT(ran.out, HasSubstr("Stop has to come, and may not\n"));
    EXPECT_LE(std::ranges::count(ran.out, '\n'), 8 + 1);
}

TEST(Rules, AnswerAsJson) {
    const Ran ran =
        ask("A when Go then Stop within 5 seconds\nB when Halt then not Stop within 9 seconds\n"
            "C when Go then Stop",
            {"--format", "json"});
    const json found = json::parse(ran.out);
    EXPECT_EQ(found["schema"], "robochart-verify/rules/1");
    ASSERT_EQ(found["conflicts"].size(), 1U);
    EXPECT_EQ(found["conflicts"][0]["rules"], json({"A", "B"}));
    EXPECT_EQ(found["redundant"][0]["rule"], "C");
    const json wrong = json::parse(ask("A when", {"--format", "json"}).out);
    EXPECT_FALSE(wrong["errors"].empty());
}

/// As in SLEEC-TK, an active rule refuses its trigger. This makes D miss its deadline.
TEST(Rules, CompareAsSleecTk) {
    const std::string rules =
        "C when Halt and not near then not Stop within 60 seconds\nD when Go then Halt within 3 seconds";
    EXPECT_EQ(ask(rules).exit, 0);
    const Ran ran = ask(rules, {"--as-sleec-tk"});
    EXPECT_EQ(ran.exit, 1);
    EXPECT_THAT(ran.out, HasSubstr("conflict: C and D: a deadline is missed\n"));
    EXPECT_EQ(ask("A when Go then Stop unless Halt", {"--as-sleec-tk"}).exit, 3) << "SLEEC-TK does not read it";
}

TEST(Rules, AreInterruptedWithWhatIsKnown) {
    std::string many = "A when Go then Stop within 9000 days otherwise Halt within 9000 days\n";
    many += "B when Halt then not Stop within 9000 days otherwise not Halt within 9000 days";
    const Ran ran = ask(many, {"--timeout", "1"});
    EXPECT_EQ(ran.exit, 3);
    EXPECT_THAT(ran.out, HasSubstr("not decided"));
}

// ---------------------------------------------------------------- with a model

constexpr const char* bell =
    "stm Bell { event Ring event OpenDoor event Alarm event dark : boolean var d : boolean initial i0 state Idle { }\n"
    "state Opening { entry wait ( 2 ) ; OpenDoor <{ 0 } }\n"
    "transition t0 { from i0 to Idle } transition t1 { from Idle to Opening trigger Ring }\n"
    "transition t2 { from Opening to Idle } transition t3 { from Idle to Idle trigger dark ? d } }\n";

Ran obey(const std::string& rules, const std::vector<std::string>& options = {}) {
    const Folder folder({{"bell.rct", bell},
                         {"bell.sleec",
                          "def_start event Ring event OpenDoor event Sleep event Alarm event Open\n"
                          "measure dark : boolean measure level : numeric measure other : numeric map Open to "
                          "Bell::OpenDoor def_end rule_start\n" +
                              rules + "\nrule_end\n"}});
    std::vector<std::string> arguments{"rules", folder / "bell.sleec", folder / "bell.rct"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run(arguments);
}

TEST(RulesOfModels, AreObeyedOrBroken) {
    EXPECT_THAT(obey("R when Ring then OpenDoor within 2 seconds").out, HasSubstr("R by Bell: obeyed\n"));
    EXPECT_EQ(obey("R when Ring then OpenDoor within 2 seconds").exit, 0);
    EXPECT_EQ(obey("R when Ring then Open within 2 seconds").exit, 0) << "mapped";
    const Ran late = obey("R when Ring then OpenDoor within 1 seconds");
    EXPECT_EQ(late.exit, 1);
    EXPECT_THAT(late.out, HasSubstr("R by Bell: broken\n"));
    EXPECT_THAT(late.out, HasSubstr("with Ring: it asks for OpenDoor up to second"));
    EXPECT_EQ(obey("R when Ring and dark then not OpenDoor within 1 seconds").exit, 0);
    const Ran forbidden = obey("R when Ring and dark then not OpenDoor within 2 seconds");
    EXPECT_EQ(forbidden.exit, 1);
    EXPECT_THAT(forbidden.out, HasSubstr("OpenDoor comes at second"));
    EXPECT_THAT(forbidden.out, HasSubstr("bell.rct:1"));
}

TEST(RulesOfModels, AreNotPassedInSilence) {
    EXPECT_THAT(obey("R when Alarm then OpenDoor within 1 seconds").out, HasSubstr("R by Bell: never asked"));
    const Ran missing = obey("R when Sleep then OpenDoor within 1 seconds");
    EXPECT_THAT(missing.out, HasSubstr("R by Bell: not applicable: Bell has no event and no operation 'Sleep'"));
    const Ran open = obey("R when Ring and {level} > {other} then OpenDoor within 1 seconds");
    EXPECT_EQ(open.exit, 3);
    EXPECT_THAT(open.out, HasSubstr("R by Bell: not decided"));
    EXPECT_EQ(obey("R when Ring then OpenDoor", {"--as-sleec-tk"}).exit, 4);
    EXPECT_EQ(
        json::parse(
            obey("R when Ring then OpenDoor within 2 seconds", {"--format", "json"}).out)["verdicts"][0]["verdict"],
        "obeyed");
}

/// The output for programs is JSON even if the model is refused.
TEST(RulesOfModels, ProgramsLearnOfRefusals) {
    const Folder folder({{"wrong.rct",
                          "stm Bell { event Ring initial i0 state Idle { }\n"
                          "transition t0 { from i0 to Idle }\n"
                          "transition t1 { from Idle to Idle trigger Rung } }\n"},
                         {"bell.sleec",
                          "def_start event Ring event OpenDoor def_end rule_start\n"
                          "R when Ring then OpenDoor within 2 seconds rule_end\n"}});
    const Ran wrong =
        run({"rules", folder / "bell.sleec", folder / "wrong.rct", "--format", "json", "--json", folder / "copy.json"});
    EXPECT_EQ(wrong.exit, 2);
    const json answer = json::parse(wrong.out, nullptr, false);
    ASSERT_FALSE(answer.is_discarded()) << wrong.out;
    ASSERT_EQ(answer["errors"].size(), 1);
    EXPECT_THAT(answer["errors"][0].get<std::string>(), HasSubstr("wrong.rct:3:"));
    EXPECT_THAT(answer["errors"][0].get<std::string>(), HasSubstr("Rung"));
    EXPECT_EQ(json::parse(tests::read_contents(folder / "copy.json"), nullptr, false), answer);

    const Ran unknown =
        obey("R when Ring then OpenDoor within 2 seconds", {"--component", "Bells", "--format", "json"});
    EXPECT_EQ(unknown.exit, 4);
    EXPECT_THAT(unknown.out, HasSubstr("--component Bells"));
}

/// OpenDoor comes two seconds after Ring. The model never makes Alarm.
TEST(RulesOfModels, WithoutLimit) {
    EXPECT_EQ(obey("R when Ring then OpenDoor").exit, 0);
    const Ran waits = obey("R when Ring then Alarm");
    EXPECT_EQ(waits.exit, 1);
    EXPECT_THAT(waits.out, HasSubstr("it asks for Alarm, without limit"));
    EXPECT_THAT(waits.out, HasSubstr("time can pass for ever without it"));
}

/// The verdicts are those of SLEEC-TK (shared/suite/sleec, conformance.tsv), with the instantiations of the published
/// assertions. "conforms" includes rules that are never triggered.
TEST(RulesOfModels, AsRecorded) {
    if (tests::shared_folder().empty()) GTEST_SKIP() << "no shared/suite/sleec";
    const auto suite = tests::shared_folder() / "suite/sleec";
    const auto verdicts = [&](const std::string& project, const std::vector<std::string>& files,
                              const std::string& rules) {
        std::vector<std::pair<std::string, std::string>> copied{{rules, tests::read_contents(suite / project / rules)}};
        for (const std::string& file : files) copied.emplace_back(file, tests::read_contents(suite / project / file));
        const Folder folder(copied);
        const Ran ran = run({"rules", folder / rules, folder / "main.rct", "--format", "json"});
        std::map<std::string, std::string> result;
        const json found = json::parse(ran.out, nullptr, false);
        if (found.is_discarded()) return std::map<std::string, std::string>{{"", ran.err}};
        for (const auto& entry : found["verdicts"]) {
            std::string verdict = entry["verdict"];
            if (verdict == "never asked" || verdict == "obeyed") verdict = "conforms";
            if (verdict == "broken") verdict = "fails";
            result[entry["rule"]] = verdict;
        }
        return result;
    };
    const std::vector<std::string> uav{"main.rct", "jss_running_example-conformance.assertions"};
    auto jss = verdicts("FireFighter/robochart", uav, "jss_running_example.sleec");
    EXPECT_EQ(jss["Rule1"], "conforms") << jss[""];
    EXPECT_EQ(jss["Rule2"], "conforms");
    EXPECT_EQ(jss["Rule3"], "fails");
    EXPECT_EQ(jss["Rule4"], "conforms");
    auto valid = verdicts("FireFighter/robochart", uav, "firefighter-valid.sleec");
    EXPECT_EQ(valid["FRule1"], "conforms") << valid[""];
    EXPECT_EQ(valid["FRule6"], "fails");
    auto almi = verdicts("ALMI-project", {"main.rct", "system.rct", "verification.assertions"}, "ALMI-demo.sleec");
    EXPECT_EQ(almi["Rule1"], "conforms") << almi[""];
    EXPECT_EQ(almi["Rule2"], "conforms");
    EXPECT_EQ(almi["Rule3"], "not applicable");
    EXPECT_EQ(almi["Rule4"], "fails");
}

/// One duty, written as a rule and as a claim.
struct SameDuty {
    const char* rule;
    const char* claim;
    const char* verdict;  ///< for the rule; if it is "broken", the claim fails, otherwise it holds
};

struct SameModel {
    const char* folder;
    std::vector<std::string> files;
    const char* component;  ///< "" if the claims have only one
    std::vector<const char*> events;
    std::vector<SameDuty> duties;
};

/// Returns models with the verdicts of shared/suite/claims, EXPECTED.md, and of shared/suite/sleec, conformance.tsv.
/// Verdicts about values and states follow from the transitions of the models.
const std::vector<SameModel>& same_models() {
    static const std::vector<SameModel> models{
        {"claims/warehouse",
         {"warehouse.rct"},
         "",
         {"estop", "brake", "obstacle", "halt", "reverse", "dock", "batteryLow", "goTo"},
         {{"when estop then brake within 0 seconds", "estop leads to brake within 0 units", "obeyed"},
          {"when obstacle then not reverse within 30 seconds", "for 30 units after obstacle, never reverse", "broken"},
          {"when obstacle then not reverse within 29 seconds", "for 29 units after obstacle, never reverse", "obeyed"},
          {"reverse at least 30 seconds after obstacle", "reverse at least 30 units after obstacle", "obeyed"},
          {"reverse at least 31 seconds after obstacle", "reverse at least 31 units after obstacle", "broken"},
          {"when obstacle then reverse", "obstacle leads to reverse", "broken"},
          {"when obstacle then halt", "obstacle leads to halt", "obeyed"},
          {"when goTo(1) then not goTo(3) within 0 seconds", "for 0 units after goTo(1), never goTo(3)", "broken"},
          {"when goTo then not goTo(4) within 9 seconds", "for 9 units after goTo, never goTo(4)", "obeyed"},
          {"when goTo(1) then goTo(2) within 0 seconds", "goTo(1) leads to goTo(2) within 0 units", "broken"},
          {"when batteryLow then goTo(_) within 5 seconds", "batteryLow leads to goTo within 5 units", "broken"},
          {"when batteryLow and in Emergency then brake within 0 seconds",
           "while in Emergency, batteryLow leads to brake within 0 units", "obeyed"},
          {"when batteryLow then brake within 0 seconds unless in Operating",
           "while not in Operating, batteryLow leads to brake within 0 units", "obeyed"},
          {"when batteryLow then brake within 0 seconds unless in Operating::Patrolling::Held",
           "while not in Operating::Patrolling::Held, batteryLow leads to brake within 0 units", "broken"},
          {"when obstacle and in Operating::Patrolling::Held then not halt within 9 seconds",
           "while in Operating::Patrolling::Held, never obstacle", "never asked"}}},
        {"claims/rover",
         {"robot.rct", "wander.rct"},
         "",
         {"forward", "stop", "halt", "turn"},
         {{"when stop then halt within 1 seconds", "stop leads to halt within 1 units", "obeyed"},
          {"forward at least 4 seconds after turn", "forward at least 4 units after turn", "broken"},
          {"when turn(_) then not forward within 3 seconds unless halt",
           "forward at least 4 units after turn unless halt", "obeyed"}}},
        {"claims/ends",
         {"ends.rct"},
         "ends::Ends",
         {"estop", "brake"},
         {{"when estop then not brake within 5 seconds", "for 5 units after estop, never brake", "obeyed"},
          {"when estop then brake within 1 seconds", "estop leads to brake within 1 units", "broken"}}},
        {"sleec/FireFighter/robochart",
         {"main.rct", "jss_running_example-conformance.assertions"},
         "",
         {"CameraStart", "SoundAlarm", "GoHome"},
         {{"when SoundAlarm then not GoHome within 300 seconds", "for 300 units after SoundAlarm, never GoHome",
           "broken"},
          {"when CameraStart then SoundAlarm within 2 seconds", "CameraStart leads to SoundAlarm within 2 units",
           "broken"}}},
        {"sleec/ALMI-project",
         {"main.rct", "system.rct", "verification.assertions"},
         "",
         {"StartLunchTime", "InformUser", "DetectUserFallen", "CallSupport"},
         {{"when StartLunchTime then InformUser within 5 seconds", "StartLunchTime leads to InformUser within 5 units",
           "never asked"},
          {"when DetectUserFallen then not CallSupport within 180 seconds",
           "for 180 units after DetectUserFallen, never CallSupport", "broken"}}}};
    return models;
}

TEST(RulesOfModels, SayWhatTheSameClaimsSay) {
    if (tests::shared_folder().empty()) GTEST_SKIP() << "no shared/suite";
    for (const SameModel& model : same_models()) {
        std::string rules = "def_start", claims;
        for (const char* event : model.events) rules += std::string(" event ") + event;
        rules += " def_end rule_start\n";
        std::vector<std::string> check{"check", "", "-q"};
        for (std::size_t i = 0; i < model.duties.size(); ++i) {
            const std::string name = "D" + std::to_string(i);
            const std::string of = *model.component == '\0' ? "" : std::string(" of ") + model.component;
            rules += name + " " + model.duties[i].rule + "\n";
            claims += "claim " + name + of + " : " + model.duties[i].claim + "\n";
            check.insert(check.end(), {"--assertion", name});
        }
        std::vector<std::pair<std::string, std::string>> copied{{"d.sleec", rules + "rule_end\n"},
                                                                {"d.claims", claims}};
        for (const std::string& file : model.files)
            copied.emplace_back(file, tests::read_contents(tests::shared_folder() / "suite" / model.folder / file));
        const Folder folder(copied);
        check[1] = folder / ".";
        const Ran decided = run(check);
        const Ran obeyed = run({"rules", folder / "d.sleec", folder / ".", "--format", "json"});
        const json found = json::parse(obeyed.out, nullptr, false);
        ASSERT_FALSE(found.is_discarded()) << model.folder << obeyed.err;
        for (std::size_t i = 0; i < model.duties.size(); ++i) {
            SCOPED_TRACE(std::string(model.folder) + ": " + model.duties[i].rule);
            const std::string name = "D" + std::to_string(i), verdict = model.duties[i].verdict;
            const bool fails = decided.out.find("  FAILS        " + name + " [") != std::string::npos;
            EXPECT_EQ(fails, verdict == "broken") << decided.out << decided.err;
            const auto entry = std::ranges::find_if(found["verdicts"], [&](const json& one) {
                return one["rule"] == name && (*model.component == '\0' || one["component"] == model.component);
            });
            ASSERT_NE(entry, found["verdicts"].end());
            EXPECT_EQ((*entry)["verdict"], verdict);
        }
        EXPECT_LE(decided.exit, 1) << decided.err;
    }
}

TEST(RulesOfModels, ThatNameWhatTheModelLacksAreNotApplicable) {
    const auto answer_to = [](const std::string& rule) {
        const Folder folder(
            {{"m.rct",
              "stm M { event go : nat event halt initial i state A { } state B { entry halt <{ 0 } }\n"
              "transition t { from i to A } transition u { from A to B trigger go ? x }\n"
              "var x : nat }\n"},
             {"m.sleec", "def_start event go event halt def_end rule_start\nR " + rule + "\nrule_end\n"}});
        return run({"rules", folder / "m.sleec", folder / "m.rct"}).out;
    };
    EXPECT_THAT(answer_to("when go(1) and in A then halt within 0 seconds"), HasSubstr("R by M: obeyed"));
    EXPECT_THAT(answer_to("when go and in B then halt within 0 seconds"), HasSubstr("R by M: never asked"));
    EXPECT_THAT(answer_to("when go(99) then halt"),
                HasSubstr("R by M: not applicable: no value of the instantiation is meant by go(99)"));
    EXPECT_THAT(answer_to("when go(true) then halt"),
                HasSubstr("R by M: not applicable: 'go' of M carries values of the type nat, not `"));
    EXPECT_THAT(answer_to("when go(1, 2) then halt"), HasSubstr("write `go` without arguments"));
    EXPECT_THAT(answer_to("when go and in Aa then halt"), HasSubstr("no state `Aa` of M; did you mean `A`?"));
}

// ---------------------------------------------------------------- as assertions

const std::string bell_rules =
    "def_start event Ring event OpenDoor event Sleep def_end rule_start\n"
    "Open when Ring then OpenDoor within 3 seconds\nQuick when Ring then OpenDoor within 1 seconds\n"
    "Rest when Sleep then not Ring within 9 seconds\nrule_end\n";

Ran claim(const std::string& assertions, const std::vector<std::string>& options = {}) {
    const Folder folder({{"bell.rct", bell}, {"bell.sleec", bell_rules}, {"bell.assertions", assertions}});
    std::vector<std::string> arguments{"check", folder / "bell.rct"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run(arguments);
}

TEST(RuleAssertions, AreCheckedWithTheOthers) {
    EXPECT_EQ(claim("sleec assertion A : Bell conforms to Open").exit, 0);
    EXPECT_EQ(claim("timed sleec assertion A : Bell conforms to Open.").exit, 0);
    EXPECT_EQ(claim("sleec assertion A : Bell does not conform to Quick").exit, 0);
    EXPECT_EQ(claim("sleec assertion A : Bell does not conform to Open").exit, 1);
    const Ran broken = claim("sleec assertion A : Bell conforms to Quick\nassertion B : Bell is divergence-free");
    EXPECT_EQ(broken.exit, 1);
    EXPECT_THAT(broken.out, HasSubstr("Quick begins at second 0 with Ring: it asks for OpenDoor up to second 1"));
    EXPECT_THAT(broken.out, HasSubstr("input Ring"));
    EXPECT_EQ(claim("sleec assertion A : Bell conforms to Quick\nsleec assertion B : Bell conforms to Open",
                    {"--assertion", "B"})
                  .exit,
              0);
    EXPECT_EQ(claim("sleec assertion A : Bell conforms to Quick", {"--format", "json"}).exit, 1);
}

TEST(RuleAssertions, ThatCannotBeAskedAreErrors) {
    const Ran unknown = claim("sleec assertion A : Bell conforms to Quik");
    EXPECT_EQ(unknown.exit, 2);
    EXPECT_THAT(unknown.out + unknown.err, HasSubstr("did you mean `Quick`?"));
    const Ran missing = claim("sleec assertion A : Bell conforms to Rest");
    EXPECT_EQ(missing.exit, 2);
    EXPECT_THAT(missing.out + missing.err, HasSubstr("Bell has no event and no operation 'Sleep'"));
    EXPECT_EQ(claim("assertion B : Bell is divergence-free\nsleec assertion A : Bel conforms to Quick").exit, 2);
    EXPECT_EQ(claim("untimed sleec assertion A : Bell conforms to Quick").exit, 2);
    EXPECT_EQ(claim("sleec assertion A : Bell conforms Quick").exit, 2);
}

// ---------------------------------------------------------------- logs

Ran logged(const std::string& log, const std::string& rules) {
    const Folder folder({{"a.trace", log},
                         {"a.sleec",
                          "def_start event Ring event OpenDoor measure dark : boolean measure level : numeric\n"
                          "map OpenDoor to Bell::open def_end rule_start\n" +
                              rules + "\nrule_end\n"}});
    return run({"conform", folder / "a.sleec", "--traces", folder / "a.trace"});
}

TEST(RulesOfLogs, AreObeyedOrBroken) {
    const std::string log_head = "robochart-trace 1\ncomponent Bell\nrun a\n";
    const std::string rule = "R when Ring then OpenDoor within 1 seconds";
    EXPECT_EQ(logged(log_head + "Ring? tock\nopen! tock\ntock\n", rule).exit, 0);
    const Ran late = logged(log_head + "Ring? tock\ntock\nopen! tock\n", rule);
    EXPECT_EQ(late.exit, 1);
    EXPECT_THAT(late.out, HasSubstr("a.trace:5: run a\n  R begins at second 0 with Ring"));
    EXPECT_THAT(late.out, HasSubstr("second 1 ends without it"));
    EXPECT_EQ(logged(log_head + "Ring? tock\n", rule).exit, 0) << "the log may end anywhere";
    EXPECT_EQ(logged(log_head + "Ring? tock\nlost\ntock\ntock\n", rule).exit, 0);
    const std::string dark = "R when Ring and dark then OpenDoor within 0 seconds";
    EXPECT_EQ(logged(log_head + "Ring? dark?true tock\n", dark).exit, 1) << "read behind the trigger";
    EXPECT_EQ(logged(log_head + "Ring? dark?false tock\n", dark).exit, 0);
    const Ran open = logged(log_head + "Ring? tock\n", dark);
    EXPECT_EQ(open.exit, 3);
    EXPECT_THAT(open.out, HasSubstr("R begins while a measure that decides what it asks for is not read"));
    EXPECT_EQ(logged("robochart-trace 1\ncomponent Bell\nunobserved open!\nrun a\nRing? tock\ntock\n", rule).exit, 3);
    EXPECT_EQ(logged("robochart-trace 2\nrun a\n", rule).exit, 2);
    const std::string values = "R when Ring(1) then OpenDoor(_) within 0 seconds";
    EXPECT_EQ(logged(log_head + "Ring?1 tock\n", values).exit, 1);
    EXPECT_EQ(logged(log_head + "Ring?1 open!7 tock\nRing?2 tock\n", values).exit, 0);
    EXPECT_EQ(logged(log_head + "Ring? tock\n", values).exit, 3) << "the values are unknown";
    EXPECT_EQ(logged(log_head + "Ring? tock\n", "R when Ring and in A then OpenDoor within 0 seconds").exit, 3);
}

const std::string scenario = "corpus/aggregation/aggregation.scenario";

Ran guarded(const std::string& rules, const std::vector<std::string>& options = {"--monitor"}) {
    const Folder folder({{"turn.sleec",
                          "def_start\nevent seeRobot event seeWall event angularSpeed event Alarm\ndef_end\n"
                          "rule_start\n" +
                              rules + "\nrule_end\n"}});
    std::vector<std::string> arguments{"simulate", repository(scenario), folder / "turn.sleec", "--trials",
                                       "1",        "--no-pictures"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run(arguments);
}

/// A robot that turns because it sees another robot keeps turning, without a new command, while it still sees it.
TEST(RulesOfSimulations, StopATrialThatBreaksOne) {
    const Ran ran = guarded("Turn when seeRobot then angularSpeed within 0 seconds");
    EXPECT_EQ(ran.exit, 1) << ran.err;
    EXPECT_THAT(ran.err, HasSubstr("error[RC-M12]: the controller of robot "));
    EXPECT_THAT(ran.err, HasSubstr("Turn begins at second "));
    EXPECT_THAT(ran.err, HasSubstr(" with seeRobot: it asks for angularSpeed up to second "));
    EXPECT_THAT(ran.err, HasSubstr("turn.sleec:5); second "));
    EXPECT_THAT(ran.err, HasSubstr(" ends without it, at "));
}

/// In each cycle the eye reports either a wall or a robot, so One is never broken.
TEST(RulesOfSimulations, WhatIsObeyedIsCounted) {
    const Ran ran =
        guarded("One when seeWall then not seeRobot within 0 seconds\nOther when seeWall then Alarm within 5 seconds");
    EXPECT_THAT(ran.err, ::testing::Not(HasSubstr("RC-M12")));
    EXPECT_THAT(ran.out, HasSubstr("turn.sleec: 1 followed; robots watched: 20; a time unit is a second\n"));
    EXPECT_THAT(ran.out, HasSubstr("not followed: Other: the controller has no event and no operation 'Alarm'\n"));
}

/// Runs a scenario for two seconds without bands. The run succeeds unless a rule is broken or could not be followed.
Ran guarded_briefly(const std::string& rules, const std::string& rule, const std::vector<std::string>& options) {
    std::string measures;
    for (int i = 0; i < 13; ++i) measures += " measure m" + std::to_string(i) + " : boolean";
    const Folder folder(
        {{"aggregation.rct", tests::read_contents(repository("corpus/aggregation/aggregation.rct"))},
         {"brief.scenario",
          "scenario Brief for aggregation::Aggregation {\n"
          "step 0.1 s physics 0.01 s unit 0.1 s duration 2 s seed 1\narena 250 cm by 250 cm\n"
          "robots 3 { radius 3.7 cm axle 5.1 cm wheel 12.8 cm/s\n"
          "place random in (-125 cm, -125 cm) to (125 cm, 125 cm) }\n"
          "sensor eye is line_of_sight\nfeed seeRobot with eye.robot\nfeed seeWall with eye.clear\n"
          "actuator motors is differential_drive\n"
          "drive motors by speeds(linearSpeed in cm/s, angularSpeed in rad/s)\nmeasure spread is spread\n" +
              rule + "}\n"},
         {"a.sleec",
          "def_start\nevent seeRobot event seeWall" + measures + "\ndef_end\nrule_start\n" + rules + "\nrule_end\n"}});
    std::vector<std::string> arguments{"simulate", folder / "brief.scenario", folder / "a.sleec", "--monitor",
                                       "--no-pictures"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run(arguments);
}

const std::string unread = "One when seeWall and m0 then not seeRobot within 0 seconds";

/// An unchecked rule is no success, as in the comparison of logs by `conform`.
TEST(RulesOfSimulations, ThatCannotBeFollowedAreNoSuccess) {
    const Ran all = guarded_briefly("One when seeWall then not seeRobot within 0 seconds", "", {"--format", "json"});
    EXPECT_EQ(all.exit, 0) << all.err;
    const auto followed = nlohmann::json::parse(all.out).at("monitor");
    EXPECT_EQ(followed.at("complete"), true);
    EXPECT_THAT(followed.at("notes").at(0).get<std::string>(), HasSubstr("1 followed; robots watched: 3"));

    const Ran some = guarded_briefly(unread, "", {"--format", "json"});
    EXPECT_EQ(some.exit, 3) << some.err;
    const auto skipped = nlohmann::json::parse(some.out);
    EXPECT_EQ(skipped.at("exit"), 3);
    EXPECT_EQ(skipped.at("monitor").at("complete"), false);
    EXPECT_THAT(skipped.at("monitor").at("notes").at(1).get<std::string>(),
                HasSubstr("One: of 3 robots some triggers were not followed"));
    const Ran text = guarded_briefly(unread, "", {"--quiet"});
    EXPECT_EQ(text.exit, 3);
    EXPECT_THAT(text.out, HasSubstr("--monitor could not follow all that it asks for: not decided\n"));

    std::string many = "m0";
    for (int i = 1; i < 13; ++i) many += " and m" + std::to_string(i);
    const Ran given_up =
        guarded_briefly("One when seeWall and " + many + " then not seeRobot within 0 seconds", "", {});
    EXPECT_EQ(given_up.exit, 3) << "8,192 combinations of values";
    EXPECT_THAT(given_up.out, HasSubstr("robots were not followed to the end: "));
}

TEST(RulesOfSimulations, ThatCannotBeFollowedAreNoSuccessOfASweep) {
    const std::string rule =
        "vary robots in 2 to 3\ntrials 5\nestimate probability spread >= 0 cm at 1 s with confidence 90 %\n";
    EXPECT_EQ(guarded_briefly("One when seeWall then not seeRobot within 0 seconds", rule, {}).exit, 0);
    const Ran some = guarded_briefly(unread, rule, {"--format", "json"});
    EXPECT_EQ(some.exit, 3) << some.err;
    EXPECT_EQ(nlohmann::json::parse(some.out).at("monitor").at("complete"), false);
    const Ran text = guarded_briefly(unread, rule, {});
    EXPECT_EQ(text.exit, 3);
    EXPECT_THAT(text.out, HasSubstr("some triggers were not followed"));
}

TEST(RulesOfSimulations, WrongUseIsSaid) {
    EXPECT_EQ(guarded("R when seeWall then Alarm within 5 seconds").exit, 2) << "nothing is followed";
    EXPECT_EQ(guarded("R when seeWall then").exit, 2);
    EXPECT_EQ(guarded("R when seeWall then seeRobot", {}).exit, 4) << "without --monitor";
    EXPECT_EQ(run({"simulate", "a.sleec", "--monitor"}).exit, 4) << "no scenario";
}

TEST(RulesAsMonitors, AreWritten) {
    const Folder folder({{"care.sleec", head + "A when Go and near then Stop within 5 seconds\nrule_end\n"},
                         {"wrong.sleec", head + "A when\nrule_end\n"}});
    const Ran ran = run({"emit", "monitor", folder / "care.sleec", "-o", folder / "out"});
    EXPECT_EQ(ran.exit, 0) << ran.err;
    EXPECT_THAT(tests::read_contents(folder / "out/monitor/care/care_rules.hpp"), HasSubstr("namespace care_rules {"));
    EXPECT_THAT(tests::read_contents(folder / "out/monitor/care/robochart/rules.hpp"), HasSubstr("class RuleDuties"));
    const json written =
        json::parse(run({"emit", "monitor", folder / "care.sleec", "-o", folder / "out", "--format", "json"}).out);
    EXPECT_EQ(written["monitorFiles"].size(), 2U);
    EXPECT_EQ(run({"emit", "monitor", folder / "wrong.sleec", "-o", folder / "out"}).exit, 2);
    EXPECT_EQ(run({"emit", "monitor", folder / "care.sleec", "--component", "C"}).exit, 4);
}

/// Ring has no time limit, so the model may wait forever before it requests OpenDoor. The counterexample is an infinite
/// run of the model.
TEST(RulesOfModels, DrawARunThatWaitsWithoutEnd) {
    const Folder folder(
        {{"bell.rct",
          "stm Bell {\n\tevent Ring\n\tevent Open\n\tinitial i\n\tstate Idle { }\n\tstate Stuck { }\n"
          "\ttransition t0 { from i to Idle }\n\ttransition t1 { from Idle to Stuck trigger Ring }\n"
          "\ttransition t2 { from Stuck to Stuck trigger Ring action Open }\n}\n"},
         {"bell.sleec", "def_start event Ring event Open def_end rule_start R when Ring then Open rule_end"},
         {"bell.assertions", "sleec assertion A : Bell conforms to R\n"}});
    const Ran ran = run({"check", folder.path(), "--format", "json"});
    EXPECT_EQ(ran.exit, 1) << ran.err;
    const json found = json::parse(ran.out)["assertions"][0];
    ASSERT_FALSE(found["counterexample"].is_null()) << ran.out;
    const json& drawn = found["counterexample"];
    EXPECT_FALSE(drawn["loopStart"].is_null());
    std::string steps;
    for (const json& step : drawn["steps"]) steps += step["text"].get<std::string>() + "\n";
    EXPECT_THAT(steps, HasSubstr("Ring"));
    EXPECT_THAT(steps, ::testing::Not(HasSubstr("sleec_")));
    EXPECT_THAT(run({"check", folder.path()}).out, HasSubstr("then for ever:"));
}

}  // namespace
}  // namespace robochart::app::testing::rules_test
