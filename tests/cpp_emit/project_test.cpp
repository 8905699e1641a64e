// SPDX-License-Identifier: Apache-2.0
// Tests the projects of `emit cpp --target`. Each project is generated, configured, built without a warning, and run
// without changes. Debian has no ROS 2, so the ROS 2 package is built with tests/cpp_emit/ros2_stub. ARGoS is used if
// it is installed.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "base/diagnostics/render.hpp"
#include "semantics/instantiate/instantiate.hpp"
#include "tests/cpp_emit/harness.hpp"
#include "tests/cpp_emit/models.hpp"
#include "tests/needed.hpp"
#include "tests/shared_folder.hpp"
#include "tests/source_folder.hpp"

namespace robochart::cpp_emit::project_test {
namespace {

using testing::Folder;

const std::string stub = tests::source_folder().string() + "/tests/cpp_emit/ros2_stub";
const std::string flags = "-O0 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror";

class Project : public ::testing::Test {
protected:
    void emit(const ir::System& system, const char* name, Target target) {
        Options options;
        options.target = target;
        const Emission emission = testing::emit_ok(system, testing::component_named(system, name), options);
        EXPECT_FALSE(emission.files.empty());
        folder_.write(emission);
    }
    void emit(const char* model, const char* name, Target target) { emit(testing::load_corpus(model), name, target); }

    void build(const std::string& options = "") const {
        folder_.run("cmake -S . -B build -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS='" + flags + "' " + options +
                    " && cmake --build build");
    }

    void write(const std::string& path, const std::string& text) const {
        std::ofstream(folder_.path() + "/" + path) << text;
    }

