// SPDX-License-Identifier: Apache-2.0
// Tests the claims of claims files: their verdicts, the explanations of the verdicts, and the facts on which they
// depend.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "driver/robochart_verify.hpp"
#include "tests/contents.hpp"
#include "tests/needed.hpp"
#include "tests/shared_folder.hpp"

namespace robochart::verify {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

/// One time unit is 0.1 s. In the module Late, Braking fails because a deadline stops time.
const char* const robots = R"(package patrol

interface Motion { goTo(waypoint : nat) halt() reverse() brake() }
interface Sensors { event obstacle event clear event estop event reset }

stm Patrol {
	const patience : nat = 3
	var waypoint : nat = 0
	clock T
	requires Motion
	uses Sensors
	initial start
	state Driving { entry goTo(waypoint) }
	state Held { entry halt() }
	state BackingOff { entry reverse() }
	state Emergency { entry brake() }
	transition begin { from start to Driving }
	transition met { from Driving to Held trigger obstacle #T }
	transition free { from Held to Driving trigger clear action waypoint = (waypoint + 1) % 3 }
	transition giveWay { from Held to BackingOff condition since(T) >= patience }
	transition again { from BackingOff to Driving trigger clear }
	transition stop { from Held to Emergency trigger estop }
	transition resume { from Emergency to Driving trigger reset }
}

stm Late {
	requires Motion
	uses Sensors
	initial start
	state Driving { }
	state Braking { entry (wait(3); brake()) <{ 1 } }
	transition begin { from start to Driving }
	transition stop { from Driving to Braking trigger estop }
}

stm Loop {
	uses Sensors
	initial start
	state A { }
	transition begin { from start to A }
	transition again { from A to A trigger obstacle }
}

stm Ends {
	requires Motion
	uses Sensors
	initial start
	state Driving { }
	final F
	transition begin { from start to Driving }
	transition stop { from Driving to F trigger estop }
}
)";

/// Decides claims about models whose texts are given, and stores the answers.
class Answers {
public:
    Answers(std::vector<Text> texts, const std::string& claims) {
        texts.push_back({"claims.claims", claims});
        LoadResult loaded = load_texts(texts);
        text_ = loaded.text;
        if (!loaded.model) return;
        CheckOptions options;
        options.limits.threads = 1;
        result_ = loaded.model->check(options);
        for (const Finding& finding : result_.findings) text_ += finding.code + ": " + finding.message + "\n";
    }
    /// Returns the answer to the claim with this name.
    [[nodiscard]] const Answer& of(const std::string& name) const {
        static const Answer none;
        const auto found = std::ranges::find_if(
            result_.answers, [&](const Answer& answer) { return answer.title.starts_with(name + " "); });
        EXPECT_NE(found, result_.answers.end()) << name << "\n" << text_;
        return found == result_.answers.end() ? none : *found;
    }
    [[nodiscard]] std::string verdict(const std::string& name) const { return std::string(name_of(of(name).verdict)); }
    [[nodiscard]] const std::string& text() const { return text_; }
    [[nodiscard]] bool any() const { return !result_.answers.empty(); }
    [[nodiscard]] std::vector<std::string> basis(const std::string& name) const {
        std::vector<std::string> result;
        for (const Ground& ground : of(name).basis) result.push_back(ground.text);
        return result;
    }

private:
    CheckResult result_;
    std::string text_;
};

struct Row {
    const char* claim;  ///< scope and body
    const char* verdict;
    const char* component = "";
};

/// Checks that each claim gets the verdict of its row. Claims are named C0, C1, ...
void expect_verdicts(const std::vector<Text>& models, const std::string& head, const std::vector<Row>& rows) {
    std::string claims = head;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const std::string component = rows[i].component;
        claims += "claim C" + std::to_string(i) + (component.empty() ? "" : " of " + component) + " : " +
                  rows[i].claim + "\n";
    }
    const Answers answers(models, claims);
    ASSERT_TRUE(answers.any()) << answers.text();
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Answer& answer = answers.of("C" + std::to_string(i));
        EXPECT_EQ(std::string(name_of(answer.verdict)), rows[i].verdict) << rows[i].claim << "\n"
                                                                         << answer.reason << "\n"
                                                                         << answer.text << "\n"
                                                                         << answers.text();
        EXPECT_TRUE(answer.verdict != Verdict::fails || answer.run ||
                    std::string(rows[i].claim).find("possible") != std::string::npos)
            << rows[i].claim;
    }
}

