// SPDX-License-Identifier: Apache-2.0
// Tests the classes of the paper's mapping. The programs use these classes as a robot's author would: derive, override,
// raise events, step. The exit code of each program identifies the first expectation that fails.
#include <gtest/gtest.h>

#include <fstream>

#include "tests/cpp_emit/harness.hpp"
#include "tests/cpp_emit/models.hpp"

namespace robochart::cpp_emit::class_api_test {
namespace {

using testing::Folder;

class GeneratedClasses : public ::testing::Test {
protected:
    /// Compiles and runs a user's program with a component's classes.
    void run(const char* model, const char* name, const char* machine, const std::string& program,
             const char* flags = "") {
        const ir::System system = testing::load_corpus(model);
        folder_.write(testing::emit_ok(system, testing::component_named(system, name)));
        std::ofstream(folder_.path() + "/user.cpp")
            << "#include \"" << machine << ".hpp\"\n#define EXPECT(x) if (!(x)) return __LINE__\n"
            << program;
        folder_.run(std::string("c++ -std=c++17 -Wall -Wextra -Werror -I. ") + flags + " user.cpp " + machine +
                    ".cpp -o user");
        folder_.run("./user; code=$?; test $code = 0 || { sed -n ${code}p user.cpp; exit 1; }");
    }