    Folder folder_;
};

TEST_F(Project, ALibraryIsInstalledAndFound) {
    emit("aggregation", "Aggregation", Target::library);
    build("-DCMAKE_INSTALL_PREFIX=$PWD/prefix");
    folder_.run("cmake --install build && mkdir user");
    write("user/CMakeLists.txt",
          "cmake_minimum_required(VERSION 3.16)\nproject(user LANGUAGES CXX)\nfind_package(AggregationFSM REQUIRED)\n"
          "add_executable(user user.cpp)\ntarget_link_libraries(user AggregationFSM::AggregationFSM)\n");
    write("user/user.cpp", R"(#include <AggregationFSM.hpp>
int main() {
    aggregation::AggregationFSM robot;
    robot.step();
    return robot.angularSpeed == -0.75 ? 0 : 1;
})");
    folder_.run(
        "cmake -S user -B user/build -DCMAKE_PREFIX_PATH=$PWD/prefix && cmake --build user/build && user/build/user");
}

/// Probabilistic junctions draw alternatives with their probabilities. The frequency in 100,000 draws must be within
/// five standard deviations (0.00685) of 0.75.
TEST_F(Project, JunctionsAreDrawnByTheirChances) {
    emit(testing::load_model(R"(package p
interface O { left() right() never() }
stm M { requires O event go initial i probabilistic p
    state A { } state B { entry left() } state C { entry right() } state D { entry never() }
    transition t0 { from i to A } transition t1 { from A to p trigger go }
    transition t2 { from p to B probability 0.75 } transition t3 { from p to D probability 0 }
    transition t4 { from p to C probability 1/4 }
    transition t5 { from B to A } transition t6 { from C to A } transition t7 { from D to A } }
)"),
         "M", Target::library);
    write("user.cpp", R"(#include <cmath>
#include <string>
#include "M.hpp"
struct Robot : p::M {
    void left() noexcept override { ways += 'l'; }
    void right() noexcept override { ways += 'r'; }
    void never() noexcept override { ways += 'n'; }
    std::string drawn(int cycles) {
        ways.clear();
        reset();
        while (cycles-- > 0) { raise_go(); step(); }
        return ways;
    }
    std::string ways;
};
int main() {
    Robot robot, other;
    double left = 0;
    for (const char way : robot.drawn(200'000)) {
        if (way == 'n') return 1;
        left += way == 'l';
    }
    if (robot.ways.size() < 90'000 || std::abs(left / static_cast<double>(robot.ways.size()) - 0.75) > 0.00685) return 2;
    robot.SetSeed(7); other.SetSeed(7);
    const std::string ways = robot.drawn(100);
    if (ways.size() < 40 || ways != other.drawn(100)) return 3;
    other.SetSeed(8);
    return ways == other.drawn(100) ? 4 : 0;
})");
    folder_.run("c++ -std=c++17 -O1 " + flags.substr(4) + " -Icontroller -o user user.cpp controller/M.cpp && ./user");
}

TEST_F(Project, TheConsoleTakesLinesOrTime) {
    emit("swarm_taxis", "SwarmTaxis", Target::main);
    build();
    const std::string lines =
        folder_.run("printf '\\nillumination=true\\nrobotDetected nothing\\n' | build/SwarmTaxisFSM_console");
    EXPECT_NE(lines.find("cycle 1\n  MoveForward()\n  CheckIlluminationStatus()\n  state Forward"), std::string::npos)
        << lines;
    EXPECT_NE(lines.find("cycle 3\n  CalcAvoidanceHeading()"), std::string::npos) << lines;
    // The first word that is no input is answered with the list of inputs.
    EXPECT_NE(lines.find("not an input: nothing\nusage: SwarmTaxisFSM_console "), std::string::npos) << lines;
    EXPECT_NE(lines.find("  illumination=VALUE"), std::string::npos) << lines;
    const std::string help = folder_.run("build/SwarmTaxisFSM_console --help");
    EXPECT_NE(help.find("usage: "), std::string::npos) << help;
    EXPECT_NE(help.find("true or false\n"), std::string::npos) << help;
    EXPECT_NE(help.find("\n  robotDetected\n"), std::string::npos) << help;
    // One cycle runs every 0.1 s for 1.5 s. Words that are typed in between are raised in the next cycle.
    const std::string timed = folder_.run(
        "for i in 1 2 3 4 5 6 7 8 9 10; do sleep 0.15; echo robotDetected; done | build/SwarmTaxisFSM_console 100");
    EXPECT_NE(timed.find("cycle 1\n  MoveForward()"), std::string::npos) << timed;
    EXPECT_NE(timed.find("  CalcAvoidanceHeading()\n"), std::string::npos) << timed;
    EXPECT_NE(timed.find("cycle 3"), std::string::npos) << timed;
    std::string output;
    EXPECT_NE(folder_.status("build/SwarmTaxisFSM_console often", output), 0);
    EXPECT_NE(output.find("usage"), std::string::npos) << output;
}

TEST(ProjectText, APackageIsWellFormed) {
    const ir::System system = testing::load_corpus("swarm_taxis");
    Options options;
    options.target = Target::ros2;
    const Emission emission = testing::emit_ok(system, testing::component_named(system, "SwarmTaxis"), options);
    std::string text;
    for (const OutputFile& file : emission.files)
        if (file.path == "package.xml") text = file.text;
    ASSERT_NE(text.find("<package format=\"3\">"), std::string::npos) << text;
    // Every element must be closed inside the element that contains it. The order of the elements is that of REP 149.
    std::vector<std::string> open, order;
    for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at + 1)) {
        const std::size_t end = text.find('>', at);
        ASSERT_NE(end, std::string::npos);
        const std::string tag = text.substr(at + 1, end - at - 1);
        if (tag[0] == '?') continue;
        if (tag[0] == '/') {
            ASSERT_FALSE(open.empty());
            EXPECT_EQ(open.back(), tag.substr(1));
            open.pop_back();
            continue;
        }
        open.push_back(tag.substr(0, tag.find(' ')));
        order.push_back(open.back());
    }
    EXPECT_TRUE(open.empty());
    const std::vector<std::string> expected{
        "package",          "name",        "version",     "description", "maintainer",  "license",
        "buildtool_depend", "depend",      "depend",      "depend",      "depend",      "depend",
        "depend",           "exec_depend", "exec_depend", "exec_depend", "exec_depend", "test_depend",
        "test_depend",      "test_depend", "test_depend", "export",      "build_type"};
    EXPECT_EQ(order, expected);
    EXPECT_NE(text.find("<name>swarm_taxis</name>"), std::string::npos) << text;
}

TEST(ProjectText, WhatHasNoMessageIsRefused) {
    const char* const text = R"(package p
interface I { path(all : Seq(real)) }
interface E { event found : Seq(nat) }
stm M { requires I uses E var s : Seq(nat) initial i
    state A { entry path(<>) }
    transition t0 { from i to A } transition t1 { from A to A trigger found?s } }
)";
    const ir::System system = testing::load_model(text);
    diagnostics::Diagnostics diagnostics;
    const ir::Instantiation inst = ir::instantiate_system(system, {}, diagnostics);
    for (const Target target : {Target::library, Target::main, Target::enki, Target::argos, Target::ros2}) {
        Options options;
        options.target = target;
        const Emission emission = emit(system, inst, testing::component_named(system, "M"), options, diagnostics);
        EXPECT_EQ(emission.files.empty(), target == Target::ros2);
    }
    std::string codes;
    for (const auto& finding : diagnostics.sorted_findings())
        codes += std::string(finding.rule->code) + " " + finding.message() + "\n";
    EXPECT_NE(codes.find("RC-G14 no ros2 project is generated for 'M': std_msgs has no message for the event 'found'"),
              std::string::npos)
        << codes;
    EXPECT_NE(codes.find("the operation 'path'"), std::string::npos) << codes;
}

/// The text that an author writes into robot.hpp for aggregation.
const char* const aggregation_robot = R"(#pragma once
#include "AggregationFSM.hpp"
#include "body.hpp"
class Robot final : public ::aggregation::AggregationFSM {
public:
    explicit Robot(Body& body) : body_(body) {}
    void CheckInEvent() override { (body_.sees_robot() ? seeRobot : seeWall) = true; }
    void act() { body_.drive(linearSpeed, angularSpeed); }
private:
    Body& body_;
};
)";

