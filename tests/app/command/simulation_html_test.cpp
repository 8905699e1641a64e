// SPDX-License-Identifier: Apache-2.0
// Tests `simulate --html`: the page contains the positions and states of the tables, marks existing elements, and runs
// no code from the model.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "app/pages/trial_data.hpp"
#include "tests/app/command.hpp"
#include "tests/app/command/page.hpp"
#include "tests/contents.hpp"

namespace robochart::app::testing::simulation_html_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using tests::read_contents;

nlohmann::json data_of(const std::string& page) {
    const auto found = texts_between(page, "<script type=\"application/json\" id=\"data\">", "</script>");
    EXPECT_EQ(found.size(), 1U);
    return found.empty() ? nlohmann::json() : nlohmann::json::parse(found.front());
}

std::size_t number(const std::string& letters, std::size_t at) {
    const std::string alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";
    return 64 * alphabet.find(letters.at(at)) + alphabet.find(letters.at(at + 1));
}

struct Row {
    double x = 0, y = 0, heading = 0;
    std::string state;
};

/// Returns the rows of a table of positions, by time and robot.
std::map<std::pair<std::string, std::size_t>, Row> rows_of(const std::string& csv) {
    std::map<std::pair<std::string, std::size_t>, Row> rows;
    std::istringstream lines(csv);
    std::string line;
    std::getline(lines, line);
    while (std::getline(lines, line)) {
        std::istringstream cells(line + ",");
        std::vector<std::string> values;
        for (std::string cell; std::getline(cells, cell, ',');) values.push_back(cell);
        rows[{values.at(0), std::stoul(values.at(1))}] = {std::stod(values.at(2)), std::stod(values.at(3)),
                                                          std::stod(values.at(4)), values.at(5)};
    }
    return rows;
}

TEST(SimulationHtml, FramesAreThoseOfTheTables) {
    const Folder folder;
    const Ran ran = run({"simulate", repository("corpus/swarm_taxis/swarm_taxis.scenario"), "--trials", "2", "--out",
                         folder.path(), "--html", folder / "page.html"});
    const std::string page = read_contents(folder / "page.html");
    const nlohmann::json data = data_of(page);
    ASSERT_EQ(data["trials"].size(), 2U) << ran.err;
    EXPECT_EQ(data["robots"], 20);
    const double width = data["view"][2];
    EXPECT_EQ(width, 400) << "the arena";
    const auto& names = data["states"][0]["names"];
    std::size_t robots = 0;
    for (std::size_t t = 0; t < 2; ++t) {
        const auto rows = rows_of(read_contents(folder / fmt::format("simulation/SwarmTaxis/trial-0{}.csv", t + 1)));
        const auto& trial = data["trials"][t];
        ASSERT_EQ(trial["times"].size(), trial["frames"].size());
        EXPECT_EQ(trial["times"].back(), 400);
        for (std::size_t f = 0; f < trial["frames"].size(); ++f)
            for (std::size_t r = 0; r < 20; ++r, ++robots) {
                const std::string letters = trial["frames"][f].get<std::string>().substr(8 * r, 8);
                const Row& row = rows.at({fmt::format("{:.3f}", trial["times"][f].get<double>()), r});
                ASSERT_NEAR(width * static_cast<double>(number(letters, 0)) / 4095 - 200, row.x, width / 4095);
                ASSERT_NEAR(200 - width * static_cast<double>(number(letters, 2)) / 4095, row.y, width / 4095);
                const double turn = 2 * M_PI * static_cast<double>(number(letters, 4)) / 4096;
                ASSERT_NEAR(std::cos(turn), std::cos(row.heading), 0.002);
                ASSERT_NEAR(std::sin(turn), std::sin(row.heading), 0.002);
                const std::size_t state = number(letters, 6);
                ASSERT_EQ(state < names.size() ? names[state] : nlohmann::json(""), row.state);
            }
    }
    EXPECT_EQ(robots, 2U * 401 * 20) << "every recorded time";
}

constexpr const char* two_machines = R"(
package p
interface Events { event go }
robotic platform Body { uses Events }
stm Stays { initial i state Here { } transition t0 { from i to Here } }
stm Goes {
	uses Events
	initial i
	state Waiting { }
	state Going { initial j state Fast { } transition u0 { from j to Fast } }
	transition t0 { from i to Waiting }
	transition t1 { from Waiting to Going trigger go }
}
controller Brain {
	uses Events
	sref stays = Stays
	sref goes = Goes
	connection Brain on go to goes on go
}
module Robot {
	rref body = Body
	cref brain = Brain
	connection body on go to brain on go (_async)
}
)";

