// SPDX-License-Identifier: Apache-2.0
// Tests scenarios with several kinds of robots and an environment: findings, constants, logs, monitors, sweeps, tuning,
// the page.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "base/diagnostics/files.hpp"
#include "tests/app/command.hpp"
#include "tests/app/command/page.hpp"
#include "tests/contents.hpp"

namespace robochart::app::testing::kinds_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using tests::read_contents;

constexpr const char* sheep = R"(package herd
interface Legs { run() }
interface Ears { event shout }
robotic platform Body { provides Legs uses Ears }
stm Runner {
	requires Legs
	uses Ears
	initial i
	state Waiting { }
	state Running { entry run() }
	transition t0 { from i to Waiting }
	transition t1 { from Waiting to Running trigger shout }
}
controller Brain { requires Legs uses Ears sref runner = Runner connection Brain on shout to runner on shout }
module Sheep { rref body = Body cref brain = Brain connection body on shout to brain on shout (_async) }
)";

/// A robot that drives back for a number of time units. Its unused declarations cause warnings.
constexpr const char* leader = R"(package lead
interface Wheels { const pace : nat back() halt() }
robotic platform Body { provides Wheels }
stm Backer {
	requires Wheels
	clock T
	var unused : nat
	initial i
	state Backing { entry back() }
	state Standing { entry halt() }
	transition t0 { from i to Backing action # T }
	transition t1 { from Backing to Standing condition since(T) >= pace }
}
stm Idle { initial i state Here { } transition t0 { from i to Here } }
controller Brain { requires Wheels sref b = Backer sref idle = Idle }
module Leader { rref body = Body cref brain = Brain }
)";

/// An environment that makes a call after a number of time units.
constexpr const char* sun = R"(package sky
interface Calls { const delay : nat call() }
robotic platform Sky { provides Calls }
stm Waits {
	requires Calls
	initial i
	state Dark { entry wait(delay) }
	state Bright { entry call() }
	transition t0 { from i to Dark }
	transition t1 { from Dark to Bright }
}
controller Brain { requires Calls sref waits = Waits }
module Sun { rref sky = Sky cref brain = Brain }
)";

/// Leaders start 10 cm from the goal, and drive back 1 cm in each time unit.
constexpr const char* world = R"(scenario Herd for herd::Sheep {
	model "sheep"
	step 0.1 s physics 0.01 s unit 0.1 s duration 3 s trials 1 seed 1
	arena 400 cm by 400 cm
	light goal at (-10 cm, 100 cm)
	robots 2 sheep { radius 3 cm axle 5 cm wheel 10 cm/s
		place at (0 cm, 0 cm) heading 0 deg
		place at (0 cm, 50 cm) heading 0 deg }
	actuator motors is differential_drive
	drive motors by forward(10 cm/s) on run
	robots 1 leaders for lead::Leader {
		model "leader"
		const pace = 3
		place at (0 cm, 100 cm) heading 0 deg
		drive motors by forward(-10 cm/s) on back
		drive motors by stop on halt
	}
	robots 1 slow for lead::Leader {
		model "leader"
		const pace = 5
		place at (0 cm, 150 cm) heading 0 deg
		drive motors by forward(-10 cm/s) on back
		drive motors by stop on halt
	}
	environment sky::Sun {
		model "sky"
		const delay = 5
		stimulus shout on call
	}
	measure way is distance(goal) of leaders
	measure running is in_state(Running)
	record 0.5 s
	CLAIMS
}
)";

const char* const bands = "accept each way in 5.5 cm to 8 cm accept each running >= 50 %";
const char* const claim = "accept probability way <= 0.5 cm at end >= 90 % with confidence 90 %";

class Herd {
public:
    explicit Herd(const std::string& claims)
        : folder_(
              {{"herd/sheep/sheep.rct", sheep},
               {"herd/sheep/sheep.assertions", "assertion S1 : herd::Runner::Running is reachable in herd::Sheep\n"},
               {"herd/leader/leader.rct", leader},
               {"herd/leader/leader.assertions",
                "assertion L1 : lead::Backer::Standing is reachable in lead::Leader\n"},
               {"herd/sky/sky.rct", sun},
               {"herd/sky/sky.assertions", "assertion E1 : sky::Waits::Bright is reachable in sky::Sun\n"},
               {"herd/herd.scenario", asking(claims)}}) {}
    [[nodiscard]] std::string operator/(const std::string& name) const { return folder_ / name; }
    [[nodiscard]] Ran simulated(const std::vector<std::string>& more) const {
        std::vector<std::string> words{"simulate", folder_ / "herd/herd.scenario", "--no-pictures"};
        words.insert(words.end(), more.begin(), more.end());
        return run(words);
    }

private:
    static std::string asking(const std::string& claims) {
        std::string text = world;
        text.replace(text.find("CLAIMS"), 6, claims);
        return text;
    }
    Folder folder_;
};