TEST(Claims, HaveTheirVerdicts) {
    expect_verdicts({{"patrol.rct", robots}}, "import patrol::*\nunit 0.1 s\n",
                    {
                        {"after estop until reset, never goTo or reverse", "holds", "Patrol"},
                        {"after estop until clear, never goTo or reverse", "fails", "Patrol"},
                        {"reverse at least 300 ms after obstacle", "holds", "Patrol"},
                        {"reverse at least 400 ms after obstacle", "fails", "Patrol"},
                        {"for 200 ms after obstacle, never reverse", "holds", "Patrol"},
                        {"for 300 ms after obstacle, never reverse", "fails", "Patrol"},
                        {"obstacle leads to reverse within 300 ms unless clear or estop", "holds", "Patrol"},
                        {"obstacle leads to reverse within 200 ms unless clear or estop", "fails", "Patrol"},
                        {"obstacle leads to halt within 0 s", "holds", "Patrol"},
                        {"estop leads to brake before any call but brake", "holds", "Patrol"},
                        {"estop leads to goTo before brake", "fails", "Patrol"},
                        {"obstacle leads to halt", "holds", "Patrol"},
                        {"obstacle leads to reverse", "fails", "Patrol"},
                        {"obstacle leads to reverse unless clear or estop", "holds", "Patrol"},
                        {"estop leads to goTo", "fails", "Patrol"},
                        {"estop leads to brake", "fails", "Ends"},
                        {"estop leads to brake", "fails", "Late"},
                        {"halt only after obstacle", "holds", "Patrol"},
                        {"goTo only after obstacle", "fails", "Patrol"},
                        {"brake only within 0 s after estop", "holds", "Patrol"},
                        {"reverse only within 0 s after obstacle", "fails", "Patrol"},
                        {"after each start or clear, at most 1 reverse", "holds", "Patrol"},
                        {"at most 3 goTo", "fails", "Patrol"},
                        {"at most 1 reverse in any 200 ms", "holds", "Patrol"},
                        {"at most 1 reverse in any 300 ms", "fails", "Patrol"},
                        {"goTo at least every 1 s", "fails", "Patrol"},
                        {"before obstacle, never halt", "holds", "Patrol"},
                        {"before clear, never halt", "fails", "Patrol"},
                        {"before obstacle, never goTo(w) with w > 0", "holds", "Patrol"},
                        {"never goTo(w) with w == 2", "fails", "Patrol"},
                        {"never goTo(v) with v != last goTo and v != (last goTo + 1) % 3", "holds", "Patrol"},
                        {"never goTo(v) with v == last goTo", "fails", "Patrol"},
                        {"possible goTo(2)", "holds", "Patrol"},
                        {"before obstacle, possible goTo(2)", "fails", "Patrol"},
                        {"before obstacle, possible brake", "fails", "Patrol"},
                        {"never terminate", "holds", "Patrol"},
                        {"never brake", "holds", "Ends"},
                        {"never terminate", "fails", "Ends"},
                        {"estop leads to brake within 1 units", "fails", "Ends"},
                        {"estop leads to brake before terminate", "fails", "Ends"},
                        {"estop leads to brake within 1 units", "fails", "Late"},
                        {"never reverse", "holds", "Late"},
                        {"never raised estop", "inconclusive", "Late"},
                    });
}