std::string scenario_of(const std::string& component, const std::string& more) {
    return "scenario World for " + component +
           " { step 0.1 s physics 0.01 s unit 0.1 s duration 1 s trials 1 arena 100 cm by 100 cm\n"
           "robots 1 { place at (0 cm, 0 cm) heading 0 deg }\n"
           "measure s is spread accept each s <= 1 cm record 0.1 s\n" +
           more + " }";
}

TEST(SimulationHtml, MarksTheStatesAroundTheActiveOne) {
    const Folder folder({{"m.rct", two_machines}, {"w.scenario", scenario_of("p::Robot", "stimulus go at 0.3 s")}});
    const Ran ran = run({"simulate", folder / "w.scenario", "--no-pictures", "--html", folder / "page.html"});
    EXPECT_EQ(ran.exit, 0) << ran.out << ran.err;
    const std::string page = read_contents(folder / "page.html");
    const nlohmann::json data = data_of(page);
    EXPECT_EQ(data["machines"], 2);
    ASSERT_EQ(data["states"].size(), 2U);
    const auto& goes = data["states"][1];
    ASSERT_THAT(goes["names"].get<std::vector<std::string>>(), ElementsAre("Waiting", "Going", "Going::Fast"));
    const std::string figure = texts_between(page, "<figure data-machine=\"1\"", "</figure>").at(0);
    const auto id_of = [&](const std::string& name) {
        return all_matches(figure, "data-element=\"(e[0-9]+)\"><title>state " + name + "</title>").at(0);
    };
    EXPECT_THAT(goes["elements"][0].get<std::vector<std::string>>(), ElementsAre(id_of("Waiting")));
    EXPECT_THAT(goes["elements"][2].get<std::vector<std::string>>(), ElementsAre(id_of("Fast"), id_of("Going")));
    // The first six letters are x, y and heading. After them, each machine has two letters: the first machine is in its
    // only state. The second machine waits, and is later in its third state.
    EXPECT_EQ(data["trials"][0]["frames"][2].get<std::string>().substr(6), "AAAA");
    EXPECT_EQ(data["trials"][0]["frames"][10].get<std::string>().substr(6), "AAAC");
}

TEST(SimulationHtml, LetsNothingInButItsStylesAndItsScript) {
    const Folder folder;
    for (const std::string study : {"aggregation", "swarm_taxis"}) {
        const Ran ran = run({"simulate", repository("corpus/" + study + "/" + study + ".scenario"), "--no-pictures",
                             "--html", folder / "page.html"});
        EXPECT_EQ(ran.exit, 0) << ran.err;
        const std::string page = read_contents(folder / "page.html");
        expect_closed(page);
        EXPECT_LT(page.size(), 1'000'000U) << study;
        EXPECT_THAT(page, HasSubstr("7 of 7 bands hold"));
    }
}

// A loop without time stops the controller. The message names the place of the loop, which contains the name of the
// file.
TEST(SimulationHtml, NothingOfTheModelActsAndStopsAreShown) {
    const std::string evil = "<img src=x onerror=alert(1)>\"'";
    const Folder folder(
        {{evil + ".rct",
          "package p robotic platform B { uses E } interface E { event e } stm S { uses E initial i state A { } "
          "transition t0 { from i to A } transition t1 { from A to A } }"},
         {"w.scenario", scenario_of("p::S", "light lamp at (1 cm, 2 cm)")}});
    const Ran ran = run({"simulate", folder / "w.scenario", "--out", folder / evil, "--html", folder / "page.html"});
    EXPECT_EQ(ran.exit, 1) << ran.out << ran.err;
    const std::string page = read_contents(folder / "page.html");
    EXPECT_THAT(page, Not(HasSubstr("<img")));
    EXPECT_THAT(page, HasSubstr("&lt;img src=x"));
    EXPECT_THAT(page, HasSubstr("a controller stopped in 1 trial"));
    EXPECT_EQ(data_of(page)["trials"][0]["stop"]["robot"], 0);
    expect_closed(page);
}