std::size_t count(const std::string& text, const std::string& what) {
    std::size_t found = 0;
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
    return found;
}

/// If two kinds have the same model, its warnings are shown once. If warnings are denied, a warning of any model ends
/// the run.
TEST(KindsOfRobots, WarningsOfEachModelAreShownOnce) {
    const Herd herd(bands);
    const Ran ran = herd.simulated({});
    EXPECT_EQ(ran.exit, 0) << ran.out << ran.err;
    EXPECT_EQ(count(ran.err, "variable `unused` is never used"), 1U) << ran.err;
    const Ran denied = herd.simulated({"--deny-warnings"});
    EXPECT_EQ(denied.exit, 2);
    EXPECT_THAT(denied.err, HasSubstr("variable `unused` is never used"));
    EXPECT_THAT(denied.err, HasSubstr("warnings are denied"));
}

/// Each log records the constants of its controller. `conform` compares the log with the model for these constants,
/// unless the command line sets others.
TEST(KindsOfRobots, LogsHaveTheConstantsOfTheirKind) {
    const Herd herd(bands);
    const Ran ran = herd.simulated({"--log", herd / "logs", "--monitor"});
    ASSERT_EQ(ran.exit, 0) << ran.out << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("2 robots watched"));
    EXPECT_THAT(ran.out, HasSubstr("the environment is not watched"));
    const auto log = [&](const std::string& robot) { return herd / ("logs/trial-01/robot-0" + robot + ".trace"); };
    EXPECT_THAT(read_contents(log("0")), Not(HasSubstr("const ")));
    EXPECT_THAT(read_contents(log("2")), HasSubstr("\nconst pace=3\ncomponent lead::Leader\n"));
    EXPECT_THAT(read_contents(log("3")), HasSubstr("\nconst pace=5\ncomponent lead::Leader\n"));
    const std::vector<std::string> compare{"conform", herd / "herd/leader", "--traces", log("2"), "--traces", log("3")};
    const Ran both = run(compare);
    EXPECT_EQ(both.exit, 0) << both.out << both.err;
    EXPECT_THAT(both.out, HasSubstr("2 runs in 2 logs, 60 cycles: 2 accepted"));
    auto with = compare;
    with.insert(with.end(), {"--const", "pace=3"});
    const Ran one = run(with);
    EXPECT_EQ(one.exit, 1) << one.out << one.err;
    EXPECT_THAT(one.out, HasSubstr("1 accepted, 1 rejected"));

    const auto changed = [&](const std::string& line) {
        std::string text = read_contents(log("2"));
        text.replace(text.find("const pace=3"), 12, line);
        EXPECT_EQ(diagnostics::replace_file(herd / "changed.trace", text), "");
        const Ran refused = run({"conform", herd / "herd/leader", "--traces", herd / "changed.trace"});
        EXPECT_EQ(refused.exit, 2) << refused.out;
        return refused.err;
    };
    EXPECT_THAT(changed("const paces=3"), HasSubstr("error[RC-L04]: the log is about a model with paces=3"));
    EXPECT_THAT(changed("const pace 3"), HasSubstr("error[RC-L01]: expected `const NAME=VALUE`"));
    EXPECT_THAT(changed("const pace="), HasSubstr("error[RC-L01]"));
    EXPECT_THAT(changed("const pace=-1"), HasSubstr("error[RC-L04]"));
}