bool enki_is_there(const Folder& folder) {
    std::string ignored;
    return folder.status("echo '#include <enki/PhysicalEngine.h>' | c++ -x c++ -fsyntax-only -", ignored) == 0;
}

/// Without changes, the generated robots report their actions and do not move. With a completed robot.hpp, twenty
/// robots aggregate.
TEST_F(Project, RobotsInEnki) {
    ROBOCHART_NEEDS(enki_is_there(folder_), "Enki (Debian: libenki-dev)");
    emit("aggregation", "Aggregation", Target::enki);
    build();
    const std::string standing = folder_.run("mkdir logs && build/AggregationFSM_enki 2 1 1 logs");
    folder_.run("grep -q '^component aggregation::Aggregation$' logs/robot-1.trace");
    folder_.run("grep -q '^angularSpeed!-0.75 linearSpeed!-10.88 tock$' logs/robot-0.trace");
    EXPECT_NE(standing.find("robot,x,y,heading,good,state"), std::string::npos) << standing;
    EXPECT_NE(standing.find(",1,S1"), std::string::npos) << standing;
    write("robot.hpp", aggregation_robot);
    folder_.run("cmake --build build");
    std::istringstream table(folder_.run("build/AggregationFSM_enki 20 180 | tail -20 | cut -d, -f2,3 | tr , ' '"));
    std::vector<std::pair<double, double>> at;
    for (double x = 0, y = 0; table >> x >> y;) at.emplace_back(x, y);
    ASSERT_EQ(at.size(), 20U);
    double mean_x = 0, mean_y = 0, spread = 0;
    for (const auto& [x, y] : at) mean_x += x / 20, mean_y += y / 20;
    for (const auto& [x, y] : at) spread += std::hypot(x - mean_x, y - mean_y) / 20;
    // Robots that are scattered over the arena are about 95 cm from their centroid. In a cluster of twenty they are 12
    // to 17 cm from it.
    EXPECT_LT(spread, 25);
}

TEST_F(Project, RobotsOfOtherModelsInEnki) {
    ROBOCHART_NEEDS(enki_is_there(folder_), "Enki (Debian: libenki-dev)");
    emit(testing::load_model(testing::typed_model), "Mod", Target::enki);
    build();
    const std::string output = folder_.run("build/M_enki 1 1");
    EXPECT_NE(output.find("robot 0: go 0.5 3"), std::string::npos) << output;
}