TEST(SimulationHtml, ThatCannotBeWrittenIsAnError) {
    const Ran ran = run({"simulate", repository("corpus/aggregation/aggregation.scenario"), "--trials", "1",
                         "--no-pictures", "--html", "/proc/page.html"});
    EXPECT_EQ(ran.exit, 2);
    EXPECT_THAT(ran.err, HasSubstr("/proc/page.html"));
}

// 65 is 1 * 64 + 1.
TEST(TrialData, NumbersAreTwoLetters) {
    EXPECT_EQ(two_letters(0), "AA");
    EXPECT_EQ(two_letters(65), "BB");
    EXPECT_EQ(two_letters(4095), "__");
}

TEST(TrialData, AFrameHasPlaceHeadingAndStates) {
    const simulation::View view{-100, -50, 4095, 4095};
    const simulation::Frame frame{0, {{{-35, -15}, M_PI / 2}, {{9999, 50}, -M_PI / 2}}, {1, 65, 2, 0}, {}};
    // The first robot is 65 from the left. It is 15 below y = 0, and so 65 below the top. A quarter turn is a quarter
    // of 4096, which is 16 * 64.
    EXPECT_EQ(frame_letters(view, frame, 2, 2),
              "BBBBQAABBB"
              "__AAwAACAA")
        << "what is outside is at the edge";
    EXPECT_EQ(frame_letters(view, frame, 1, 2), "BBBBQAABBB");
}

simulation::RunResult run_of(std::size_t trials, std::size_t frames) {
    simulation::RunResult result;
    result.trials.resize(trials);
    for (auto& trial : result.trials) trial.frames.resize(frames);
    return result;
}