TEST(Claims, AboutStatesAndVariables) {
    expect_verdicts({{"patrol.rct", robots}}, "import patrol::*\nunit 0.1 s\n",
                    {
                        {"always in Driving or in Held or in BackingOff or in Emergency", "holds", "Patrol"},
                        {"always not in Emergency", "fails", "Patrol"},
                        {"after estop until reset, always in Emergency", "holds", "Patrol"},
                        {"after estop until clear, always in Emergency", "fails", "Patrol"},
                        {"while in Emergency, never goTo", "holds", "Patrol"},
                        {"while in Emergency, never reset", "fails", "Patrol"},  // taken in the state
                        {"while in Held, never halt", "fails", "Patrol"},      // the entry action belongs to the state
                        {"while in Held, never obstacle", "holds", "Patrol"},  // the transition leads into the state
                        {"while not in Held, never halt", "holds", "Patrol"},
                        {"enter Held leads to halt within 0 s", "holds", "Patrol"},
                        {"leave Held leads to goTo or reverse or brake within 0 s", "holds", "Patrol"},
                        {"leave Held leads to goTo within 0 s", "fails", "Patrol"},
                        {"while in Held, estop leads to goTo within 0 s", "holds", "Patrol"},  // the scope ends
                        {"in Held for at most 300 ms", "holds", "Patrol"},
                        {"in Held for at most 200 ms", "fails", "Patrol"},
                        {"in Held for at least 100 ms", "fails", "Patrol"},
                        {"in BackingOff for at most 1 s", "fails", "Patrol"},
                        {"after estop until reset, in Held for at most 0 s", "holds", "Patrol"},
                        {"always waypoint < 3", "holds", "Patrol"},
                        {"always waypoint <= 1", "fails", "Patrol"},
                        {"always waypoint < patience", "holds", "Patrol"},
                        {"always 2 * waypoint < patience + 1.5", "holds", "Patrol"},
                        {"always 2 * waypoint < patience + 0.5", "fails", "Patrol"},
                        {"while waypoint == 1, never goTo(2)", "holds", "Patrol"},
                        {"while waypoint == 2, never goTo(2)", "fails", "Patrol"},
                        {"possible in Emergency", "holds", "Patrol"},
                        {"possible waypoint == 2 and in Held", "holds", "Patrol"},
                        {"possible waypoint == 3", "fails", "Patrol"},
                        {"before obstacle, possible in Held", "fails", "Patrol"},
                        {"while in Driving, can take obstacle", "holds", "Patrol"},
                        {"can take obstacle", "fails", "Patrol"},
                        {"can take clear within 300 ms", "fails", "Patrol"},
                        {"while in Held, can take clear", "holds", "Patrol"},
                        {"at most 1 enter A", "fails", "Loop"},
                        {"while in A, at most 1 obstacle", "holds", "Loop"},
                        {"always in A", "holds", "Loop"},
                        {"estop leads to leave Driving within 0 s", "holds", "Late"},
                        {"in Braking for at most 5 units", "fails", "Late"},  // time stops in Braking
                    });
}

TEST(Claims, HoldUnderAssumptions) {
    const std::string claims = "claim A of Patrol : never reverse\nclaim B of Patrol : never brake\n";
    const Answers without({{"patrol.rct", robots}}, "import patrol::*\n" + claims);
    EXPECT_EQ(without.verdict("A"), "fails");
    const Answers with(
        {{"patrol.rct", robots}},
        "import patrol::*\nassume Soon of Patrol : obstacle leads to clear or estop within 2 units\n" + claims);
    EXPECT_EQ(with.verdict("A"), "holds") << with.of("A").reason << with.text();
    EXPECT_EQ(with.verdict("B"), "fails");
    const Answers never({{"patrol.rct", robots}},
                        "import patrol::*\nassume Calm of Patrol : never obstacle\n" + claims);
    EXPECT_EQ(never.verdict("B"), "holds");
    const Answers two({{"patrol.rct", robots}},
                      "import patrol::*\nassume Soon of Patrol : obstacle leads to clear or estop within 2 units\n"
                      "assume Sure of Patrol : obstacle leads to clear within 1 units unless estop\n"
                      "claim A of Patrol : in Held for at most 1 units\n"
                      "claim B of Patrol : obstacle leads to goTo or brake within 1 units\n");
    EXPECT_EQ(two.verdict("A"), "holds") << two.of("A").reason << two.text();
    EXPECT_EQ(two.verdict("B"), "holds") << two.of("B").reason << two.text();
    // In Emergency, the robot does not react to clear.
    const Answers stops({{"patrol.rct", robots}},
                        "import patrol::*\nassume Soon of Patrol : obstacle leads to clear within 2 units\n" + claims);
    EXPECT_EQ(stops.verdict("A"), "inconclusive");
    EXPECT_THAT(stops.of("A").reason, HasSubstr("Soon (claims.claims:2) would stop time"));
}