/// Builds classes and console programs of all modules in RoboTool's own models, if these are present.
TEST(ProjectText, RoboToolsModelsOnTheConsole) {
    namespace fs = std::filesystem;
    const fs::path suite = robochart::tests::shared_folder() / "suite/robotool/accept";
    if (!fs::is_directory(suite)) GTEST_SKIP() << "the shared models are absent";
    Options options;
    options.target = Target::main;
    Folder folder;
    std::size_t generated = 0;
    for (const fs::directory_entry& project : fs::directory_iterator(suite))
        generated += testing::emit_all(project.path().string(), folder, options);
    EXPECT_GE(generated, 45U);
    // Each program is one translation unit, because most of the compile time is spent on the standard library's
    // headers.
    folder.run("for d in *_" + std::to_string(static_cast<int>(ir::ComponentKind::module)) +
               "_*/; do (cd $d && cat main.cpp controller/*.cpp | c++ -std=c++17 -Wall -Wextra -Wpedantic "
               "-Wconversion -Werror -DROBOCHART_TRACE=1 -Icontroller -fsyntax-only -x c++ -) || exit 1; done");
}

/// ROBOCHART_ARGOS is the installation folder of ARGoS. The configuration of the project finds it.
TEST_F(Project, APluginOfArgos) {
    const std::string prefix = ROBOCHART_ARGOS;
    if (prefix.empty()) GTEST_SKIP() << "ARGoS is not installed (-DARGoS_ROOT=PREFIX)";
    emit("swarm_taxis", "SwarmTaxis", Target::argos);
    build("-DCMAKE_PREFIX_PATH=" + prefix);
    folder_.run("sed -i 's|<params />|<params logs=\".\"/>|' SwarmTaxisFSM.argos");
    const std::string output =
        folder_.run("LD_LIBRARY_PATH=" + prefix + "/lib/argos3 " + prefix + "/bin/argos3 -n -z -c SwarmTaxisFSM.argos");
    EXPECT_NE(output.find("robot puck0: MoveForward"), std::string::npos) << output;
    // No other robot answers, so the state Coherence waits for its heading.
    EXPECT_NE(output.find("robot puck9: CalcCoherenceHeading"), std::string::npos) << output;
    folder_.run("grep -q '^MoveForward! CheckIlluminationStatus! tock$' puck9.trace");
}

bool pybind_is_there(const Folder& folder) {
    std::string ignored;
    const std::string files = "/usr/lib/cmake/pybind11/pybind11Config.cmake /usr/include/python3*/Python.h";
    return folder.status("ls " + files, ignored) == 0;
}

/// The program sends values of all kinds to the controller, which sends them back.
const char* const values_model = R"(package p
enumeration Light { red green }
enumeration Order { halt go ( real , nat ) }
datatype Point { x : real  ^lambda : nat }
interface In { event at : Point event every : Seq(Light) event some : Set(nat) event ahead : vector(real, 2)
    event pair : nat * boolean event order : Order event word : string event map : nat <-> Light event count : nat event turn : int }
interface Out { shown(p : Point) listed(l : Seq(Light)) }
interface Shared { var last : Point var lights : Seq(Light) var numbers : Set(nat) var both : nat * boolean
    var speed : vector(real, 2) var latest : Order var label : string var links : nat <-> Light var number : nat var angle : int }
stm M { uses In requires Out requires Shared event ^yield : Point
    initial i state A { }
    transition t0 { from i to A }
    transition t1 { from A to A trigger at ? last action shown(last) ; ^yield ! last }
    transition t2 { from A to A trigger every ? lights action listed(lights) }
    transition t3 { from A to A trigger some ? numbers }
    transition t4 { from A to A trigger pair ? both }
    transition t5 { from A to A trigger ahead ? speed }
    transition t6 { from A to A trigger order ? latest }
    transition t7 { from A to A trigger word ? label }
    transition t8 { from A to A trigger map ? links }
    transition t9 { from A to A trigger count ? number }
    transition t10 { from A to A trigger turn ? angle }
}
)";

const char* const values_bench = R"(import M_controller as c

class Robot(c.M):
    def __init__(self):
        super().__init__()
        self.calls = []
    def shown(self, point):
        self.calls.append(("shown", point))
    def listed(self, lights):
        self.calls.append(("listed", lights))
    def on_yield(self, point):
        self.calls.append(("yield", point))

