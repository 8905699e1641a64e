// SPDX-License-Identifier: Apache-2.0
// Tests `check --swarm`: the robot of each step, claims by name, undecided claims.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/app/command.hpp"

namespace robochart::app::testing::swarm_test {
namespace {

using nlohmann::json;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;

/// Each robot sends its number and then waits for another robot's number, or sends its own again.
const char* const talkers = R"(
interface Radio { event say : nat event hear : nat }
robotic platform Body { uses Radio }
stm Talker {
    uses Radio
    const id : nat
    var other : nat = 0
    initial i
    state Saying { }
    state Waiting { }
    transition begin { from i to Saying }
    transition says { from Saying to Waiting action send say!id }
    transition hears { from Waiting to Saying trigger hear?other }
    transition again { from Waiting to Saying }
}
controller Brain {
    uses Radio
    sref talker = Talker
    connection talker on say to Brain on say
    connection Brain on hear to talker on hear
}
module Robot {
    rref body = Body
    cref brain = Brain
    connection brain on say to body on say (_async)
    connection body on hear to brain on hear (_async)
}
)";

const char* const talk =
    "swarm Talk for Robot { robots 2 grid 5 by 5 place at (0, 0) heading 0 deg const id = robot range nat = 0 to 3 "
    "connect say to hear accept always linked(1) accept possible linked(1) }";

Folder talking() {
    return Folder({{"m/talkers.rct", talkers}, {"talk.swarm", talk}});
}

/// The robots can talk indefinitely within the first time unit, so no later time is decided.
TEST(SwarmCommand, WhereTimeCanStopNothingIsDecided) {
    const Folder folder = talking();
    const Ran ran = run({"check", folder / "m", "--swarm", folder / "talk.swarm"});
    EXPECT_EQ(ran.exit, 3) << ran.out << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("not decided: time can stop"));
    EXPECT_THAT(ran.out, HasSubstr("from here on no time passes"));
}

TEST(SwarmCommand, ClaimsHaveNames) {
    const Folder folder = talking();
    const Ran one = run({"check", folder / "m", "--swarm", folder / "talk.swarm", "--assertion", "possible linked(1)"});
    EXPECT_EQ(one.exit, 0) << one.out << one.err;
    EXPECT_THAT(one.out, HasSubstr("possible linked(1)"));
    EXPECT_THAT(one.out, Not(HasSubstr("always linked(1)")));
    const Ran none =
        run({"check", folder / "m", "--swarm", folder / "talk.swarm", "--assertion", "possible linked(2)"});
    EXPECT_EQ(none.exit, 4) << none.out << none.err;
    EXPECT_THAT(none.err, HasSubstr("did you mean 'possible linked(1)'?"));
}

/// Two robots of corpus/alpha drive apart. Each event with a robot's number is a step of that robot, and each step
/// shows the states of both robots.
TEST(SwarmCommand, StepsSayWhichRobot) {
    const std::vector<std::pair<std::string, std::string>> files{
        {"apart.swarm",
         "swarm Apart for alpha::Robot { robots 2 grid 5 by 5 place at (0, 0) heading 0 deg place at (0, 0) heading "
         "180 deg const alpha = 1 const cadence = 1 range nat = 0 to 4 drive by forward on moveForward drive by "
         "turn(deg) on startTurning feed turned with turned feed neighbours with count(1) on countNeighbours accept "
         "always linked(1) }"}};
    const Folder folder(files);
    const std::vector<std::string> command{
        "check", repository("corpus/alpha"), "--swarm", folder / "apart.swarm", "--allow", "RC-S17"};
    const Ran text = run(command);
    EXPECT_EQ(text.exit, 1) << text.out << text.err;
    EXPECT_THAT(text.out, HasSubstr("of robot 0"));
    EXPECT_THAT(text.out, HasSubstr("of robot 1"));
    EXPECT_THAT(text.out, HasSubstr("drives one cell"));
    EXPECT_THAT(text.out, HasSubstr("why here the condition does not hold"));
    std::vector<std::string> with_json = command;
    with_json.insert(with_json.end(), {"--format", "json"});
    const json found = json::parse(run(with_json).out).at("assertions").at(0).at("counterexample");
    const json& events = found.at("events");
    std::size_t numbered = 0;
    for (const json& step : found.at("steps")) {
        std::size_t robots = 0;
        for (const json& machine : step.at("machines")) {
            const std::string component = machine.at("component");
            for (const char* ending : {"of robot 0", "of robot 1"}) robots += component.ends_with(ending) ? 1U : 0U;
        }
        EXPECT_EQ(robots, step.at("machines").size());
        if (!step.contains("component") || step.at("raw") >= events.size()) continue;
        const std::string event = events.at(step.at("raw").get<std::size_t>());
        for (const char* robot : {"0", "1"})
            if (event.find(std::string("operation_1.") + robot) != std::string::npos) {
                EXPECT_THAT(step.at("component").get<std::string>(), EndsWith(std::string("of robot ") + robot));
                ++numbered;
            }
    }
    EXPECT_GE(numbered, 2U);
}

}  // namespace
}  // namespace robochart::app::testing::swarm_test