TEST(Claims, TellWhatBrokeThem) {
    const Answers answers({{"patrol.rct", robots}},
                          "import patrol::*\nunit 0.1 s\n"
                          "claim Back of Patrol : reverse at least 0.4 s after obstacle\n"
                          "claim Stays of Patrol : after estop until clear, never goTo\n"
                          "claim Owed of Patrol : obstacle leads to reverse within 0.2 s unless clear or estop\n"
                          "claim Stops of Late : estop leads to brake within 5 units\n"
                          "claim Ends of Ends : estop leads to brake within 1 units\n");
    const auto end_of = [&](const std::string& name) { return answers.of(name).run ? answers.of(name).run->end : ""; };
    EXPECT_EQ(end_of("Back"),
              "reverse comes at t=3 (0.3 s), 3 units (300 ms) after obstacle at t=0 (0.0 s); the claim allows it from "
              "t=4 (0.4 s) on");
    EXPECT_EQ(end_of("Stays"),
              "the scope began with estop at t=0 (0.0 s); goTo(0) comes at t=0 (0.0 s), which the claim forbids");
    EXPECT_EQ(end_of("Owed"),
              "reverse is owed until t=2 (0.2 s), 2 units (200 ms) after obstacle at t=0 (0.0 s); time passes beyond "
              "t=2 (0.2 s)");
    const Answers states({{"patrol.rct", robots}},
                         "import patrol::*\nunit 0.1 s\n"
                         "claim Long of Patrol : in Held for at most 0.2 s\n"
                         "claim Low of Patrol : always waypoint <= 1\n");
    EXPECT_EQ(states.of("Long").run ? states.of("Long").run->end : "",
              "`in Held` holds since t=0 (0.0 s); the claim allows 2 units (200 ms); time passes beyond t=2 (0.2 s)");
    EXPECT_EQ(states.of("Low").run ? states.of("Low").run->end : "",
              "at t=0 (0.0 s), when time passes, `waypoint <= 1` does not hold");
    EXPECT_THAT(end_of("Stops"), HasSubstr("time stops at t=1 (0.1 s)"));
    EXPECT_THAT(end_of("Ends"), HasSubstr("the component ends at t=0 (0.0 s)"));
}

TEST(Claims, SayWhatIsNeverAsked) {
    const Answers answers({{"patrol.rct", robots}},
                          "import patrol::*\n"
                          "claim Scope of Ends : after brake until halt, never estop\n"
                          "claim Event of Ends : never brake\n"
                          "claim State of Loop : always in A\n"
                          "claim Asked of Patrol : after estop until reset, never goTo\n");
    EXPECT_THAT(answers.basis("State"), Not(Contains(HasSubstr("time can stop"))));
    EXPECT_THAT(answers.basis("Scope"), Contains(HasSubstr("never asked")));
    EXPECT_THAT(answers.basis("Event"), Contains(HasSubstr("no run has brake")));
    EXPECT_THAT(answers.basis("Asked"), Not(Contains(HasSubstr("never asked"))));
}

TEST(Claims, AreReadInAssertionFilesWithoutAComponent) {
    const LoadResult loaded =
        load_texts({{"m.rct",
                     "stm M { event e initial i state A { } transition t { from i to A } "
                     "transition u { from A to A trigger e } }"},
                    {"a.assertions", "assertion Free : M is deadlock-free\nclaim Back : never e\n"}});
    ASSERT_TRUE(loaded.model) << loaded.text;
    EXPECT_THAT(loaded.text, HasSubstr("RC-P39"));
}

TEST(Claims, AreReadInAssertionFilesWithAWarning) {
    LoadResult loaded = load_texts({{"patrol.rct", robots},
                                    {"a.assertions",
                                     "import patrol::*\nassertion Free : Patrol is deadlock-free\nunit 0.1 s\n"
                                     "claim Back of Patrol : reverse at least 0.3 s after obstacle\n"
                                     "claim Soon of Patrol : reverse at least 0.4 s after obstacle\n"}});
    ASSERT_TRUE(loaded.model) << loaded.text;
    EXPECT_THAT(loaded.text, HasSubstr("RC-P39"));
    CheckOptions options;
    options.limits.threads = 1;
    const CheckResult result = loaded.model->check(options);
    const auto verdict_of = [&](const std::string& name) {
        const auto found = std::ranges::find_if(
            result.answers, [&](const Answer& answer) { return answer.title.starts_with(name + " "); });
        return found == result.answers.end() ? "" : std::string(name_of(found->verdict));
    };
    EXPECT_EQ(verdict_of("Back"), "holds");
    EXPECT_EQ(verdict_of("Soon"), "fails");
    const LoadResult wrong = load_texts(
        {{"patrol.rct", robots}, {"a.assertions", "import patrol::*\n\nclaim Back of Patrol : never holt\n"}});
    EXPECT_THAT(wrong.text, HasSubstr("a.assertions:3:30"));
    const LoadResult untimed =
        load_texts({{"patrol.rct", robots}, {"a.assertions", "untimed claim Back of Patrol : never halt\n"}});
    EXPECT_THAT(untimed.text, HasSubstr("timed semantics"));
}