def refused(kind, call, *values):
    try:
        call(*values)
    except kind as error:
        assert str(error), kind
        return
    raise AssertionError((kind, values))

robot = Robot()
robot.log_to("bench.trace")
robot.step()
assert robot.state().name == "A"
robot.raise_at(c.Point(0.5, 3))
robot.raise_every([c.Light.green, c.Light.red])
robot.raise_some({3, 1, 3})
robot.raise_pair((2, True))
robot.raise_ahead((0.25, -1))
robot.raise_order(("go", 0.5, 7))
robot.raise_word("docked")
robot.raise_map({(1, c.Light.red)})
robot.raise_count(4)
robot.raise_turn(-4)
assert robot.step() == c.StepResult.quiescent
assert robot.calls == [("shown", (0.5, 3)), ("yield", (0.5, 3)), ("listed", (c.Light.green, c.Light.red))], robot.calls
assert robot.last.x == 0.5 and robot.last == c.Point(0.5, 3)
assert robot.lights == (c.Light.green, c.Light.red)
assert robot.numbers == frozenset({1, 3})
assert robot.both == (2, True) and robot.speed == (0.25, -1.0) and robot.latest == ("go", 0.5, 7)
assert robot.label == "docked" and robot.links == frozenset({(1, c.Light.red)})
assert robot.number == 4 and robot.angle == -4
refused(TypeError, robot.raise_count, 1.5)
refused(TypeError, robot.raise_count, True)
refused(ValueError, robot.raise_count, -1)
refused(OverflowError, robot.raise_turn, 2 ** 63)
refused(TypeError, robot.raise_at, c.Light.red)
refused(TypeError, robot.raise_at, (0.5,))
refused(TypeError, robot.raise_every, [1])
refused(ValueError, robot.raise_every, [c.Light.red] * 1000)
refused(TypeError, robot.raise_order, ("stop",))
refused(TypeError, robot.raise_order, ("go", 0.5))
refused(ValueError, robot.raise_word, "x" * 40)
refused(RuntimeError, robot.log_to, "again.trace")
refused(OSError, Robot().log_to, "/nowhere/x.trace")

class Faulty(Robot):
    def shown(self, point):
        raise KeyError("shown")
    def on_yield(self, point):
        raise AssertionError("called after an exception")

class Nested(Robot):
    def shown(self, point):
        self.step()

for kind, error in ((Faulty, KeyError), (Nested, RuntimeError), (c.M, NotImplementedError)):
    robot = kind()
    robot.step()
    robot.raise_at((0.5, 3))
    refused(error, robot.step)
    assert robot.step() == c.StepResult.quiescent  # the cycle before has ended as without the exception
    assert robot.last == (0.5, 3)
)";

TEST_F(Project, AModuleOfPython) {
    ROBOCHART_NEEDS(pybind_is_there(folder_), "pybind11 (Debian: pybind11-dev python3-dev)");
    emit(testing::load_model(values_model), "M", Target::python);
    build("-DPYTHON_EXECUTABLE=/usr/bin/python3");
    write("bench.py", values_bench);
    folder_.run("PYTHONPATH=build /usr/bin/python3 bench.py");
    folder_.run("grep -q 'at?(0.5,3)' bench.trace");
    folder_.run("cd build && ctest --output-on-failure");
}

/// Elements with keywords of Python as names, and others with the names to which these are changed.
const char* const keywords_model = R"(package p
enumeration Sort { ^is is_ None name value }
datatype Pair { ^lambda : nat lambda_ : nat }
interface Sensors { event ^from : Sort event ^pass : Pair }
interface Actuators { ^yield(v : nat) yield_() }
interface Shared { var ^with : nat var with_ : nat var ^nonlocal : Sort }
stm ^def { uses Sensors requires Actuators requires Shared var p : Pair
    initial i state ^global { } state global_ { } state name { }
    transition t0 { from i to ^global }
    transition t1 { from ^global to global_ trigger ^from ? ^nonlocal action ^yield(1) ; yield_() ; ^with = 3 ; with_ = 4 }
    transition t2 { from global_ to name trigger ^pass ? p }
}
)";

const char* const keywords_bench = R"(import def_controller as c
import robot as given

