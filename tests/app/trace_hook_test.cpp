// SPDX-License-Identifier: Apache-2.0
// Tests logs that generated controllers write themselves (`emit cpp --target main`, then `--log FILE`). The model
// accepts the recorded runs and rejects altered ones.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "command.hpp"
#include "tests/contents.hpp"

namespace robochart::app::trace_hook_test {
namespace {

using tests::read_contents;

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::repository;
using testing::run;
using testing::TemporaryFile;

/// The console program of a model, built in its own folder.
class Console {
public:
    Console(const std::string& model, const std::string& component, std::vector<std::string> more = {})
        : model_(model) {
        std::vector<std::string> words{"emit",     "cpp",  model,   "--component",  component,
                                       "--target", "main", "--out", folder_ / "out"};
        words.insert(words.end(), more.begin(), more.end());
        const auto ran = run(words);
        EXPECT_EQ(ran.exit, 0) << ran.err;
        for (const auto& entry : fs::directory_iterator(folder_ / "out/main")) project_ = entry.path().string();
        // Compiles the sources with the hook, as cmake does (tests/cpp_emit builds projects with cmake).
        shell(
            "c++ -std=c++17 -O0 -Wall -Wextra -Wpedantic -Wconversion -Werror -DROBOCHART_TRACE=1 -I controller "
            "main.cpp controller/*.cpp -o console");
    }

    /// Runs the program with these input lines and a log. Returns its output.
    std::string drive(const std::string& lines, const std::string& options = "") {
        std::ofstream(project_ + "/lines") << lines;
        shell("./console --log run.trace " + options + " < lines > printed");
        return read_contents(project_ + "/printed");
    }
    /// Runs another program with the same controller, which writes run.trace.
    void run_program(const std::string& source) {
        std::ofstream(project_ + "/own.cpp") << source;
        shell(
            "c++ -std=c++17 -O0 -Wall -Wextra -Wpedantic -Wconversion -Werror -DROBOCHART_TRACE=1 -I controller "
            "own.cpp controller/*.cpp -o own && ./own");
    }
    [[nodiscard]] std::string log() const { return read_contents(project_ + "/run.trace"); }
    [[nodiscard]] testing::Ran check(const std::vector<std::string>& more = {}) const {
        std::vector<std::string> words{"conform", model_, "--traces", project_ + "/run.trace"};
        words.insert(words.end(), more.begin(), more.end());
        return run(words);
    }
    void corrupt(const std::string& what, const std::string& with) const { corrupt(log(), what, with); }
    void corrupt(std::string text, const std::string& what, const std::string& with) const {
        const std::size_t at = text.find(what);
        ASSERT_NE(at, std::string::npos) << text;
        std::ofstream(project_ + "/run.trace") << text.replace(at, what.size(), with);
    }

private:
    void shell(const std::string& command) const {
        EXPECT_EQ(std::system(("cd '" + project_ + "' && " + command).c_str()), 0) << command;
    }