    Folder folder_;
};

TEST_F(GeneratedClasses, OperationsOfAMachineAloneAreOverridden) {
    run("aggregation", "AggregationFSM", "AggregationFSM", R"(
struct Robot : aggregation::AggregationFSM {
    void MoveClockwise(double angular, double linear) override { angularSpeed = angular; linearSpeed = linear; }
    void RotateClockwise(double angular) override { angularSpeed = angular; linearSpeed = 0; }
};
int main() {
    Robot robot;
    EXPECT(robot.state() == Robot::States::none);
    robot.MakeTransition();
    EXPECT(robot.state() == Robot::States::S1 && robot.angularSpeed == -0.75 && robot.linearSpeed == -10.88);
    robot.seeRobot = true;
    EXPECT(robot.step() == robochart::StepResult::quiescent);
    EXPECT(robot.state() == Robot::States::S2 && robot.angularSpeed == -5.02);
    EXPECT(!robot.seeRobot);
    robot.reset();
    EXPECT(robot.state() == Robot::States::none && robot.angularSpeed == 0);
    return 0;
})");
}

TEST_F(GeneratedClasses, OperationsOfTheModelRunUnlessReplaced) {
    run("aggregation", "Aggregation", "AggregationFSM", R"(
struct Robot : aggregation::AggregationFSM {
    bool RotateClockwise(double) override { ++rotations; return true; }
    int rotations = 0;
};
int main() {
    Robot robot;
    robot.step();
    EXPECT(robot.angularSpeed == -0.75 && robot.linearSpeed == -10.88);
    robot.seeRobot = true;
    robot.step();
    EXPECT(robot.rotations == 1 && robot.angularSpeed == -0.75);
    // Replaced, the operation takes no time: seeWall is taken in the same cycle.
    robot.seeWall = robot.seeRobot = true;
    robot.step();
    EXPECT(robot.rotations == 1 && robot.state() == Robot::States::S1);
    return 0;
})");
}

TEST_F(GeneratedClasses, SensorsAreReadInCheckInEvent) {
    run("aggregation", "Aggregation", "AggregationFSM", R"(
struct Robot : aggregation::AggregationFSM {
    void CheckInEvent() override { (sees ? seeRobot : seeWall) = true; }
    bool sees = true;
};
int main() {
    Robot robot;
    robot.step();
    robot.step();
    EXPECT(robot.state() == Robot::States::S2);
    robot.sees = false;
    robot.step();
    EXPECT(robot.state() == Robot::States::S1);
    return 0;
})");
}

/// The compiler reports the platform operations that a class does not override. Operations that the model defines need
/// not be overridden.
TEST_F(GeneratedClasses, OperationsOfThePlatformHaveToBeOverridden) {
    run("swarm_taxis", "SwarmTaxis", "SwarmTaxisFSM", R"(
#include <type_traits>
struct Forgetful : swarm_taxis::SwarmTaxisFSM {
    void MoveForward() override {}
    void CheckIlluminationStatus() override {}
    void CalcCoherenceHeading() override {}
    void CalcAvoidanceHeading() override {}
};
struct Robot : Forgetful {
    void StartTurning(double) override {}
};
int main() {
    EXPECT(std::is_abstract_v<Forgetful>);
    EXPECT(!std::is_abstract_v<Robot>);
    return 0;
})");
}

/// A swarm taxi with a platform that does nothing.
constexpr const char* idle_taxi = R"(
struct Robot : swarm_taxis::SwarmTaxisFSM {
    void MoveForward() override {}
    void CheckIlluminationStatus() override {}
    void CalcCoherenceHeading() override {}
    void CalcAvoidanceHeading() override {}
    void StartTurning(double) override {}
};)";

TEST_F(GeneratedClasses, TimersShowAndResetTheClock) {
    run("swarm_taxis", "SwarmTaxis", "SwarmTaxisFSM", std::string(idle_taxi) + R"(
int main() {
    Robot robot;
    robot.step();
    EXPECT(robot.T.counter == 1);
    for (int i = 0; i < 20; ++i) robot.step();
    EXPECT(robot.T.counter == 21);
    robot.T.ResetTimer();
    for (int i = 0; i < 25; ++i) robot.step();
    EXPECT(robot.state() == swarm_taxis::SwarmTaxisFSM::States::Forward);
    robot.step();
    EXPECT(robot.state() == swarm_taxis::SwarmTaxisFSM::States::Coherence);
    return 0;
})");
}

TEST_F(GeneratedClasses, ValuesComeWithTheirEvents) {
    run("swarm_taxis", "SwarmTaxis", "SwarmTaxisFSM", std::string(idle_taxi) + R"(
int main() {
    Robot robot;
    robot.step();
    robot.illumination = true;
    robot.illumination_value = true;
    robot.step();
    EXPECT(robot.illuminated && robot.avoidanceRadius == 0.2);
    robot.illumination = true;
    robot.illumination_value = false;
    robot.step();
    EXPECT(!robot.illuminated && robot.avoidanceRadius == 0.1);
    return 0;
})");
}

/// Returns the comment of an event in the generated class. The machine's entry action calls an operation with this
/// statement.
std::string comment_of_event(const std::string& statement) {
    const ir::System system = testing::load_model(
        "package p interface O { go() wait_or_not() } operation wait_or_not() { requires O initial i final F "
        "transition t { from i to F action go() ; " +
        statement +
        " } } stm M { requires O event e initial i state A { entry wait_or_not() } state B { } "
        "transition t0 { from i to A } transition t1 { from A to B trigger e } } "
        "controller K { requires O event e opref o = wait_or_not sref m = M connection K on e to m on e }");
    for (const OutputFile& file : testing::emit_ok(system, testing::component_named(system, "K")).files) {
        const std::size_t at = file.text.find("event e: ");
        if (at != std::string::npos) return file.text.substr(at, file.text.find('\n', at) - at);
    }
    return "";
}

TEST(GeneratedEvents, AreLostInActionsOnlyWhereOneTakesTime) {
    EXPECT_EQ(comment_of_event("wait(2)"),
              "event e: raise it before a cycle, which lowers it again; lost in a cycle spent in an action");
    EXPECT_EQ(comment_of_event("wait(0)"), "event e: raise it before a cycle, which lowers it again");
    EXPECT_EQ(comment_of_event("skip"), "event e: raise it before a cycle, which lowers it again");
}

TEST_F(GeneratedClasses, EventsAreRaisedAndHeardByMethods) {
    const ir::System system = testing::load_model(R"(package p
interface I { event ask : int event answer : int event done var value : int }
stm M { uses I var n : int initial i state S { }
    transition t0 { from i to S } transition t1 { from S to S trigger ask?n action answer!(n + 1) ; done } }
)");
    folder_.write(testing::emit_ok(system, testing::component_named(system, "M")));
    std::ofstream(folder_.path() + "/user.cpp") << R"(#include "M.hpp"
struct Robot : p::M {
    void on_answer(std::int64_t heard) override { answered = heard; }
    void on_done() override { ++times; }
    std::int64_t answered = 0;
    int times = 0;
};
int main() {
    Robot robot;
    robot.step();
    robot.raise_ask(3);
    robot.raise_ask(4);  // the last one counts
    robot.step();
    if (robot.answered != 5 || robot.times != 1 || !robot.answer || robot.answer_value != 5) return 1;
    robot.step();
    return robot.times == 1 && !robot.answer ? 0 : 2;
})";
    folder_.run("c++ -std=c++17 -Wall -Wextra -Wshadow -Werror -I. user.cpp M.cpp -o user && ./user");
}

TEST_F(GeneratedClasses, PreconditionsGoToTheHook) {
    const ir::System system = testing::load_model(R"(package p
interface I { op(a : int) }
operation op(a : int) { precondition a < 0 }
stm M { requires I initial i transition t0 { from i to A } state A { entry op(1) } }
controller C { sref m = M opref o = op })");
    folder_.write(testing::emit_ok(system, testing::component_named(system, "C")));
    std::ofstream(folder_.path() + "/user.cpp") << R"(#include "M.hpp"
int main() { p::M m; return m.step() == robochart::StepResult::precondition ? 0 : 1; })";
    folder_.run("c++ -std=c++17 -I. user.cpp M.cpp -o asserting");
    std::string output;
    EXPECT_NE(folder_.status("./asserting", output), 0);  // assert is the default
    EXPECT_NE(output.find("a < Int(0)"), std::string::npos) << output;
    folder_.run("c++ -std=c++17 -I. '-DRC_REQUIRE(c)=static_cast<void>(c)' user.cpp M.cpp -o hooked && ./hooked");
}

}  // namespace
}  // namespace robochart::cpp_emit::class_api_test