/// The message names the values that the instantiation contains.
TEST(Claims, NameTheValuesOfTheInstantiation) {
    const LoadResult five =
        load_texts({{"patrol.rct", robots},
                    {"a.claims", "import patrol::*\nclaim A of Patrol : goTo(50) leads to halt within 1 units\n"}});
    EXPECT_THAT(five.text, HasSubstr("no value of the finite instantiation satisfies `goTo(50)`: nat is 0..2 here"));
}

/// A csp block may change numbers, but not enumerations and truth values.
TEST(Claims, ReadTruthValuesBesideABlockOfValues) {
    const std::string model =
        "package p interface E { event lamp : boolean event level : nat event lit } stm S { uses E var v : boolean var "
        "n "
        ": "
        "nat initial i state A { } transition t { from i to A } transition a { from A to A trigger lamp?v action lit } "
        "transition b { from A to A trigger level?n } }";
    const Answers answers({{"m.rct", model},
                           {"b.assertions",
                            "package q import p::* timed csp Instantiations csp-begin\nnametype core_nat = {0..1}\n"
                            "nametype core_int = {0..1}\nnametype core_real = {0..1}\nnametype core_boolean = Bool\n"
                            "nametype core_string = {0}\ncsp-end\n"}},
                          "import p::*\nclaim A of S : lit only after lamp(true) or lamp(false)\n"
                          "claim B of S : lit only after lamp(x) with x\nclaim C of S : never level(1)\n");
    EXPECT_EQ(answers.verdict("A"), "holds") << answers.of("A").reason << answers.text();
    EXPECT_EQ(answers.verdict("B"), "fails") << answers.of("B").reason;
    EXPECT_EQ(answers.verdict("C"), "inconclusive");
    EXPECT_THAT(answers.of("C").reason, HasSubstr("a csp block sets the values"));
}

TEST(Claims, AreErrorsWithAPlace) {
    const LoadResult loaded = load_texts({{"patrol.rct", robots}, {"a.claims", "claim A of Patrol : never holt\n"}});
    EXPECT_FALSE(loaded.model);
    EXPECT_THAT(loaded.text, HasSubstr("a.claims:1:27"));
    const LoadResult value =
        load_texts({{"patrol.rct", robots}, {"a.claims", "claim A of Patrol : never goTo(w) with w > 900000\n"}});
    EXPECT_THAT(value.text, HasSubstr("CLM-T11"));
}

// ---------------------------------------------------------------- constants

/// The constants of these machines decide what the claims are about: a duration, a wait, a bound, a literal.
const char* const tuned = R"(package tuned

enumeration Mode { careful fast }
interface Motion { halt() reverse() }

stm Waits {
	const patience : nat = 3
	clock T
	requires Motion
	event obstacle
	event clear
	initial i
	state Free { }
	state Held { entry halt() }
	state Back { entry reverse() }
	transition t0 { from i to Free }
	transition t1 { from Free to Held trigger obstacle #T }
	transition t2 { from Held to Back condition since(T) >= patience }
	transition t3 { from Back to Free trigger clear }
}

stm Slow {
	const pause : nat = 2
	event obstacle
	initial i
	state A { entry wait(pause) }
	transition t0 { from i to A }
	transition t1 { from A to A trigger obstacle }
}

stm Counts {
	const limit : nat = 2
	var n : nat = 0
	event tick
	event beep
	initial i
	state A { }
	transition t0 { from i to A }
	transition t1 { from A to A trigger tick condition n < limit action n = n + 1; send beep }
}

stm Chooses {
	const mode : Mode = Mode::careful
	requires Motion
	event obstacle
	initial i
	state A { }
	transition t0 { from i to A }
	transition t1 { from A to A trigger obstacle condition mode == Mode::fast action reverse() }
	transition t2 { from A to A trigger obstacle condition mode == Mode::careful action halt() }
}

controller Brain {
	requires Motion
	event obstacle
	event clear
	sref waits = Waits
	connection Brain on obstacle to waits on obstacle
	connection Brain on clear to waits on clear
}

module Robot {
	robotic platform Body {
		provides Motion
		event obstacle
		event clear
	}
	cref brain = Brain
	connection Body on obstacle to brain on obstacle ( _async )
	connection Body on clear to brain on clear ( _async )
}
)";