/// `--const` overrides the value in the log. It is an error to give a constant twice.
TEST(KindsOfRobots, LogsGiveWayToTheCommandLine) {
    const Folder folder({{"leader.rct", leader},
                         {"three.trace", "robochart-trace 1\ncomponent lead::Leader\n" + std::string(4000, '\n') +
                                             "const pace=3\nrun a\nback! tock\ntock\ntock\nhalt! tock\n"}});
    const auto compared = [&](std::vector<std::string> more) {
        std::vector<std::string> words{"conform", folder / "leader.rct", "--traces", folder / "three.trace"};
        words.insert(words.end(), more.begin(), more.end());
        return run(words);
    };
    const Ran own = compared({});
    EXPECT_EQ(own.exit, 0) << "the constant is read wherever in the header it stands: " << own.out << own.err;
    EXPECT_EQ(compared({"--const", "pace=3"}).exit, 0);
    const Ran other = compared({"--const", "pace=5", "--html", folder / "page.html"});
    EXPECT_EQ(other.exit, 1) << other.out << other.err;
    EXPECT_THAT(read_contents(folder / "page.html"), HasSubstr("cycle 4 cannot be followed"))
        << "it is stepped through";
    // `pace` means the constant of both the controller and the machine.
    for (const char* name : {"Leader::pace", "lead::Leader::pace"}) {
        const Ran part = compared({"--const", std::string(name) + "=5"});
        EXPECT_EQ(part.exit, 2) << part.out;
        EXPECT_THAT(part.err, HasSubstr(std::string("--const ") + name + " and --const pace both name"));
    }
    const Ran both = compared({"--const", "Leader::pace=5", "--const", "pace=3"});
    EXPECT_EQ(both.exit, 4);
    EXPECT_THAT(both.err, HasSubstr("error[RC-S24]: --const Leader::pace and --const pace both name the constant "
                                    "lead::Leader::pace"));
    EXPECT_THAT(compared({"--const", "pace=5", "--const", "pace=3"}).err, HasSubstr("--const pace is given twice"));
}

/// Returns a scenario with a single kind, which drives back 1 cm in each time unit, for `pace` time units.
std::string alone(const std::string& constant, const std::string& items) {
    return "scenario Alone for lead::Leader {\n\tstep 0.1 s physics 0.01 s unit 0.1 s duration 3 s trials 1 seed 1\n"
           "\tarena 400 cm by 400 cm\n\tlight goal at (-10 cm, 0 cm)\n\trobots 1 leaders { radius 3 cm axle 5 cm "
           "wheel 10 cm/s " +
           constant +
           "\n\t\tplace at (0 cm, 0 cm) heading 0 deg }\n\tactuator motors is differential_drive\n"
           "\tdrive motors by forward(-10 cm/s) on back\n\tdrive motors by stop on halt\n"
           "\tmeasure way is distance(goal)\n\t" +
           items + "\n}\n";
}

/// Every spelling of a constant overrides the value in the scenario, in sweeps, in searches and in certificates.
TEST(KindsOfRobots, NoConstantHasTwoNamesOfWhichOneDecides) {
    const std::string accept_claim = "accept probability way <= 0.5 cm at end >= 90 % with confidence 90 %";
    const Folder folder(
        {{"leader.rct", leader},
         {"sweep.scenario", alone("const pace = 3", accept_claim + " vary const Leader::pace in 3, 10")},
         {"same.scenario", alone("const pace = 3", accept_claim + " vary const pace in 3, 10")},
         {"twice.scenario", alone("", accept_claim + " vary const pace in 3, 10 vary const leaders.pace in 3, 10")},
         {"search.scenario", alone("const pace = 10", accept_claim)}});
    const auto swept = [&](const char* file) {
        return run({"simulate", folder / file, "--no-pictures", "--no-cache", "--format", "json"});
    };
    const auto points = nlohmann::json::parse(swept("same.scenario").out).at("points");
    EXPECT_EQ(points.at(0).at("claims").at(0).at("answer"), "refuted");
    EXPECT_EQ(points.at(1).at("claims").at(0).at("answer"), "proved");
    // `pace` means the constant of both the controller and the machine.
    const Ran other = swept("sweep.scenario");
    EXPECT_NE(other.exit, 0);
    EXPECT_THAT(other.out + other.err, HasSubstr("RC-S24"));
    const Ran twice = run({"simulate", folder / "twice.scenario"});
    EXPECT_EQ(twice.exit, 2);
    EXPECT_THAT(twice.err, HasSubstr("error[RC-M05]"));
    const auto tuned = [&](const std::vector<std::string>& more) {
        std::vector<std::string> words{
            "tune", folder / "search.scenario", "--budget", "40", "--format", "json", "--out", folder / "out"};
        words.insert(words.end(), more.begin(), more.end());
        return run(words);
    };
    for (const auto& more : {std::vector<std::string>{"--const", "Leader::pace=3,4"},
                             std::vector<std::string>{"--const", "Leader::pace=3,4", "--const", "pace=10"}}) {
        const Ran ran = tuned(more);
        EXPECT_EQ(ran.exit, 4) << ran.out;
        EXPECT_THAT(ran.out + ran.err, HasSubstr("RC-S24"));
    }
    EXPECT_EQ(tuned({"--const", "pace=3,4", "--const", "leaders.pace=10"}).exit, 4);
}