class Robot(c.def_):
    calls = ()
    def yield__(self, value):
        self.calls += (("yield", value),)
    def yield_(self):
        self.calls += ("yield_",)

robot = Robot()
robot.step()
assert robot.state() == c.def_.States.global__
robot.raise_from(c.Sort.is__)
robot.step()
assert robot.state() == c.def_.States.global_
assert robot.calls == (("yield", 1), "yield_"), robot.calls
assert (robot.with__, robot.with_) == (3, 4)
assert robot.nonlocal_ == c.Sort.is__ and robot.nonlocal_ != c.Sort.is_
assert [literal.name for literal in (c.Sort.None_, c.Sort.name_, c.Sort.value_)] == ["None_", "name_", "value_"]
robot.raise_pass(c.Pair(lambda__=1, lambda_=2))
robot.step()
assert robot.state().name == "name_"
given.main(3)
)";

TEST_F(Project, AModuleOfPythonChangesKeywords) {
    ROBOCHART_NEEDS(pybind_is_there(folder_), "pybind11 (Debian: pybind11-dev python3-dev)");
    emit(testing::load_model(keywords_model), "def", Target::python);
    build("-DPYTHON_EXECUTABLE=/usr/bin/python3");
    write("bench.py", keywords_bench);
    folder_.run("PYTHONPATH=build /usr/bin/python3 bench.py");
}

/// Names of elements that the projects, the headers and generated code use too.
const char* const awkward = R"(package time
enumeration Kind { BUFSIZ EOF left }
interface Sensors { event value : Kind event inputs event step : nat }
interface Actuators { ^state(Real : nat) tell(robot : real) }
interface Shared { var Int : nat var body : boolean }
stm Robot {
  uses Sensors requires Actuators requires Shared
  event ^result : nat var ^controller : Kind clock Console const argc : nat = 1
  initial main
  state At { entry ^state(argc); tell(0.5) during ^result!Int }
  state ROBOCHART_TRACE { entry Int = 1; body = true }
  transition t0 { from main to At }
  transition Step { from At to ROBOCHART_TRACE trigger value?^controller condition ^controller == Kind::BUFSIZ action #Console }
  transition advance { from ROBOCHART_TRACE to At trigger inputs condition since(Console) >= 1 }
  transition run { from At to At trigger step?Int }
}
)";

class AwkwardNames : public Project, public ::testing::WithParamInterface<Target> {};

/// Other tests build packages of ROS 2 and modules of Python with g++.
TEST_P(AwkwardNames, BuildWithBothCompilers) {
    if (GetParam() == Target::enki) ROBOCHART_NEEDS(enki_is_there(folder_), "Enki (Debian: libenki-dev)");
    if (GetParam() == Target::python)
        ROBOCHART_NEEDS(pybind_is_there(folder_), "pybind11 (Debian: pybind11-dev python3-dev)");
    emit(testing::load_model(awkward), "Robot", GetParam());
    std::string found;
    if (GetParam() == Target::ros2) found = " -DCMAKE_PREFIX_PATH=" + stub + "/cmake";
    if (GetParam() == Target::python) found = " -DPYTHON_EXECUTABLE=/usr/bin/python3";
    const bool slow = GetParam() == Target::ros2 || GetParam() == Target::python;
    const std::vector<std::string> compilers =
        slow ? std::vector<std::string>{"clang++"} : std::vector<std::string>{"g++", "clang++"};
    for (const std::string& compiler : compilers) {
        folder_.run("rm -rf build");
        build("-DCMAKE_CXX_COMPILER=" + compiler + " -DROBOCHART_TRACE=ON" + found);
    }
}

INSTANTIATE_TEST_SUITE_P(Targets, AwkwardNames,
                         ::testing::Values(Target::library, Target::main, Target::ros2, Target::enki, Target::python),
                         [](const auto& instance) {
                             switch (instance.param) {
                                 case Target::library:
                                     return "library";
                                 case Target::main:
                                     return "main";
                                 case Target::ros2:
                                     return "ros2";
                                 case Target::enki:
                                     return "enki";
                                 case Target::python:
                                     return "python";
                                 case Target::sources:
                                 case Target::argos:
                                     break;
                             }
                             return "sources";
                         });

}  // namespace
}  // namespace robochart::cpp_emit::project_test