TEST(Claims, SetConstants) {
    expect_verdicts(
        {{"tuned.rct", tuned}}, "import tuned::*\nunit 0.1 s\n",
        {
            {"reverse at least 3 units after obstacle", "holds", "Waits"},
            {"reverse at least 4 units after obstacle", "fails", "Waits"},
            {"reverse at least 5 units after obstacle with constant patience of Waits set to 5", "holds", "Waits"},
            {"reverse at least 5 units after obstacle with constant patience of Waits set to 4", "fails", "Waits"},
            {"reverse at least 0.5 s after obstacle with constant patience of Waits set to 500 ms", "holds", "Waits"},
            {"reverse at least 30 units after obstacle with constant patience of Waits set to 3 s", "holds", "Waits"},
            {"reverse at least 31 units after obstacle with constant patience of Waits set to 3 s", "fails", "Waits"},
            {"possible reverse with constant patience of Waits set to 30 units", "holds", "Waits"},
            {"obstacle leads to reverse within 2 units with constant patience of Waits set to 2", "holds", "Waits"},
            {"obstacle leads to reverse within 1 units with constant patience of Waits set to 2", "fails", "Waits"},
            {"obstacle leads to reverse with constant patience of Waits set to 5", "holds", "Waits"},
            {"in Held for at most 4 units with constant patience of Waits set to 4", "holds", "Waits"},
            {"in Held for at most 4 units with constant patience of Waits set to 5", "fails", "Waits"},
            {"can take obstacle within 2 units", "holds", "Slow"},
            {"can take obstacle within 2 units with constant pause of Slow set to 3", "fails", "Slow"},
            {"can take obstacle within 3 units with constant pause of Slow set to 3 units", "holds", "Slow"},
            {"at most 2 beep", "holds", "Counts"},
            {"at most 4 beep with constant limit of Counts set to 4", "holds", "Counts"},
            {"at most 3 beep with constant limit of Counts set to 4", "fails", "Counts"},
            {"always n <= 4 with constant limit of Counts set to 4", "holds", "Counts"},
            {"always n <= 3 with constant limit of Counts set to 4", "fails", "Counts"},
            {"always n <= limit with constant limit of Counts set to 4", "holds", "Counts"},
            {"never reverse", "holds", "Chooses"},
            {"never reverse with constant mode of Chooses set to Mode::fast", "fails", "Chooses"},
            {"never halt with constant mode of Chooses set to fast", "holds", "Chooses"},
            {"reverse at least 4 units after obstacle", "fails", "Robot"},
            {"reverse at least 5 units after obstacle with constant patience of Waits set to 5", "holds", "Robot"},
            {"reverse at least 5 units after obstacle with constant patience of waits set to 5", "holds",
             "Robot::brain"},
        });
}

/// An assumption is about claims with any constants. The ticks are two units apart.
TEST(Claims, SetConstantsUnderAssumptions) {
    expect_verdicts({{"tuned.rct", tuned}},
                    "import tuned::*\nassume Seldom of Counts : tick at least 2 units after tick\n",
                    {
                        {"at most 1 tick in any 1 units with constant limit of Counts set to 4", "holds", "Counts"},
                        {"at most 1 tick in any 2 units with constant limit of Counts set to 4", "fails", "Counts"},
                        {"at most 1 tick in any 2 units with constant limit of Counts set to 1", "holds", "Counts"},
                    });
}

TEST(Claims, NameTheConstantsThatTheySet) {
    const Answers answers({{"tuned.rct", tuned}},
                          "import tuned::*\n"
                          "claim B of Waits : reverse at least 5 units after obstacle with constant patience of Waits "
                          "set to 4\nclaim A of Waits : never halt\n"
                          "claim V of Waits : after clear, never halt with constant patience of Waits set to 4\n");
    EXPECT_THAT(answers.of("B").title, HasSubstr("after obstacle with constant patience of Waits set to 4"));
    EXPECT_THAT(answers.of("B").text, HasSubstr("reverse comes at t=4"));
    EXPECT_EQ(answers.verdict("A"), "fails");
    EXPECT_EQ(answers.verdict("V"), "fails");
}

/// RC-U01 is about untimed checks. Claims are timed.
TEST(Claims, AreNotWarnedOfUntimedChecks) {
    const std::string claim = "import tuned::*\nclaim A of Waits : never terminate\n";
    EXPECT_THAT(Answers({{"tuned.rct", tuned}}, claim).text(), Not(HasSubstr("RC-U01")));
    const Text timed{"a.assertions", "import tuned::* timed assertion T : Waits is deadlock-free"};
    EXPECT_THAT(Answers({{"tuned.rct", tuned}, timed}, claim).text(), Not(HasSubstr("RC-U01")));
    const Text both{"a.assertions", "import tuned::* assertion T : Waits is deadlock-free"};
    EXPECT_THAT(Answers({{"tuned.rct", tuned}, both}, claim).text(), HasSubstr("RC-U01"));
}