    testing::Folder folder_;
    std::string model_, project_;
};

/// Tests the example of docs/traces.md.
TEST(TraceHook, ALogOfTheConsoleIsARunOfTheModel) {
    Console console(repository("corpus/aggregation"), "Aggregation");
    const std::string printed = console.drive("\nseeRobot\nseeRobot\nseeWall\n\n", "--coverage");
    EXPECT_THAT(
        console.log(),
        HasSubstr("robochart-trace 1\nmodel aggregation.rct\ncomponent aggregation::Aggregation\ncycle 1\nrun 1\n"
                  "angularSpeed!-0.75 linearSpeed!-10.88 tock\nseeRobot? angularSpeed!-5.02 linearSpeed!0 tock\n"));
    EXPECT_THAT(printed, HasSubstr(" transitions taken\n"));
    EXPECT_THAT(printed, HasSubstr("(aggregation.rct:"));
    const auto good = console.check();
    EXPECT_EQ(good.exit, 0) << good.out << good.err;
    EXPECT_THAT(good.out, HasSubstr("1 accepted, 0 rejected"));
    console.corrupt("angularSpeed!-5.02", "angularSpeed!-0.75");
    const auto bad = console.check();
    EXPECT_EQ(bad.exit, 1) << bad.out << bad.err;
    EXPECT_THAT(bad.out, HasSubstr("run 1, cycle 2"));
}

const char* const typed = R"(package p
enumeration Light { Red Green }
interface I { go(a : real, b : nat) lamp(l : Light) var level : int }
interface E { event see : Light event count : nat event quick : real event done : boolean }
stm M { requires I uses E var l : Light var n : nat var r : real initial i
    state A { entry go(0.5, 3) }
    final F
    transition t0 { from i to A }
    transition t1 { from A to A trigger see?l action lamp(l) ; level = level + 1 }
    transition t2 { from A to A trigger quick?r action go(r, 1) }
    transition t3 { from A to F trigger count?n action done!(level > 1) } }
)";

/// The log contains all kinds of words: a variable that the environment writes, termination, a typed event, an
/// operation with several arguments, a boolean.
TEST(TraceHook, EveryKindOfWord) {
    const TemporaryFile model("m.rct", typed);
    Console console(model.path(), "M");
    // In two cycles Green sets level to 2. Then the machine terminates.
    const std::string printed = console.drive("\nsee=1\nsee=1\n\ncount=1\n", "--coverage");
    EXPECT_THAT(console.log(), HasSubstr("component p::M\ncycle 1\nrun 1\n"
                                         "go!0.5!3 tock\n"
                                         "see?Green lamp!Green level!1 go!0.5!3 tock\n"
                                         "see?Green lamp!Green level!2 go!0.5!3 tock\n"
                                         "tock\n"
                                         "count?1 done!true terminate\n"));
    EXPECT_THAT(printed, HasSubstr("3 of 4 transitions taken\n  1  M::t0 (m.rct:8)\n  2  M::t1 (m.rct:9)\n  0  M::t2 "
                                   "(m.rct:10)\n  1  M::t3 (m.rct:11)\n"));
    const std::vector<std::string> reading{"--range", "nat=0..3", "--range", "int=0..3"};
    const auto good = console.check(reading);
    EXPECT_EQ(good.exit, 0) << good.out << good.err;
    console.corrupt("done!true", "done!false");
    EXPECT_EQ(console.check(reading).exit, 1);
}

const char* const with_parts = R"(package p
enumeration Colour { Red Green }
enumeration Job { Fetch(real, Colour) Drop }
datatype Pose { x : real near : boolean }
datatype Tag { number : nat }
interface I { go(p : Pose, path : Seq(nat)) mix(s : Set(Colour)) push(v : vector(nat, 2)) turn(m : matrix(nat, 1, 2)) tell(t : Tag) say(text : string) label(pair : nat * boolean) note(job : Job) }
interface E { event pose : Pose event path : Seq(nat) event seen : Set(Colour) event force : vector(nat, 2) event job : Job event echo : Pose event tag : Tag }
stm M { requires I uses E
    var p : Pose var q : Seq(nat) var s : Set(Colour) var v : vector(nat, 2) var m : matrix(nat, 1, 2) var j : Job var t : Tag
    initial i
    state A { entry say("left / right!") }
    state B { }
    transition t0 { from i to A }
    transition t1 { from A to B trigger path?q }
    transition t2 { from B to B trigger pose?p action go(p, q) ; echo!p }
    transition t3 { from B to B trigger seen?s action mix(s) }
    transition t4 { from B to B trigger force?v action v[1] = 2 ; push(v) ; m[1, 2] = v[2] ; turn(m) }
    transition t5 { from B to B trigger job?j action note(j) ; label((| 1, j == Job::Fetch(0.5, Colour::Red) |)) }
    transition t6 { from B to B trigger tag?t action tell(t) } }
)";

const char* const robot_with_parts = R"(#include "M.hpp"
#include "robochart/trace_file.hpp"
namespace core = p::M_core;
using Types = robochart::Deployment;
struct Robot : p::M {
    void say(robochart::String<31>) override {}
    void go(core::Pose<Types>, robochart::Sequence<std::int64_t, Types::longest>) override {}
    void mix(robochart::Set<core::Colour, 2>) override {}
    void push(robochart::Vector<std::int64_t, 2>) override {}
    void turn(robochart::Matrix<std::int64_t, 1, 2>) override {}
    void note(core::Job<Types>) override {}
    void label(core::Tuple_nat_boolean<Types>) override {}
    void tell_operation(core::Tag<Types>) override {}
};
int main() {
    Robot robot;
    robochart::TraceFile log(p::M::RunHeader());
    if (!log.open("run.trace")) return 1;
    robot.SetTracer(&log);
    robot.step();
    robot.raise_path(robochart::Sequence<std::int64_t, Types::longest>::of(2, 0));
    robot.step();
    robot.raise_pose(core::Pose<Types>::make(0.5, true));
    robot.raise_seen(robochart::Set<core::Colour, 2>::of(core::Colour::Green, core::Colour::Red));
    robot.step();
    robot.raise_force(robochart::Vector<std::int64_t, 2>::of(0, 1));
    robot.step();
    robot.raise_job(core::Job<Types>::Fetch(0.5, core::Colour::Red));
    robot.raise_tag(core::Tag<Types>::make(2));
    return robot.step() == robochart::StepResult::quiescent ? 0 : 2;
}
)";