/// If warnings are denied and any model has one, the search does not start.
TEST(KindsOfRobots, NoSearchWhereWarningsAreDenied) {
    const Herd herd(claim);
    const Ran ran = run({"tune", herd / "herd/herd.scenario", "--const", "leaders.pace=2,10", "--deny-warnings"});
    EXPECT_EQ(ran.exit, 2) << ran.out << ran.err;
    EXPECT_THAT(ran.err, HasSubstr("warnings are denied"));
}

/// The robot reaches the goal after ten time units. After three time units it has moved 3 cm.
TEST(KindsOfRobots, TheirConstantsHaveTheKindsNameInFront) {
    const Herd herd(bands);
    const auto with = [&](const std::string& constant) { return herd.simulated({"--const", constant}); };
    EXPECT_EQ(with("leaders.pace=4").exit, 0) << "6 cm are left";
    EXPECT_EQ(with("leaders.pace=10").exit, 1);
    EXPECT_EQ(with("slow.pace=10").exit, 0);
    EXPECT_EQ(with("environment.delay=40").exit, 1) << "nobody runs by then";
    const auto refused = [&](const std::string& constant, int exit) {
        const Ran ran = with(constant);
        EXPECT_EQ(ran.exit, exit) << ran.err;
        return ran.err;
    };
    EXPECT_THAT(refused("leader.pace=4", 4), HasSubstr("no kind of robots called leader in the scenario, did you mean "
                                                       "leaders?"));
    EXPECT_THAT(refused("leaders.paces=4", 4), HasSubstr("error[RC-S10]: --const paces"));
    EXPECT_THAT(refused("pace=4", 4), HasSubstr("error[RC-S10]: --const pace")) << "that of the first kind";
}

TEST(KindsOfRobots, ASweepVariesThem) {
    const Herd herd(std::string(claim) + " vary const leaders.pace in 3, 10");
    const Ran ran = herd.simulated({"--format", "json", "--no-cache"});
    EXPECT_EQ(ran.exit, 0) << ran.out << ran.err;
    const auto json = nlohmann::json::parse(ran.out);
    ASSERT_EQ(json.at("points").size(), 2U);
    EXPECT_EQ(json.at("points")[0].at("claims")[0].at("answer"), "refuted");
    EXPECT_EQ(json.at("points")[1].at("claims")[0].at("answer"), "proved");
    const Ran wrong = Herd(std::string(claim) + " vary const leader.pace in 3, 10").simulated({});
    EXPECT_EQ(wrong.exit, 2);
    EXPECT_THAT(wrong.err, HasSubstr("error[RC-M06]: there is no kind of robots 'leader'"));
    const Ran unknown = Herd(std::string(claim) + " vary const leaders.paces in 3, 10").simulated({});
    EXPECT_EQ(unknown.exit, 2) << "it is the scenario that is wrong, not the command line";
    EXPECT_THAT(unknown.err, HasSubstr("error[RC-M06]: there is no constant of the model 'leaders.paces'"));
    EXPECT_THAT(unknown.err, HasSubstr("herd.scenario:"));
}

/// A certificate contains the files, constants and verdicts of all models, so it does not fit a changed model of the
/// leader.
TEST(KindsOfRobots, TuningCertifiesAllModels) {
    const Herd herd(claim);
    const std::string scenario = herd / "herd/herd.scenario";
    const Ran ran = run({"tune", scenario, "--const", "leaders.pace=2,10", "--budget", "40", "--out", herd / "out",
                         "--format", "json"});
    ASSERT_EQ(ran.exit, 0) << ran.out << ran.err;
    const auto certificate = nlohmann::json::parse(ran.out).at("certificate");
    const auto every = [&](const char* list, const char* field) {
        std::vector<std::string> values;
        for (const auto& entry : certificate.at(list)) values.push_back(entry.at(field));
        return values;
    };
    EXPECT_THAT(every("constants", "name"), ::testing::ElementsAre("leaders.pace", "slow.pace", "environment.delay"));
    EXPECT_THAT(every("constants", "value"), ::testing::ElementsAre("10", "5", "5"));
    EXPECT_THAT(every("model", "file"),
                ::testing::ElementsAre("sheep.assertions", "sheep.rct", "leaders: leader.assertions",
                                       "leaders: leader.rct", "slow: leader.assertions", "slow: leader.rct",
                                       "environment: sky.assertions", "environment: sky.rct"));
    EXPECT_THAT(every("conformance", "subject"), ::testing::ElementsAre("herd::Sheep", "leaders: lead::Leader",
                                                                        "slow: lead::Leader", "environment: sky::Sun"));
    EXPECT_THAT(every("conformance", "answer"), ::testing::Each("conforms"));
    EXPECT_THAT(every("assertions", "subject"),
                ::testing::Contains(HasSubstr("leaders: L1 [timed] lead::Backer::Standing is reachable")));
    const std::vector<std::string> verify{"tune", scenario, "--verify-certificate",
                                          herd / "out/tuning/Herd/certificate.json"};
    const Ran again = run(verify);
    EXPECT_EQ(again.exit, 0) << again.out << again.err;
    EXPECT_THAT(again.out, HasSubstr("the certificate says what is decided here"));
    EXPECT_EQ(diagnostics::replace_file(herd / "herd/sky/sky.rct", std::string(sun) + "// another\n"), "");
    const Ran other = run(verify);
    EXPECT_EQ(other.exit, 1) << other.err;
    EXPECT_THAT(other.out, HasSubstr("model: environment: sky.rct is not the one that is certified"));
    EXPECT_THAT(run({"tune", scenario, "--const", "leaders.pace=2,10", "--const", "sheep.pace=2"}).err,
                HasSubstr("RC-S10"));
}