TEST(Claims, RejectConstantsWithoutEffect) {
    const auto text = [](const std::string& constant) {
        return Answers({{"tuned.rct", tuned}},
                       "import tuned::*\nclaim A of Robot : never halt with constant " + constant)
            .text();
    };
    EXPECT_THAT(text("pause of Slow set to 1"), HasSubstr("CLM-T17"));
    EXPECT_THAT(text("pause of Slow set to 1"), HasSubstr("does not affect tuned::Robot"));
    EXPECT_THAT(text("patience of Slow set to 1"), HasSubstr("tuned::Slow has no constant `patience`"));
    EXPECT_THAT(text("patience of Waits set to 0.25 s"), HasSubstr("how long is a time unit?"));
}

// ---------------------------------------------------------------- shared/suite/claims/EXPECTED.md

std::vector<Text> suite_models(const std::string& name) {
    std::vector<Text> result;
    for (const auto& entry : std::filesystem::directory_iterator(tests::shared_folder() / "suite/claims" / name))
        if (entry.path().extension() == ".rct")
            result.push_back({entry.path().filename().string(), tests::read_contents(entry.path())});
    return result;
}

bool has_suite() {
    return !tests::shared_folder().empty() && std::filesystem::is_directory(tests::shared_folder() / "suite/claims");
}

TEST(ClaimsSuite, Warehouse) {
    ROBOCHART_NEEDS(has_suite(), "shared/suite/claims");
    const std::string unless = " unless clear or estop or batteryLow";
    const std::string in_time = "obstacle leads to reverse or callHelp within 3 s" + unless;
    const std::string too_late = "obstacle leads to reverse or callHelp within 2.9 s" + unless;
    const std::string alone = "obstacle leads to reverse within 3 s" + unless;
    expect_verdicts(suite_models("warehouse"), "import warehouse::*\nunit 0.1 s\n",
                    {
                        {"after estop until reset, never goTo or reverse or dock", "holds"},
                        {"after estop until clear, never goTo or reverse or dock", "fails"},
                        {"estop leads to brake before any call but brake", "holds"},
                        {"estop leads to brake within 0 s", "holds"},
                        {"reverse at least 3 s after obstacle", "holds"},
                        {"reverse at least 3.1 s after obstacle", "fails"},
                        {"for 3 s after obstacle, never reverse", "fails"},
                        {"after each start or clear or arrived, at most 3 reverse", "holds"},
                        {"after each start or clear or arrived, at most 2 reverse", "fails"},
                        {"never goTo(w) with w >= 4", "holds"},
                        {"never goTo(w) with w >= 3", "fails"},
                        {in_time.c_str(), "holds"},
                        {too_late.c_str(), "fails"},
                        {alone.c_str(), "fails"},
                        {"after batteryLow until charged, obstacle leads to halt within 0 s", "holds"},
                        {"obstacle leads to reverse", "fails"},
                        {"obstacle leads to halt", "holds"},
                        {"possible callHelp", "holds"},
                        {"never goTo(v) with v != last goTo and v != (last goTo + 1) % 4", "holds"},
                        {"dock only within 0 s after batteryLow or reset", "holds"},
                    });
}

TEST(ClaimsSuite, Rover) {
    ROBOCHART_NEEDS(has_suite(), "shared/suite/claims");
    expect_verdicts(suite_models("rover"), "import rover::*\n",
                    {
                        {"forward only after go", "holds"},
                        {"after stop until go, never forward", "holds"},
                        {"after each start or go, at most 2 turn", "holds"},
                        {"after each start or go, at most 1 turn", "fails"},
                        {"forward at least 4 units after turn", "fails"},
                        {"forward at least 4 units after turn unless halt", "holds"},
                        {"stop leads to halt within 1 units", "holds"},
                        {"stop leads to halt within 0 units", "holds"},
                    });
}