/// Composite values are written in CSP's notation, as the code prints them: fields in the model's order, sets in the
/// order of their members, numbers as decimals. The model rejects a log with one altered component.
TEST(TraceHook, ValuesWithParts) {
    const TemporaryFile model("m.rct", with_parts);
    Console console(model.path(), "M");
    console.run_program(robot_with_parts);
    const std::string log = console.log();
    EXPECT_EQ(log,
              "robochart-trace 1\nmodel m.rct\ncomponent p::M\ncycle 1\nrun 1\n"
              "say!\"left\\040\\057\\040right\\041\" tock\n"
              "path?<2,0> tock\n"
              "pose?(0.5,true) seen?{Red,Green} go!(0.5,true)!<2,0> echo!(0.5,true) mix!{Red,Green} tock\n"
              "force?(0,1) push!(2,1) turn!(0,1) tock\n"
              "job?Fetch(0.5,Red) tag?2 note!Fetch(0.5,Red) label!(1,true) tell!2 tock\n");
    const auto good = console.check();
    EXPECT_EQ(good.exit, 0) << good.out << good.err;
    EXPECT_THAT(good.out, HasSubstr("1 accepted, 0 rejected"));
    for (const auto& [from, to, place] : std::vector<std::tuple<const char*, const char*, const char*>>{
             {"go!(0.5,true)!<2,0>", "go!(0.5,true)!<2,1>", "run.trace:8: run 1, cycle 3"},
             {"echo!(0.5,true)", "echo!(0.5,false)", "run.trace:8: run 1, cycle 3"},
             {"mix!{Red,Green}", "mix!{Green}", "run.trace:8: run 1, cycle 3"},
             {"push!(2,1)", "push!(1,2)", "run.trace:9: run 1, cycle 4"},
             {"note!Fetch(0.5,Red)", "note!Fetch(0.5,Green)", "run.trace:10: run 1, cycle 5"},
             {"path?<2,0>", "path?<2,0,1>", "run.trace:7: run 1, cycle 2"}}) {  // the list is longer than allowed
        console.corrupt(log, from, to);
        const auto bad = console.check();
        EXPECT_EQ(bad.exit, std::string(to) == "path?<2,0,1>" ? 3 : 1) << to << bad.out << bad.err;
        EXPECT_THAT(bad.out, HasSubstr(place));
    }
    console.corrupt(log, "turn!(0,1)", "turn!(0,one)");
    const auto wrong = console.check();
    EXPECT_EQ(wrong.exit, 2);
    EXPECT_THAT(wrong.err, HasSubstr("turn carries a number, found `one`"));
}

/// The console reads values in the format in which it prints them. It also accepts the numbers of literals.
TEST(TraceHook, TheConsoleReadsAndShowsValuesWithParts) {
    const TemporaryFile model("m.rct", with_parts);
    Console console(model.path(), "M");
    const std::string printed =
        console.drive("\npath=<2,0>\nseen={Green,0} pose=(0.5,true)\nforce=(0,1)\njob=Fetch(0.5,Red) tag=2\n");
    EXPECT_THAT(printed, HasSubstr("  go((0.5,true), <2,0>)\n  mix({Red,Green})\n  state B echo!(0.5,true) p = "
                                   "(0.5,true) q = <2,0> s = {Red,Green}"));
    EXPECT_THAT(printed, HasSubstr("  note(Fetch(0.5,Red))\n  label((1,true))\n  tell(2)\n"));
    EXPECT_THAT(
        console.log(),
        HasSubstr("pose?(0.5,true) seen?{Red,Green} go!(0.5,true)!<2,0> echo!(0.5,true) mix!{Red,Green} tock\n"));
    EXPECT_EQ(console.check().exit, 0);
    // No input line contains a value of its type, so no event is raised.
    console.drive(
        "\npath=<2,\npath=<2,0>x pose=(1) pose=(1,yes) seen={Blue} seen=<Red> force=(1,2,3) job=Fetch(1) job=Fetch "
        "tag=\n");
    EXPECT_THAT(console.log(), HasSubstr("run 1\nsay!\"left\\040\\057\\040right\\041\" tock\ntock\ntock\n"));
}

/// A program without the hook rejects `--log` with a message.
TEST(TraceHook, WithoutTheHookALogIsRefused) {
    const TemporaryFile model("m.rct", typed);
    const auto ran =
        run({"emit", "cpp", model.path(), "--component", "M", "--target", "main", "--out", model.path() + ".out"});
    ASSERT_EQ(ran.exit, 0) << ran.err;
    const std::string folder = model.path() + ".out/main/M";
    EXPECT_EQ(
        std::system(
            ("cd '" + folder + "' && c++ -std=c++17 -O0 -I controller main.cpp controller/*.cpp -o console").c_str()),
        0);
    EXPECT_NE(std::system(("cd '" + folder + "' && ./console --log run.trace < /dev/null 2> reported").c_str()), 0);
    EXPECT_THAT(read_contents(folder + "/reported"), HasSubstr("-DROBOCHART_TRACE=ON"));
    EXPECT_FALSE(fs::exists(folder + "/run.trace"));
}

}  // namespace
}  // namespace robochart::app::trace_hook_test