/// The page shows the diagrams of the selected robot's kind, with its state marked, and hides the others.
TEST(KindsOfRobots, ThePageHasTheDiagramsOfEachKind) {
    const Herd herd(bands);
    const Ran ran = herd.simulated({"--html", herd / "page.html"});
    ASSERT_EQ(ran.exit, 0) << ran.out << ran.err;
    const std::string page = read_contents(herd / "page.html");
    const auto data =
        nlohmann::json::parse(texts_between(page, "<script type=\"application/json\" id=\"data\">", "</script>").at(0));
    EXPECT_EQ(data.at("kinds"), nlohmann::json::parse("[0, 2, 3]"));
    EXPECT_EQ(data.at("machines"), 2) << "the leaders have one more";
    EXPECT_THAT(page, HasSubstr("<figcaption>sheep: herd::Runner</figcaption>"));
    EXPECT_THAT(page, HasSubstr("<figcaption>leaders: lead::Idle</figcaption>"));
    EXPECT_THAT(page, HasSubstr("<figcaption>slow: lead::Backer</figcaption>"));
    // Each state of the first machine of each kind has an element in the diagram of its model.
    const auto& states = data.at("states")[0];
    EXPECT_EQ(states.at("names"), nlohmann::json::parse(R"(["sheep::Waiting", "sheep::Running", "leaders::Backing",
        "leaders::Standing", "slow::Backing", "slow::Standing"])"));
    ASSERT_EQ(states.at("elements").size(), 6U);
    const std::string figure = texts_between(page, "<figure data-machine=\"0\" data-kind=\"1\"", "</figure>").at(0);
    const std::string standing = all_matches(figure, "data-element=\"(e[0-9]+)\"><title>state Standing</title>").at(0);
    EXPECT_EQ(states.at("elements")[3], nlohmann::json::array({standing}));
    EXPECT_EQ(states.at("elements")[5], nlohmann::json::array({standing})) << "one model, one diagram";

    if (std::system("command -v chromium > /dev/null 2>&1") != 0) GTEST_SKIP() << "chromium is not on PATH";
    const Ran seen = run_shell(
        "timeout 200 chromium --headless --no-sandbox --disable-gpu --enable-logging=stderr "
        "--user-data-dir=profile --dump-dom \"file://" +
        (herd / "page.html") + "#trial/1/frame/6/robot/2\"");
    EXPECT_THAT(seen.err, Not(HasSubstr("CONSOLE")));
    EXPECT_THAT(seen.out, HasSubstr("robot 2 in leaders::Standing, leaders::Here"));
    EXPECT_THAT(texts_between(seen.out, "<figure data-machine=\"0\" data-kind=\"0\"", ">").at(0), HasSubstr("hidden"));
    const auto shown = texts_between(seen.out, "<figure data-machine=\"0\" data-kind=\"1\"", "</figure>").at(0);
    EXPECT_THAT(shown.substr(0, shown.find('>')), Not(HasSubstr("hidden")));
    EXPECT_THAT(all_matches(shown, "class=\"node on\"[^>]*><title>state ([A-Za-z]+)</title>"),
                ::testing::ElementsAre("Standing"));
}

}  // namespace
}  // namespace robochart::app::testing::kinds_test