TEST(ClaimsSuite, Forager) {
    ROBOCHART_NEEDS(has_suite(), "shared/suite/claims");
    expect_verdicts(suite_models("forager"), "import foraging::*\nunit 1 s\n",
                    {
                        {"grab only after food", "holds"},
                        {"food leads to grab within 0 s", "holds"},
                        {"drop leads to halt within 0 s", "holds"},
                        {"search at least 5 s after halt", "holds"},
                        {"search at least 6 s after halt", "fails"},
                        {"in Resting for at least 5 s", "holds"},
                        {"in Searching for at most 20 s", "holds"},
                        {"in Searching for at most 19 s", "fails"},
                        {"in Homing for at most 1 min", "fails"},
                        {"while in Resting, never food", "holds"},
                        {"while in Homing, at most 1 drop", "holds"},
                        {"after each drop, at most 1 search", "holds"},
                        {"possible in Homing", "holds"},
                    });
}

TEST(ClaimsSuite, Beacon) {
    ROBOCHART_NEEDS(has_suite(), "shared/suite/claims");
    expect_verdicts(suite_models("beacon"), "import moving_beacon::*\n",
                    {
                        {"at most 1 goNorth or goSouth", "holds"},
                        {"enter Away only after goNorth or goSouth", "holds"},
                        {"while in Away, never goNorth or goSouth", "holds"},
                        {"crowded leads to goNorth", "fails"},
                        {"before goNorth or goSouth, crowded leads to goNorth or goSouth within 0 units", "holds"},
                        {"crowded leads to goNorth or goSouth within 0 units", "fails"},  // not the second time
                        {"at most 1 enter Away", "fails"},  // a transition leaves Away and enters it again
                    });
}

/// Alpha counts its neighbours every ten units. It turns round if it hears fewer neighbours than before.
TEST(ClaimsSuite, Alpha) {
    ROBOCHART_NEEDS(has_suite(), "shared/suite/claims");
    expect_verdicts(suite_models("alpha"), "import alpha::*\n",
                    {
                        {"neighbours only after countNeighbours", "holds"},
                        {"countNeighbours at least 10 units after countNeighbours", "holds"},
                        {"countNeighbours at least 11 units after countNeighbours", "fails"},
                        {"countNeighbours at least every 10 units", "fails"},  // the count may never be answered
                        {"startTurning only after neighbours", "holds"},
                        {"turned leads to moveForward within 0 units", "holds"},
                        {"enter Coherence only after startTurning", "holds"},
                        {"in TurningBack for at least 1 units", "holds"},
                        {"in TurningBack for at least 2 units", "fails"},
                        {"neighbours leads to startTurning", "fails"},
                    });
}

/// A robot that avoids others turns for at least one unit and drives on. After 25 further units, it turns to the swarm.
TEST(ClaimsSuite, Taxis) {
    ROBOCHART_NEEDS(has_suite(), "shared/suite/claims");
    expect_verdicts(suite_models("taxis"), "import swarm_taxis::*\nunit 0.1 s\n",
                    {
                        {"MoveForward leads to CheckIlluminationStatus within 0 s", "holds"},
                        {"robotDetected leads to CalcAvoidanceHeading within 0 s", "holds"},
                        {"StartTurning only after heading", "holds"},
                        {"turned leads to MoveForward within 0 s", "holds"},
                        {"MoveForward at least 100 ms after MoveForward", "holds"},
                        {"MoveForward at least 200 ms after MoveForward", "fails"},
                        {"CalcCoherenceHeading at least 2.6 s after robotDetected", "holds"},
                        {"CalcCoherenceHeading at least 2.7 s after robotDetected", "fails"},
                        {"for 2.5 s after robotDetected, never CalcCoherenceHeading", "holds"},
                        {"for 2.6 s after robotDetected, never CalcCoherenceHeading", "fails"},
                    });
}

/// The robot turns, and turns again three units later. One unit later it drives. Each turn counts.
TEST(ClaimsSuite, NotBefore) {
    ROBOCHART_NEEDS(has_suite(), "shared/suite/claims");
    expect_verdicts(suite_models("not_before"), "import twice::*\n",
                    {{"forward at least 1 units after turn", "holds"},
                     {"forward at least 2 units after turn", "fails"},
                     {"forward at least 4 units after turn", "fails"}});
}

TEST(ClaimsSuite, Ends) {
    ROBOCHART_NEEDS(has_suite(), "shared/suite/claims");
    expect_verdicts(suite_models("ends"), "import ends::*\n",
                    {
                        {"never brake", "holds", "Ends"},
                        {"estop leads to brake within 1 units", "fails", "Ends"},
                        {"estop leads to brake within 1 units", "fails", "Late"},
                    });
}

}  // namespace
}  // namespace robochart::verify