TEST(TrialData, ShowsWhatFits) {
    simulation::Scenario scenario;
    scenario.robots = 10;
    // With ten robots of one machine, a frame needs 80 letters, so 100 frames of 4 trials fit into 32,000 letters.
    const ShownTrials all = shown_trials(scenario, run_of(4, 100), 1, 32'000);
    EXPECT_THAT(all.trials, ElementsAre(0, 1, 2, 3));
    EXPECT_EQ(all.every, 1U);
    EXPECT_EQ(all.robots, 10U);
    simulation::RunResult stopped = run_of(4, 100);
    stopped.trials[2].stop = simulation::Stop{};
    const ShownTrials few = shown_trials(scenario, stopped, 1, 20'000);
    EXPECT_THAT(few.trials, ElementsAre(0, 2)) << "the one that stopped, and the first";
    EXPECT_EQ(few.every, 1U);
    const ShownTrials thin = shown_trials(scenario, run_of(1, 1000), 1, 20'000);
    EXPECT_EQ(thin.every, 5U) << "at most 250 of 1000 frames, and the last";
    scenario.robots = 5000;
    EXPECT_EQ(shown_trials(scenario, run_of(1, 10), 1, 20'000).robots, 1000U);
}

/// Loads the page in a browser without the page's policy, and runs a script that acts as a reader. The animation uses a
/// timer, and the browser's virtual time advances immediately.
std::string acted(const std::string& script) {
    return "sed -e 's|<meta http-equiv[^>]*>|<script>requestAnimationFrame = (draw) => setTimeout(() => "
           "draw(performance.now()), 20); cancelAnimationFrame = clearTimeout;</script>|' -e 's|</body>|<script>" +
           script +
           "</script></body>|' page.html > acted.html; timeout 200 chromium --headless --no-sandbox --disable-gpu "
           "--enable-logging=stderr --user-data-dir=profile --virtual-time-budget=4000 --dump-dom "
           "\"file://$PWD/acted.html\"";
}

std::string simulated() {
    return "\"$verify\" simulate " + repository("corpus/aggregation/aggregation.scenario") +
           " --trials 2 --html page.html > out.txt; cp out/simulation/Aggregation/trial-02.csv . ; ";
}

// The address selects a time and a robot. The page shows them, with the robot's place and active state from the table.
TEST(SimulationHtml, ShowsTheTimeInTheAddress) {
    if (std::system("command -v chromium > /dev/null 2>&1") != 0) GTEST_SKIP() << "chromium is not on PATH";
    const Ran ran = run_shell(simulated() +
                              "timeout 200 chromium --headless --no-sandbox --disable-gpu --enable-logging=stderr "
                              "--user-data-dir=profile --dump-dom \"file://$PWD/page.html#trial/2/frame/40/robot/3\"; "
                              "grep '^20.000,3,' trial-02.csv");
    EXPECT_THAT(ran.err, Not(HasSubstr("CONSOLE"))) << "neither an error nor a request that the policy forbids";
    const std::string line = ran.out.substr(ran.out.rfind("20.000,3,"));
    const Row row = rows_of("\n" + line).at({"20.000", 3});
    EXPECT_THAT(ran.out, HasSubstr("trial 2, 20.0 s: robot 3 in " + row.state.substr(0, 2)));
    const std::string robot = all_matches(ran.out, "data-robot=\"3\"[^>]*transform=\"([^\"]*)\"").at(0);
    double x = 0, y = 0;
    ASSERT_EQ(std::sscanf(robot.c_str(), "translate(%lf %lf)", &x, &y), 2) << robot;
    EXPECT_NEAR(x, row.x, 250.0 / 4095);
    EXPECT_NEAR(-y, row.y, 250.0 / 4095);
    const std::string figure = texts_between(ran.out, "<figure data-machine=\"0\"", "</figure>").at(0);
    EXPECT_THAT(all_matches(figure, "class=\"node on\"[^>]*><title>state (S[12])</title>"),
                ElementsAre(row.state.substr(0, 2)));
}

TEST(SimulationHtml, TheSliderMovesTheRobots) {
    if (std::system("command -v chromium > /dev/null 2>&1") != 0) GTEST_SKIP() << "chromium is not on PATH";
    const Ran ran =
        run_shell(simulated() +
                  acted("const slider = document.getElementById(\"time\"), before = [], after = [];"
                        "const places = (list) => { for (const robot of document.querySelectorAll(\".sim-robot\")) "
                        "list.push(robot.getAttribute(\"transform\")); };"
                        "places(before); slider.value = 0; slider.dispatchEvent(new Event(\"input\")); places(after);"
                        "document.title = \"moved \" + before.filter((place, i) => place !== after[i]).length;"));
    EXPECT_THAT(ran.out, HasSubstr("<title>moved 20</title>")) << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("0.0 s: robot 0 in between states"));
    EXPECT_THAT(ran.err, Not(HasSubstr("CONSOLE")));
}

TEST(SimulationHtml, KeysGoFromTimeToTimeAndFromRobotToRobot) {
    if (std::system("command -v chromium > /dev/null 2>&1") != 0) GTEST_SKIP() << "chromium is not on PATH";
    const Ran ran =
        run_shell(simulated() +
                  acted("for (const key of [\"Home\", \"ArrowRight\", \"ArrowRight\", \"k\", \"]\", \"]\", \"[\"]) "
                        "document.body.dispatchEvent(new KeyboardEvent(\"keydown\", { key: key, bubbles: true }));"));
    EXPECT_THAT(ran.out, HasSubstr("trial 1, 0.5 s: robot 1 in S")) << ran.err;
    EXPECT_THAT(ran.err, Not(HasSubstr("CONSOLE")));
}

// The animation runs at ten times the speed of the world. If it is paused, the robots stop at a recorded time.
TEST(SimulationHtml, PlaysAndPauses) {
    if (std::system("command -v chromium > /dev/null 2>&1") != 0) GTEST_SKIP() << "chromium is not on PATH";
    const Ran ran = run_shell(simulated() + acted("const play = document.getElementById(\"play\"); play.click();"
                                                  "setTimeout(() => { const word = play.textContent; play.click(); "
                                                  "document.title = word + \", then \" + play.textContent; }, 1500);"));
    EXPECT_THAT(ran.out, HasSubstr("<title>pause, then play</title>")) << ran.err;
    const auto times = all_matches(ran.out, "trial 1, ([0-9.]+) s: robot 0");
    ASSERT_EQ(times.size(), 1U);
    const double time = std::stod(times.front());
    EXPECT_GT(time, 10);
    EXPECT_LT(time, 20);
    EXPECT_EQ(std::fmod(time, 0.5), 0) << "the scenario records every half second";
    EXPECT_THAT(ran.err, Not(HasSubstr("CONSOLE")));
}

}  // namespace
}  // namespace robochart::app::testing::simulation_html_test
