// SPDX-License-Identifier: Apache-2.0
// Tests swarms of generated robots. Some verdicts follow from the rules of the grid, others from a separate search that
// does not use CSP.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <vector>

#include "base/diagnostics/render.hpp"
#include "checker/cspm/session.hpp"
#include "checker/cspm/syntax/reader.hpp"
#include "checker/cspm/types/type_check.hpp"
#include "checker/refine/verdict/recurrence.hpp"
#include "csp_emit/emit.hpp"
#include "csp_emit/swarm/compose.hpp"
#include "csp_emit/swarm/read_swarm.hpp"
#include "frontend/project/project.hpp"
#include "semantics/instantiate/instantiate.hpp"
#include "semantics/lower/lower.hpp"
#include "tests/contents.hpp"
#include "tests/shared_folder.hpp"
#include "tests/source_folder.hpp"
#include "tests/temporary_folder.hpp"

namespace robochart::csp_emit {
namespace {

namespace fs = std::filesystem;

struct Decided {
    std::vector<std::string> verdicts;  ///< "holds", "fails", or an error
    std::vector<std::uint64_t> states;
    std::string findings;
};

refine::Limits with_reduction() {
    refine::Limits limits;
    limits.reduction = true;
    limits.threads = 1;
    return limits;
}

const char* outcome_word(refine::Outcome outcome) {
    switch (outcome) {
        case refine::Outcome::holds:
            return "holds";
        case refine::Outcome::fails:
            return "fails";
        case refine::Outcome::inconclusive:
            break;
    }
    return "open";
}

refine::Verdict decide(cspm::Session& session, const std::vector<cspm::DeclPtr>& assertions,
                       const std::optional<RecurrenceQuestion>& recurrence) {
    refine::Verdict verdict;
    for (const cspm::DeclPtr& assertion : assertions) {
        verdict = session.check(*assertion, with_reduction()).verdict;
        if (verdict.outcome != refine::Outcome::holds) return verdict;
    }
    if (!recurrence) return verdict;
    return refine::recurrent(*session.system(recurrence->process), session.events(recurrence->goal), with_reduction());
}

/// Decides the obligation. If a claim would hold but its premise does not, the outcome is inconclusive, which the tests
/// call "open".
refine::Verdict decide(cspm::Session& session, const Obligation& obligation) {
    refine::Verdict verdict = decide(session, obligation.assertions, obligation.recurrence);
    if (verdict.outcome != refine::Outcome::holds || obligation.premise == nullptr) return verdict;
    const Premise& premise = *obligation.premise;
    if (decide(session, premise.assertions, premise.recurrence).outcome != refine::Outcome::holds)
        verdict.outcome = refine::Outcome::inconclusive;
    return verdict;
}

/// Decides the claims of a swarm of the model in this folder or file.
Decided decide_swarm(const std::string& path, const std::string& text, Time time = Time::timed, SwarmSize size = {}) {
    Decided result;
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics found;
    const auto finish = [&] {
        result.findings = diagnostics::render_text(sources, found);
        return result;
    };
    const auto parsed = frontend::load_project(sources, path, found);
    if (!found.ok()) return finish();
    const ir::System system = ir::lower(*parsed, sources, found);
    const Swarm swarm = read_swarm(sources, sources.add("test.swarm", text), found, size);
    if (!found.ok()) return finish();
    ir::InstantiationOptions options;
    for (const SwarmConstant& constant : swarm.constants)
        if (!constant.value.empty()) options.constants[constant.name.text] = constant.value;
    for (const SwarmRange& range : swarm.ranges) options.ranges[range.type.text] = {range.low, range.high};
    const ir::Instantiation instantiation = ir::instantiate_system(system, options, found);
    Emission emission = emit(system, instantiation, time, {}, sources, found);
    make_swarm(emission, swarm, time, system, instantiation, sources, found);
    if (found.ok()) (void)cspm::check_types(emission.script, found);
    if (!found.ok()) return finish();
    cspm::Session session(emission.script);
    for (const Obligation& obligation : emission.obligations) {
        try {
            const refine::Verdict verdict = decide(session, obligation);
            result.verdicts.emplace_back(outcome_word(verdict.outcome));
            result.states.push_back(verdict.statistics.states);
        } catch (const cspm::EvaluationError& error) {
            result.verdicts.push_back(std::string("error: ") + error.what());
        }
    }
    return finish();
}

/// Decides the claims of a swarm of the model with this text.
Decided decide_swarm_of(const std::string& model, const std::string& swarm, Time time = Time::timed,
                        SwarmSize size = {}) {
    const tests::TemporaryFolder folder;
    folder.write("model.rct", model);
    return decide_swarm(folder.path(), swarm, time, size);
}

std::string alpha_folder() {
    return (tests::source_folder() / "corpus/alpha").string();
}

std::string swarm_of_alpha(const std::string& size, const std::string& claims) {
    return "swarm Alpha for alpha::Robot {" + size +
           " const alpha = 1 const cadence = 1 range nat = 0 to 4 drive by forward on moveForward drive by turn(deg) "
           "on "
           "startTurning feed turned with turned feed neighbours with count(1) on countNeighbours " +
           claims + " }";
}

using Verdicts = std::vector<std::string>;

/// On a torus of three by three cells all robots are always adjacent, because diagonal steps count as one. No robot is
/// ever lost or turns, and two robots that start with the same heading stay in one cell.
TEST(Swarm, WhoCannotGetAwayIsNeverLost) {
    const Decided found = decide_swarm(
        alpha_folder(), swarm_of_alpha("robots 2 grid 3 by 3 place at (0, 0) heading 0 deg",
                                       "accept deadlock free accept always linked(1) accept recurrent linked(1) "
                                       "accept possible apart accept always not apart accept possible away(1)"));
    ASSERT_EQ(found.findings.find("error["), std::string::npos) << found.findings;
    EXPECT_EQ(found.verdicts, (Verdicts{"holds", "holds", "holds", "fails", "holds", "holds"}));
}

/// Two robots drive apart, one to the east and one to the west. Their distance grows by two cells with each step, so on
/// a torus of five columns they lose each other immediately.
TEST(Swarm, WhoDrivesApartIsLost) {
    const Decided found =
        decide_swarm(alpha_folder(), swarm_of_alpha("robots 2 grid 5 by 5 place at (0, 0) heading 0 deg "
                                                    "place at (0, 0) heading 180 deg",
                                                    "accept always linked(1) accept possible not linked(1)"));
    ASSERT_EQ(found.findings.find("error["), std::string::npos) << found.findings;
    EXPECT_EQ(found.verdicts, (Verdicts{"fails", "holds"}));
}

// ---------------------------------------------------------------- two robots by another search

/// An independent implementation of the machine of corpus/alpha with cadence 1. In each time unit all driving robots
/// move one cell. Then each robot, in any order, takes the steps of its machine until the machine waits for time to
/// pass.
struct Robot {
    int heading = 0;  // 0 east, 1 north, 2 west, 3 south
    int doing = 0;    // 0: stopped, 1: driving, 2: turning
    int control = 0;  // 0: in Forward, before the next count; 1: in Coherence; 2: in TurningBack; 3: in Turning
    int before = 0;   // the last count
    auto operator<=>(const Robot&) const = default;
};
struct World {
    std::array<Robot, 2> robots;
    int x = 0, y = 0;  // position of the second robot relative to the first
    auto operator<=>(const World&) const = default;
};

constexpr int columns = 5;

bool are_near(const World& world) {
    const auto apart = [](int offset) { return std::min(offset, columns - offset); };
    return apart(world.x) <= 1 && apart(world.y) <= 1;
}

/// Returns the states in which a robot may be after its time unit.
std::vector<Robot> next_states(Robot robot, int heard) {
    std::vector<Robot> result;
    if (robot.control >= 2) {  // the turn is finished, and the robot continues to drive
        robot.control = robot.control == 2 ? 1 : 0;
        robot.doing = 1;
        return {robot};
    }
    const bool fewer = heard < robot.before && heard < 1;
    const bool more = heard > robot.before;
    const bool forward = robot.control == 0;
    robot.before = heard;
    if (fewer) {
        robot.heading = (robot.heading + 2) % 4;
        robot.doing = 2;
        robot.control = 2;
        return {robot};
    }
    if (!forward && more) {
        for (int turn = 0; turn < 4; ++turn) {
            Robot turned = robot;
            turned.heading = (robot.heading + turn) % 4;
            turned.doing = 2;
            turned.control = 3;
            result.push_back(turned);
        }
        return result;
    }
    robot.doing = 1;
    return {robot};
}

std::vector<World> next_states(World world) {
    constexpr std::array<int, 4> along_x{1, 0, -1, 0};
    constexpr std::array<int, 4> along_y{0, 1, 0, -1};
    for (int i = 0; i < 2; ++i) {
        Robot& robot = world.robots[static_cast<std::size_t>(i)];
        if (robot.doing == 2) robot.doing = 0;
        if (robot.doing != 1) continue;
        const auto heading = static_cast<std::size_t>(robot.heading);
        const int away = i == 0 ? -1 : 1;
        world.x = (world.x + away * along_x[heading] + columns) % columns;
        world.y = (world.y + away * along_y[heading] + columns) % columns;
    }
    const int heard = are_near(world) ? 1 : 0;
    std::vector<World> result;
    for (const Robot& first : next_states(world.robots[0], heard))
        for (const Robot& second : next_states(world.robots[1], heard))
            result.push_back({{first, second}, world.x, world.y});
    return result;
}

/// Returns whether the two robots can meet again from every reachable state.
bool can_always_come_together() {
    std::map<World, std::vector<World>> into;
    std::set<World> found;
    std::vector<World> waiting;
    for (int a = 0; a < 4; ++a)
        for (int b = 0; b < 4; ++b) waiting.push_back({{Robot{a, 1}, Robot{b, 1}}, 0, 0});
    found.insert(waiting.begin(), waiting.end());
    while (!waiting.empty()) {
        const World world = waiting.back();
        waiting.pop_back();
        for (const World& next : next_states(world)) {
            into[next].push_back(world);
            if (found.insert(next).second) waiting.push_back(next);
        }
    }
    std::set<World> good;
    for (const World& world : found)
        if (are_near(world)) {
            good.insert(world);
            waiting.push_back(world);
        }
    while (!waiting.empty()) {
        const World world = waiting.back();
        waiting.pop_back();
        for (const World& before : into[world])
            if (good.insert(before).second) waiting.push_back(before);
    }
    return good.size() == found.size();
}

TEST(Swarm, RecurrenceIsThatOfAnotherSearch) {
    const Decided found =
        decide_swarm(alpha_folder(),
                     swarm_of_alpha("robots 2 grid 5 by 5 place at (0, 0) heading any", "accept recurrent linked(1)"));
    ASSERT_EQ(found.findings.find("error["), std::string::npos) << found.findings;
    EXPECT_EQ(found.verdicts, (Verdicts{can_always_come_together() ? "holds" : "fails"}));
}

// ---------------------------------------------------------------- messages

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

/// Without a receiver, a message waits forever. With other robots it is sent, whether or not they listen.
TEST(Swarm, MessagesNeedOthers) {
    const std::string swarm =
        "swarm Talk for Robot { const id = robot range nat = 0 to 3 connect say to hear accept deadlock free }";
    for (const std::uint32_t robots : {1U, 2U, 3U})
        for (const Time time : {Time::untimed, Time::timed}) {
            const Decided found = decide_swarm_of(talkers, swarm, time, {robots, {}});
            ASSERT_EQ(found.findings.find("error["), std::string::npos) << found.findings;
            const char* const several = time == Time::untimed ? "holds" : "open";  // they send, so time stops
            EXPECT_EQ(found.verdicts, (Verdicts{robots == 1 ? "fails" : several})) << robots;
        }
}

// ---------------------------------------------------------------- time stops

/// The robots exchange messages indefinitely within the first time unit, in which no robot has moved.
TEST(Swarm, TalkForEverLeavesNoTime) {
    const Decided found =
        decide_swarm_of(talkers,
                        "swarm Talk for Robot { robots 2 grid 5 by 5 place at (0, 0) heading 0 deg const id "
                        "= robot range nat = 0 to 3 connect say to hear accept always linked(1) accept "
                        "recurrent linked(1) accept deadlock free accept possible linked(1) accept always "
                        "not linked(1) }");
    ASSERT_EQ(found.findings.find("error["), std::string::npos) << found.findings;
    EXPECT_EQ(found.verdicts, (Verdicts{"open", "open", "open", "holds", "fails"}));
}

std::string replace_text(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

/// Returns a robot that drives in state Going, with a transition that may leave Going.
std::string driver_model(const std::string& transition, const std::string& argument = "real",
                         const std::string& command = "move()") {
    const std::string model = R"(
enumeration Side { left right }
interface Motors { move() halt() turn(angle : ARGUMENT) }
interface Sensors { event neighbours : nat event go }
robotic platform Body { provides Motors uses Sensors }
stm Driver {
    requires Motors
    uses Sensors
    var n : nat = 0
    initial i
    state Going { entry COMMAND }
    transition begin { from i to Going }
    TRANSITION
}
controller Brain {
    requires Motors
    uses Sensors
    sref machine = Driver
    connection Brain on neighbours to machine on neighbours
    connection Brain on go to machine on go
}
module Robot {
    rref body = Body
    cref brain = Brain
    connection body on neighbours to brain on neighbours (_async)
    connection body on go to brain on go (_async)
}
)";
    return replace_text(replace_text(replace_text(model, "TRANSITION", transition), "COMMAND", command), "ARGUMENT",
                        argument);
}

/// Returns two robots that drive apart. The first time unit shows this, if time passes.
std::string two_drivers(const std::string& feed) {
    return "swarm Two for Robot { robots 2 grid 8 by 8 place at (0, 0) heading 0 deg place at (0, 0) heading 180 deg "
           "range nat = 0 to 3 drive by forward on move " +
           feed + " accept always linked(1) accept recurrent linked(1) accept deadlock free accept possible apart }";
}

/// A transition reads a value that the robot can sense at any time. So it is taken indefinitely within one time unit.
TEST(Swarm, SensingForEverLeavesNoTime) {
    const std::string senses = "transition again { from Going to Going trigger neighbours?n }";
    const Decided found = decide_swarm_of(driver_model(senses), two_drivers("feed neighbours with count(1)"));
    ASSERT_EQ(found.findings.find("error["), std::string::npos) << found.findings;
    EXPECT_EQ(found.verdicts, (Verdicts{"open", "open", "open", "fails"}));
    const Decided none = decide_swarm_of(driver_model(""), two_drivers(""));
    ASSERT_EQ(none.findings.find("error["), std::string::npos) << none.findings;
    EXPECT_EQ(none.verdicts, (Verdicts{"fails", "holds", "fails", "holds"}));
}

/// A deadline that only the environment can meet stops time if the environment does nothing.
TEST(Swarm, TimeThatWaitsForTheEnvironmentCanStop) {
    const std::string claims =
        "swarm One for Robot { robots 1 grid 8 by 8 place at (0, 0) heading 0 deg range nat = 0 to 3 drive by forward "
        "on move feed go with any accept always linked(1) }";
    const std::string goes = "transition again { from Going to Going trigger go }";
    const std::string in_time = replace_text(goes, "trigger go", "trigger go <{1}");
    const Decided found = decide_swarm_of(driver_model(in_time), claims);
    ASSERT_EQ(found.findings.find("error["), std::string::npos) << found.findings;
    EXPECT_EQ(found.verdicts, (Verdicts{"open"}));
    const Decided free = decide_swarm_of(driver_model(goes), claims);
    ASSERT_EQ(free.findings.find("error["), std::string::npos) << free.findings;
    EXPECT_EQ(free.verdicts, (Verdicts{"holds"}));
}

// ---------------------------------------------------------------- turns and numbers

/// The robot drives forth, turns and drives back. Whole numbers are degrees even if a decimal literal makes the unit of
/// reals finer. The robot is one cell away for a while, but never two.
TEST(Swarm, WholeNumbersTurnByDegrees) {
    for (const std::string type : {"nat", "int", "real"}) {
        std::string text = driver_model("", type, "move(); wait(1); turn(180); wait(1); move(); wait(1); halt()");
        text = replace_text(text, "var n : nat = 0", "var n : nat = 0 var r : real = 0.5");
        const Decided found = decide_swarm_of(
            text,
            "swarm One for Robot { robots 1 grid 8 by 8 place at (0, 0) heading 0 deg range nat = 0 to 180 "
            "range int = 0 to 180 range real = 0 to 180 drive by turn(deg) on turn drive by forward on move "
            "drive by stop on halt accept possible away(1) accept always not away(2) accept recurrent not "
            "away(1) }");
        ASSERT_EQ(found.findings.find("error["), std::string::npos) << found.findings;
        EXPECT_EQ(found.verdicts, (Verdicts{"holds", "holds", "holds"})) << type;
    }
}

TEST(Swarm, OnlyNumbersTurn) {
    for (const auto& [type, value] : {std::pair{"boolean", "true"}, std::pair{"Side", "Side::left"}}) {
        const std::string text = driver_model("", type, std::string("turn(") + value + ")");
        const Decided found =
            decide_swarm_of(text,
                            "swarm One for Robot { robots 1 grid 8 by 8 drive by turn(deg) on turn accept "
                            "always linked(1) }");
        EXPECT_NE(found.findings.find("RC-V03"), std::string::npos) << found.findings;
        EXPECT_NE(found.findings.find("needs exactly one number"), std::string::npos) << found.findings;
    }
}

/// `max_id` is not `id`, so it keeps its value, which is the robot's speed.
TEST(Swarm, ANumberIsThatOfOneConstant) {
    std::string text = driver_model(
        "transition drives { from Going to Driving condition max_id == 2 /\\ id == 0 } state "
        "Driving { entry move() }",
        "real", "halt()");
    text = replace_text(text, "var n : nat = 0",
                        "var n : nat = 0 const id : nat const max_id : nat const fixed : nat = 1");
    const auto claimed = [&](const std::string& constants) {
        return decide_swarm_of(text,
                               "swarm One for Robot { robots 1 grid 8 by 8 place at (0, 0) heading 0 deg range "
                               "nat = 0 to 3 drive by forward on move " +
                                   constants + " accept possible away(1) }");
    };
    for (const std::string id : {"id", "Driver::id"}) {
        const Decided found = claimed("const " + id + " = robot const max_id = 2");
        ASSERT_EQ(found.findings.find("error["), std::string::npos) << found.findings;
        EXPECT_EQ(found.verdicts, Verdicts{"holds"});
    }
    EXPECT_NE(claimed("const d = robot").findings.find("RC-V02"), std::string::npos);
    EXPECT_NE(claimed("const fixed = robot").findings.find("error[RC-V0"), std::string::npos);
}

/// Two machines with a constant of the same name.
TEST(Swarm, ANumberForOneOfSeveralConstantsIsAmbiguous) {
    std::string text = driver_model("transition again { from Going to Going trigger go condition id == 0 }");
    text = replace_text(text, "var n : nat = 0", "var n : nat = 0 const id : nat");
    text = replace_text(
        text, "controller Brain {",
        "stm Other { const id : nat initial i state Idle { } state Done { } transition begin { from i to "
        "Idle } transition ends { from Idle to Done condition id == 1 } }\ncontroller Brain { sref other = "
        "Other");
    const auto claimed = [&](const std::string& constants) {
        return decide_swarm_of(text, "swarm One for Robot { robots 1 grid 8 by 8 range nat = 0 to 3 " + constants +
                                         " accept possible linked(1) }")
            .findings;
    };
    const std::string both = claimed("const id = robot");
    EXPECT_NE(both.find("RC-V03"), std::string::npos) << both;
    EXPECT_NE(both.find("Driver::id"), std::string::npos) << both;
    EXPECT_NE(both.find("Other::id"), std::string::npos) << both;
    const std::string one = claimed("const Driver::id = robot");
    EXPECT_EQ(one.find("error["), std::string::npos) << one;
}

// ---------------------------------------------------------------- exchanged guards

/// Returns the algorithm without memory: after each count a robot turns back, or turns to any of four directions.
std::string memoryless_model(const std::string& turns_back, const std::string& goes_on) {
    std::string text = R"(
interface Motors { moveForward() startTurning(degree : real) countNeighbours() }
interface Sensors { event neighbours : nat event turned }
robotic platform Body { provides Motors uses Sensors }
stm Memoryless {
    requires Motors
    uses Sensors
    const alpha : nat = 1
    var n : nat = 0
    initial i
    probabilistic anywhere
    state Going { entry moveForward(); wait(1); countNeighbours(); neighbours?n }
    state Turning { entry wait(1) }
    transition begin { from i to Going }
    transition back { from Going to Turning condition n BACK alpha action startTurning(180) }
    transition goes { from Going to anywhere condition n ON alpha }
    transition none { from anywhere to Turning probability 0.25 action startTurning(0) }
    transition left { from anywhere to Turning probability 0.25 action startTurning(90) }
    transition right { from anywhere to Turning probability 0.25 action startTurning(-90) }
    transition round { from anywhere to Turning probability 0.25 action startTurning(180) }
    transition free { from Turning to Going trigger turned }
}
controller Brain {
    requires Motors
    uses Sensors
    sref machine = Memoryless
    connection Brain on neighbours to machine on neighbours
    connection Brain on turned to machine on turned
}
module Robot {
    rref body = Body
    cref brain = Brain
    connection body on neighbours to brain on neighbours (_async)
    connection body on turned to brain on turned (_async)
}
)";
    text.replace(text.find("BACK"), 4, turns_back);
    text.replace(text.find("ON alpha"), 2, goes_on);
    return text;
}

/// Three robots start in one cell with the same heading. With the guards exchanged, each robot hears the two others,
/// which is more than alpha, so all robots turn back at each count. They stay together and alternate between two cells.
/// With the right guards they can drive on together, because all may choose the same direction. So cohesion alone does
/// not expose the fault.
TEST(Swarm, CohesionAndMotionTellExchangedGuards) {
    const std::string swarm =
        "swarm Alpha for Robot { robots 3 grid 8 by 8 place at (0, 0) heading 0 deg range nat = 0 to 2 drive by "
        "forward "
        "on moveForward drive by turn(deg) on startTurning feed turned with turned feed neighbours with count(1) on "
        "countNeighbours accept always linked(1) accept possible linked(1) and away(2) }";
    const Decided exchanged = decide_swarm_of(memoryless_model(">", "<="), swarm);
    ASSERT_EQ(exchanged.findings.find("error["), std::string::npos) << exchanged.findings;
    EXPECT_EQ(exchanged.verdicts, (Verdicts{"holds", "fails"}));
    const Decided right = decide_swarm_of(memoryless_model("<", ">="), swarm);
    ASSERT_EQ(right.findings.find("error["), std::string::npos) << right.findings;
    ASSERT_EQ(right.verdicts.size(), 2U);
    EXPECT_EQ(right.verdicts.back(), "holds");
}

/// Two robots of corpus/alpha start in one cell and drive to the east and to the north. After one step they are
/// diagonally adjacent. After the second step they do not hear each other, so both turn back and return to the cells of
/// one step before. So they are never more than three cells apart. With the guards exchanged, no robot ever hears more
/// than one other robot, so both drive on forever.
TEST(Swarm, CohesionTellsTheExchangedGuardsOfTheCorpus) {
    std::ifstream file(fs::path(alpha_folder()) / "alpha.rct");
    std::string text{std::istreambuf_iterator<char>(file), {}};
    const auto exchange = [&](const std::string& from, const std::string& to) {
        for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
            text.replace(at, from.size(), to);
    };
    exchange("heard < alpha", "heard > alpha");
    exchange("heard >= alpha", "heard <= alpha");
    const std::string swarm =
        swarm_of_alpha("robots 2 grid 8 by 8 place at (0, 0) heading 0 deg place at (0, 0) heading 90 deg",
                       "accept deadlock free accept always linked(3) accept possible linked(1) and away(3)");
    const Decided right = decide_swarm(alpha_folder(), swarm);
    EXPECT_EQ(right.verdicts, (Verdicts{"holds", "holds", "holds"})) << right.findings;
    const Decided exchanged = decide_swarm_of(text, swarm);
    ASSERT_EQ(exchanged.verdicts.size(), 3U) << exchanged.findings;
    EXPECT_EQ(exchanged.verdicts[1], "fails");
}

// ---------------------------------------------------------------- RoboStar's collection

/// The published model has two machines. One of them exchanges messages with the other robots. RoboStar found it
/// deadlock free for two or more robots, but not for one (swarm.md 1).
TEST(Swarm, PublishedCollectionIsDeadlockFreeFromTwoRobotsOn) {
    const fs::path model = tests::shared_folder() / "suite/robotool/accept/AlphaAlgorithm";
    if (!fs::exists(model)) GTEST_SKIP() << "the published model is not there";
    const tests::TemporaryFolder folder;
    for (const auto& entry : fs::directory_iterator(model))
        if (entry.path().extension() == ".rct")
            folder.write(entry.path().filename().string(), tests::read_contents(entry.path()));
    for (const std::uint32_t robots : {1U, 2U, 3U}) {
        const std::string swarm = "swarm Alpha for AggregationSoftware { range nat = 0 to 5 range given = 0 to " +
                                  std::to_string(robots - 1) +
                                  " const id = robot feed obstacle with any connect broadcast to broadcast connect "
                                  "receive to receive accept deadlock free }";
        const Decided found = decide_swarm(folder.path(), swarm, Time::untimed, {robots, {}});
        ASSERT_EQ(found.findings.find("error["), std::string::npos) << found.findings;
        EXPECT_EQ(found.verdicts, (Verdicts{robots == 1 ? "fails" : "holds"})) << robots;
    }
}

// ---------------------------------------------------------------- what does not fit

std::string findings_of(const std::string& swarm, Time time = Time::timed) {
    return decide_swarm(alpha_folder(), swarm, time).findings;
}

TEST(Swarm, WhatDoesNotFitIsReported) {
    EXPECT_NE(findings_of("swarm A for alpha::Robot { robots 0 }").find("RC-V01"), std::string::npos);
    EXPECT_NE(findings_of("swarm A for alpha::Robt { robots 2 }").find("did you mean"), std::string::npos);
    EXPECT_NE(findings_of("swarm A for alpha::Robot { grid 5 by 5 drive by forward on moveForwards }").find("RC-V02"),
              std::string::npos);
    EXPECT_NE(findings_of("swarm A for alpha::Robot { accept always linked(1) }").find("RC-V03"), std::string::npos);
    EXPECT_NE(findings_of(swarm_of_alpha("robots 6 grid 5 by 5", "accept deadlock free")).find("hear up to 5"),
              std::string::npos);
    EXPECT_NE(findings_of(swarm_of_alpha("grid 5 by 5", "accept deadlock free"), Time::untimed).find("untimed"),
              std::string::npos);
    EXPECT_NE(findings_of(swarm_of_alpha("grid 5 by 5", "feed neighbours with any")).find("twice"), std::string::npos);
    std::string deep = "swarm A for alpha::Robot { grid 5 by 5 accept always ";
    for (int i = 0; i < 100'000; ++i) deep += "(";
    EXPECT_NE(findings_of(deep).find("RC-V01"), std::string::npos);
}

std::string chain_conditions(std::size_t conditions, const std::string& word) {
    std::string text = "not apart";
    for (std::size_t i = 1; i < conditions; ++i) text += " " + word + " apart";
    return text;
}

/// Two robots that are always in one cell are never apart, so only the first condition of the chain is true.
TEST(Swarm, LongConditionsHaveABound) {
    const std::string size = "robots 2 grid 3 by 3 place at (0, 0) heading 0 deg";
    const Decided most =
        decide_swarm(alpha_folder(), swarm_of_alpha(size, "accept always " + chain_conditions(500, "or") +
                                                              " accept always " + chain_conditions(500, "and")));
    ASSERT_EQ(most.findings.find("error["), std::string::npos) << most.findings;
    EXPECT_EQ(most.verdicts, (Verdicts{"holds", "fails"}));
    for (const std::string word : {"or", "and"})
        EXPECT_NE(findings_of("swarm A for alpha::Robot { grid 5 by 5 accept always " +
                              chain_conditions(100'000, word) + " }")
                      .find("at most 1000 conditions"),
                  std::string::npos);
}

// ---------------------------------------------------------------- the written script

/// Returns the text of the assertion file for a swarm of corpus/alpha.
std::string assertions_file(const std::string& claims) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics found;
    const auto parsed = frontend::load_project(sources, alpha_folder(), found);
    const ir::System system = ir::lower(*parsed, sources, found);
    const std::string text = swarm_of_alpha("robots 2 grid 3 by 3 place at (0, 0) heading 0 deg", claims);
    const Swarm swarm = read_swarm(sources, sources.add("test.swarm", text), found);
    ir::InstantiationOptions options;
    options.ranges["nat"] = {0, 4};
    const ir::Instantiation instantiation = ir::instantiate_system(system, options, found);
    Emission emission = emit(system, instantiation, Time::timed, {}, sources, found);
    make_swarm(emission, swarm, Time::timed, system, instantiation, sources, found);
    EXPECT_TRUE(found.ok()) << diagnostics::render_text(sources, found);
    return files(emission, Time::timed, "alpha_swarm").back().text;
}

/// The script contains no assertion for a claim that an assertion cannot express completely.
TEST(Swarm, TheScriptSaysWhatNoAssertionDecides) {
    const std::string text = assertions_file("accept deadlock free accept recurrent linked(1) accept always linked(1)");
    EXPECT_EQ(text.find("deadlock free [F]"), std::string::npos) << text;
    const std::size_t comment = text.find("-- not said by an assertion; `check --swarm` decides it");
    ASSERT_NE(comment, std::string::npos) << text;
    EXPECT_NE(text.find("Alpha: deadlock free [", comment), std::string::npos) << text;
    EXPECT_NE(text.find("Alpha: recurrent linked(1) [", comment), std::string::npos) << text;
    EXPECT_NE(text.find("Alpha: always linked(1) [2 robots, 3 by 3]: that time can always pass", comment),
              std::string::npos)
        << text;
}

}  // namespace
}  // namespace robochart::csp_emit
