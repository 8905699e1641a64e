// SPDX-License-Identifier: Apache-2.0
// Tests the verbs with RoboSim components. Each verb handles them or says that it does not.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "app/command/option_table.hpp"
#include "command.hpp"
#include "tests/contents.hpp"

namespace robochart::app::robosim_test {
namespace {

using ::testing::AllOf;
using testing::Folder;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::Ran;
using testing::run;
using tests::read_contents;

const char* const interfaces = R"(package lamps
interface Button { event pressed }
interface Light { lit(bright : boolean) }
)";

/// Returns a lamp that is on for one cycle after the button was pressed. It enters Off again in every cycle.
std::string lamp(const std::string& cycle) {
    return std::string(interfaces) + R"(
stm Lamp {
    cycleDef cycle == )" +
           cycle + R"(
    input context { uses Button }
    output context { requires Light }
    initial i
    state Off { entry $lit(false) }
    state On { entry $lit(true) }
    transition t0 { from i to Off }
    transition t1 { from Off to On exec condition $pressed }
    transition t2 { from Off to Off exec condition not $pressed }
    transition t3 { from On to Off exec }
}
)";
}

/// A RoboChart machine with the same qualified name, in a file of the same package.
const char* const chart = R"(package lamps
stm Lamp {
    uses Button
    requires Light
    initial i
    state Off { entry lit(false) }
    state On { entry lit(true) }
    transition t0 { from i to Off }
    transition t1 { from Off to On trigger pressed }
    transition t2 { from On to Off trigger pressed }
}
)";

// ---------------------------------------------------------------- names

TEST(RoboSimVerbs, ComponentsOfBothNotationsAreKeptApart) {
    const Folder folder({{"lamp.rst", lamp("1")}, {"lamp.rct", chart}});
    const Ran both = run({"conform", folder.path(), "-q"});
    EXPECT_EQ(both.exit, 0) << both.out << both.err;
    EXPECT_THAT(both.out, HasSubstr("2 of 2 controllers conform"));
    const Ran named = run({"conform", folder.path()});
    EXPECT_THAT(named.out, AllOf(HasSubstr("robochart:lamps::Lamp"), HasSubstr("robosim:lamps::Lamp")));
    const Ran one = run({"conform", folder.path(), "--component", "robosim:lamps::Lamp"});
    EXPECT_THAT(one.out, AllOf(HasSubstr("1 of 1 controllers conform"), Not(HasSubstr("events dispatched"))));
    const Ran chart_alone = run({"conform", folder.path(), "--component", "robochart:Lamp"});
    EXPECT_THAT(chart_alone.out, AllOf(HasSubstr("1 of 1 controllers conform"), HasSubstr("events dispatched")));
    const Ran written = run({"emit", "cpp", folder.path(), "-o", folder / "out"});
    EXPECT_EQ(written.exit, 0) << written.err;
    EXPECT_THAT(written.out, AllOf(HasSubstr("cpp/Lamp/"), HasSubstr("cpp/Lamp_robosim/")));
    const Ran stepped = run({"step", folder.path(), "Lamp"});
    EXPECT_EQ(stepped.exit, 4);
    EXPECT_THAT(stepped.err, AllOf(HasSubstr("robochart:lamps::Lamp"), HasSubstr("robosim:lamps::Lamp")));
    const Ran chosen = run({"step", folder.path(), "robosim:Lamp"}, "cycle pressed\n");
    EXPECT_EQ(chosen.exit, 0) << chosen.err;
    EXPECT_THAT(chosen.out, HasSubstr("cycle 1   in {pressed}  out <lit(false)>"));
}

/// A command for RoboChart does not fail if another part has only RoboSim.
TEST(RoboSimVerbs, APartWithoutRoboChartIsLeftOutByCommandsForRoboChart) {
    const Folder folder({{"lamp.rst", lamp("1")},
                         {"other.rct",
                          "package other\ninterface I { event go }\nstm M { uses I initial i state A { } "
                          "transition t0 { from i to A } transition t1 { from A to A trigger go } }\n"}});
    const Ran one = run({"conform", folder.path(), "--component", "other::M", "-q"});
    EXPECT_EQ(one.exit, 0) << one.out << one.err;
    const Ran both = run({"conform", folder.path(), "-q"});
    EXPECT_EQ(both.exit, 0) << both.out << both.err;
    EXPECT_THAT(both.out, HasSubstr("2 of 2 controllers conform"));
    const Ran alone = run({"emit", "prism", folder / "lamp.rst"});
    EXPECT_EQ(alone.exit, 2);
    EXPECT_THAT(alone.err, HasSubstr("RC-S26"));
}

// ---------------------------------------------------------------- options and claims

TEST(RoboSimVerbs, VerifyRunsAllSteps) {
    const Folder folder(
        {{"lamp.rst", lamp("1")}, {"lamp.rsa", "import lamps::*\nassertion A : Lamp is deadlock-free\n"}});
    const Ran ran = run({"verify", folder.path(), "-o", folder / "out"});
    EXPECT_EQ(ran.exit, 0) << ran.out << ran.err;
    EXPECT_THAT(ran.out, AllOf(HasSubstr("1 of 1 checks hold"), HasSubstr("conforms     lamps::Lamp"),
                               HasSubstr("Lamp_core.hpp")));
}

TEST(RoboSimVerbs, TheStatesOfTheCodeAreExported) {
    const Folder folder({{"lamp.rst", lamp("1")}});
    const Ran states = run({"conform", folder.path(), "--export", folder / "code.aut"});
    EXPECT_EQ(states.exit, 0) << states.err;
    EXPECT_THAT(read_contents(folder / "code.aut"), HasSubstr("registerWrite.wrote__litCall.true"));
    const Ran script = run({"conform", folder.path(), "--export", folder / "code.csp"});
    EXPECT_EQ(script.exit, 2);
    EXPECT_THAT(script.err, HasSubstr("there is no normal form"));
}

TEST(RoboSimVerbs, ClaimsAboutCyclesAreDecidedAndOthersRefused) {
    const Folder folder({{"lamp.rst", lamp("1")},
                         {"lamp.claims",
                          "import lamps::*\nclaim Dark : in a cycle with pressed, never lit(true)\n"
                          "claim Lights : in a cycle with pressed, always in On\n"}});
    const Ran ran = run({"conform", folder.path()});
    EXPECT_EQ(ran.exit, 1) << ran.out << ran.err;
    EXPECT_THAT(ran.out, AllOf(HasSubstr("Dark"), HasSubstr("Lights")));
    const Folder others({{"lamp.rst", lamp("1")},
                         {"lamp.claims", "import lamps::*\nclaim Soon : pressed leads to lit(true) within 3 units\n"}});
    for (const char* verb : {"check", "conform"}) {
        const Ran refused = run({verb, others.path()});
        EXPECT_EQ(refused.exit, 2);
        EXPECT_THAT(refused.err, AllOf(HasSubstr("CLM-T15"), HasSubstr("is written in RoboSim"), HasSubstr(":2:")));
    }
    const Folder ordered({{"lamp.rst", lamp("1")}, {"lamp.claims", "import lamps::*\norder Lamp : pressed first\n"}});
    const Ran order = run({"conform", ordered.path()});
    EXPECT_EQ(order.exit, 2);
    EXPECT_THAT(order.err, AllOf(HasSubstr("CLM-T15"), HasSubstr("is written in RoboSim")));
}

TEST(RoboSimVerbs, TheReportOfALimitSaysThatNoWalksFollow) {
    const Folder folder({{"lamp.rst", lamp("1")}});
    const Ran ran = run({"conform", folder.path(), "--max-states", "2"});
    EXPECT_EQ(ran.exit, 3) << ran.out << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("no random walks follow"));
}

// ---------------------------------------------------------------- every verb and option

const char* const scenario = R"(scenario Blink for Lamp {
    step 0.2 s
    unit 0.1 s
    physics 0.1 s
    duration 3 s
    trials 1
    seed 1
    arena 100 cm by 100 cm
    robots 2 { radius 5 cm axle 8 cm wheel 10 cm/s place random in arena }
    stimulus pressed at 1 s
    ignore lit
}
)";

const char* const rules = R"(def_start
    event pressed
    event lit
def_end
rule_start
    R1 when pressed then lit within 2 seconds
rule_end
)";

/// What a verb does with a model that has only RoboSim: an exit code, and a text that it prints.
struct Handling {
    std::vector<std::string> arguments;  ///< "DIR" is the folder of the model, lamp.rst
    int exit = 0;
    const char* says = "";
};

/// By the full name of a verb. Verbs that read no model of a robot have no arguments here.
const std::map<std::string, Handling>& handlings() {
    static const std::map<std::string, Handling> table{
        {"verify", {{"verify", "DIR", "-o", "DIR/out"}, 0, "conforms     lamps::Lamp"}},
        {"init", {}},
        {"validate", {{"validate", "DIR"}, 0, "valid"}},
        {"check", {{"check", "DIR"}, 0, "timelock-free"}},
        {"emit csp", {{"emit", "csp", "DIR", "-o", "DIR/out"}, 0, "csp-gen/timed/"}},
        {"emit cpp", {{"emit", "cpp", "DIR", "-o", "DIR/out"}, 0, "Lamp_core.hpp"}},
        {"emit prism", {{"emit", "prism", "DIR"}, 2, "RC-S26"}},
        {"emit monitor", {{"emit", "monitor", "DIR", "-o", "DIR/out"}, 0, "Lamp_monitor.hpp"}},
        {"emit rst", {{"emit", "rst", "DIR"}, 2, "RC-S26"}},
        {"emit tests", {{"emit", "tests", "DIR", "-o", "DIR/out"}, 0, "Lamp.trace"}},
        {"conform", {{"conform", "DIR"}, 0, "1 of 1 controllers conform"}},
        {"cspm", {}},
        {"prism", {}},
        {"rules", {{"rules", "DIR/lamp.sleec", "DIR"}, 2, "RC-S26"}},
        {"step", {{"step", "DIR"}, 0, "input pressed"}},
        {"draw", {{"draw", "DIR", "-o", "DIR/drawn"}, 0, "Lamp.svg"}},
        {"simulate", {{"simulate", "DIR/blink.scenario", "--no-pictures"}, 0, "controller Lamp"}},
        {"tune", {{"tune", "DIR/blink.scenario"}, 2, "RC-S26"}},
        {"format", {{"format", "DIR/lamp.rst"}, 0, ""}},
        {"explain", {}},
        {"lsp", {}},
        {"help", {}},
        {"version", {}},
    };
    return table;
}

std::vector<std::string> in_folder(std::vector<std::string> arguments, const Folder& folder) {
    for (std::string& argument : arguments)
        if (argument.starts_with("DIR")) argument.replace(0, 3, folder.path());
    return arguments;
}

void expect_handled(const Handling& handling, const Folder& folder) {
    const std::vector<std::string> arguments = in_folder(handling.arguments, folder);
    const Ran ran = run(arguments);
    std::string line;
    for (const std::string& argument : arguments) line += argument + " ";
    EXPECT_EQ(ran.exit, handling.exit) << line << "\n" << ran.out << ran.err;
    EXPECT_THAT(ran.out + ran.err, HasSubstr(handling.says)) << line;
}

TEST(RoboSimVerbs, EachVerbHandlesRoboSimOrRefusesIt) {
    std::size_t verbs = 0;
    for (const VerbRow& row : verb_table()) {
        const auto handling = handlings().find(full_name(row));
        ASSERT_NE(handling, handlings().end()) << full_name(row) << " is not in the table of this test";
        ++verbs;
        if (handling->second.arguments.empty()) continue;
        const Folder folder({{"lamp.rst", lamp("2")}, {"blink.scenario", scenario}, {"lamp.sleec", rules}});
        expect_handled(handling->second, folder);
    }
    EXPECT_EQ(verbs, handlings().size());
}

/// Options that are about RoboChart only, or about the untimed semantics, are refused with the reason.
TEST(RoboSimVerbs, NoOptionIsIgnored) {
    const std::vector<Handling> options{
        {{"check", "DIR", "--core"}, 0, "timelock-free"},
        {{"check", "DIR", "--untimed"}, 2, "RoboSim has no untimed semantics"},
        {{"check", "DIR", "--print", "script"}, 2, "`--print timed-script` prints it"},
        {{"emit", "csp", "DIR", "--untimed", "-o", "DIR/out"}, 2, "its semantics is timed"},
        {{"emit", "cpp", "DIR", "--strategy", "table", "-o", "DIR/out"}, 4, "--strategy is about code"},
        {{"emit", "cpp", "DIR", "--strategy", "switch", "-o", "DIR/out"}, 4, "--strategy is about code"},
        {{"emit", "cpp", "DIR", "--strategy", "auto", "-o", "DIR/out"}, 0, "Lamp_core.hpp"},
        {{"emit", "prism", "DIR", "--component", "Lamp"}, 2, "RC-S26"},
        {{"rules", "DIR/lamp.sleec", "DIR", "--component", "Lamp"}, 4, "it is written in RoboSim"},
        {{"step", "DIR", "--untimed"}, 4, "no untimed semantics"},
        {{"conform", "DIR", "--model", "tick-tock"}, 0, "1 of 1 controllers conform"},
        {{"conform", "DIR", "--all-choices"}, 0, "1 of 1 controllers conform"},
        {{"emit", "cpp", "DIR", "--choices", "-o", "DIR/out"}, 0, "console_choices.hpp"},
    };
    for (const Handling& option : options) {
        const Folder folder({{"lamp.rst", lamp("2")}, {"lamp.sleec", rules}});
        expect_handled(option, folder);
    }
}

/// A machine that waits for the button cannot end its cycle without it.
TEST(RoboSimVerbs, CorePropertiesOfRoboSimFindStoppedTime) {
    std::string waiting = lamp("1");
    waiting.erase(waiting.find("    transition t2"),
                  waiting.find("    transition t3") - waiting.find("    transition t2"));
    const Folder folder({{"lamp.rst", waiting}});
    const Ran ran = run({"check", folder.path()});
    EXPECT_EQ(ran.exit, 1) << ran.out << ran.err;
    EXPECT_THAT(ran.out,
                AllOf(HasSubstr("FAILS        timelock-free"), HasSubstr("cycle 1   in {}  out <lit(false)>")));
    std::string no_length = lamp("1");
    no_length.erase(no_length.find("    cycleDef cycle == 1"), std::string("    cycleDef cycle == 1").size());
    const Folder open({{"lamp.rst", no_length}});
    const Ran without_length = run({"check", open.path(), "--core"});
    EXPECT_THAT(without_length.out, HasSubstr("has no cycleDef")) << without_length.err;
}

/// The block has a process of the machine, with the events of the machine, and renames them to those of the controller.
/// No note is about the events that are renamed.
TEST(RoboSimVerbs, NotesNameNoEventsThatABlockReplaces) {
    const std::string controller =
        "controller C {\n    cycleDef cycle == 1\n    uses Button\n    requires Light\n    sref s = Lamp\n"
        "    connection C on pressed to s on pressed\n}\n";
    const std::string block = R"(import lamps::*
csp Spec csp-begin
Off = lamps::Lamp::registerRead.lamps::Lamp::i_pressed?b -> lamps::Lamp::registerWrite.lamps::Lamp::o_lit.false ->
      lamps::Lamp::endexec -> tock -> (if b then On else Off)
On = lamps::Lamp::registerRead.lamps::Lamp::i_pressed?b -> lamps::Lamp::registerWrite.lamps::Lamp::o_lit.true ->
     lamps::Lamp::endexec -> tock -> Off
Spec = Off[[lamps::Lamp::registerRead.lamps::Lamp::i_pressed.b <- lamps::C::registerRead.lamps::C::i_pressed.b | b <- Bool]]
          [[lamps::Lamp::registerWrite.lamps::Lamp::o_lit.b <- lamps::C::registerWrite.lamps::C::o_lit.b | b <- Bool]]
          [[lamps::Lamp::endexec <- lamps::C::endexec]]
csp-end
assertion A : C equals Spec
)";
    const Folder folder({{"lamp.rst", lamp("1") + controller}, {"lamp.rsa", block}});
    const Ran ran = run({"check", folder.path()});
    EXPECT_EQ(ran.exit, 0) << ran.out << ran.err;
    EXPECT_THAT(ran.out, Not(HasSubstr("never asked")));
}

// ---------------------------------------------------------------- cycles

/// The model begins in Off, and enters Off again after every cycle without the button.
TEST(RoboSimVerbs, StepRunsCycles) {
    const Folder folder({{"lamp.rst", lamp("2")}});
    const Ran ran = run({"step", folder.path()}, "cycle\ncycle pressed\ncycle\nway\n");
    EXPECT_EQ(ran.exit, 0) << ran.err;
    EXPECT_THAT(ran.out, AllOf(HasSubstr("cycle 1   in {}  out <lit(false)>"),
                               HasSubstr("cycle 2   in {pressed}  out <lit(false)>"),
                               HasSubstr("cycle 3   in {}  out <lit(true)>"), HasSubstr("t=6")));
    for (const char* wrong : {"cycle knob\n", "cycle pressed=3\n"}) {
        const Ran refused = run({"step", folder.path()}, wrong);
        EXPECT_EQ(refused.exit, 1) << wrong;
    }
    const Ran untimed = run({"step", folder.path(), "--untimed"}, "");
    EXPECT_EQ(untimed.exit, 4);
    EXPECT_THAT(untimed.err, HasSubstr("no untimed semantics"));
}

TEST(RoboSimVerbs, CounterexamplesShowCycles) {
    const Folder folder(
        {{"lamp.rst", lamp("1")},
         {"lamp.rsa",
          "import lamps::*\ncsp Dark csp-begin\n"
          "Dark = lamps::Lamp::registerRead.lamps::Lamp::i_pressed?b -> "
          "lamps::Lamp::registerWrite.lamps::Lamp::o_lit.false -> lamps::Lamp::endexec -> tock -> Dark\n"
          "csp-end\nassertion A : Lamp refines Dark\n"}});
    const Ran ran = run({"check", folder.path(), "--json", folder / "a.json", "--html", folder / "a.html"});
    EXPECT_EQ(ran.exit, 1) << ran.out << ran.err;
    EXPECT_THAT(ran.out, AllOf(HasSubstr("cycle 1   in {pressed}  out <lit(false)>"), HasSubstr("cycle 2   in {}")));
    const auto json = nlohmann::json::parse(read_contents(folder / "a.json"));
    const auto& cycles = json["assertions"][0]["counterexample"]["cycles"];
    ASSERT_GE(cycles.size(), 2U) << json.dump(1);
    EXPECT_EQ(cycles[0]["inputs"], nlohmann::json::array({"pressed"}));
    EXPECT_EQ(cycles[0]["outputs"], nlohmann::json::array({"lit(false)"}));
    EXPECT_EQ(cycles[1]["time"], 1);
    EXPECT_THAT(read_contents(folder / "a.html"), HasSubstr("<td>pressed</td><td>lit(false)</td>"));
}

// ---------------------------------------------------------------- logs and robots

TEST(RoboSimVerbs, LogsAreComparedWithTheComponent) {
    const Folder folder({{"lamp.rst", lamp("2")}});
    const Ran saved =
        run({"step", folder.path()}, "cycle\ncycle pressed\ncycle\nsave " + (folder / "run.trace") + "\n");
    EXPECT_EQ(saved.exit, 0) << saved.err;
    const Ran accepted = run({"conform", folder.path(), "--traces", folder / "run.trace"});
    EXPECT_EQ(accepted.exit, 0) << accepted.out << accepted.err << read_contents(folder / "run.trace");
    EXPECT_THAT(accepted.out, HasSubstr("3 cycles: 1 accepted"));
    const std::string head = "robochart-trace 1\ncomponent lamps::Lamp\ncycle 2\nrun a\n";
    std::ofstream(folder / "wrong.trace") << head << "pressed? lit!false tock tock\nlit!false tock tock\n";
    const Ran rejected = run({"conform", folder.path(), "--traces", folder / "wrong.trace"});
    EXPECT_EQ(rejected.exit, 1) << rejected.out << rejected.err;
    EXPECT_THAT(rejected.out, AllOf(HasSubstr("cycle 2"), HasSubstr("lit(true)")));
    std::ofstream(folder / "early.trace") << head << "lit!false tock lit!false tock\n";
    EXPECT_EQ(run({"conform", folder.path(), "--traces", folder / "early.trace"}).exit, 1)
        << "an output between the two time units of a cycle";
    std::ofstream(folder / "late.trace") << head << "late\nlit!true tock tock\nlit!false tock tock\n";
    EXPECT_EQ(run({"conform", folder.path(), "--traces", folder / "late.trace"}).exit, 0);
    const Ran loaded = run({"step", folder.path()}, "load " + (folder / "run.trace") + "\n");
    EXPECT_EQ(loaded.exit, 0) << loaded.err;
    EXPECT_THAT(loaded.out, HasSubstr("t=6"));
}

TEST(RoboSimVerbs, MonitorsAndTestSuitesAreWritten) {
    const Folder folder({{"lamp.rst", lamp("2")}});
    const Ran monitor = run({"emit", "monitor", folder.path(), "-o", folder / "out"});
    EXPECT_EQ(monitor.exit, 0) << monitor.out << monitor.err;
    EXPECT_THAT(monitor.out, HasSubstr("Lamp_monitor.hpp"));
    const Ran suite = run({"emit", "tests", folder.path(), "-o", folder / "out"});
    EXPECT_EQ(suite.exit, 0) << suite.out << suite.err;
    const Ran accepted = run({"conform", folder.path(), "--traces", folder / "out/tests/Lamp/Lamp.trace"});
    EXPECT_EQ(accepted.exit, 0) << accepted.out << accepted.err;
}

/// Its output in a cycle is the value of a variable.
const char* const dimmer = R"(package dims
interface Level { var level : int }
interface Light { lit(bright : int) }
stm Dimmer {
    cycleDef cycle == 1
    input context { requires Level }
    output context { requires Light }
    initial i
    state S { entry $lit($level) }
    transition t0 { from i to S }
    transition t1 { from S to S exec }
}
)";

/// A variable keeps its last value, and begins with the default of its type, for every command that reads logs.
TEST(RoboSimVerbs, VariablesKeepTheirValues) {
    const Folder folder({{"dimmer.rst", std::string(dimmer)}});
    const Ran stepped = run({"step", folder.path()}, "cycle\ncycle level=2\ncycle\n");
    EXPECT_EQ(stepped.exit, 0) << stepped.err;
    EXPECT_THAT(stepped.out, AllOf(HasSubstr("cycle 1   in {level = 0}  out <lit(0)>"),
                                   HasSubstr("cycle 2   in {level = 2}  out <lit(2)>"),
                                   HasSubstr("cycle 3   in {level = 2}  out <lit(2)>")));
    const std::string head = "robochart-trace 1\ncomponent dims::Dimmer\ncycle 1\nrun a\n";
    std::ofstream(folder / "good.trace") << head << "lit!0 tock\nlevel?2 lit!2 tock\nlit!2 tock\n";
    std::ofstream(folder / "wrong.trace") << head << "lit!0 tock\nlevel?2 lit!2 tock\nlit!0 tock\n";
    const Ran loaded = run({"step", folder.path()}, "load " + (folder / "good.trace") + "\n");
    EXPECT_EQ(loaded.exit, 0) << loaded.err;
    EXPECT_THAT(loaded.out, HasSubstr("t=3"));
    const Ran other = run({"step", folder.path()}, "load " + (folder / "wrong.trace") + "\n");
    EXPECT_EQ(other.exit, 1);
    EXPECT_THAT(other.err, HasSubstr("cycle 3 cannot be followed"));
    const Ran accepted = run({"conform", folder.path(), "--traces", folder / "good.trace"});
    EXPECT_EQ(accepted.exit, 0) << accepted.out << accepted.err;
    EXPECT_EQ(run({"conform", folder.path(), "--traces", folder / "wrong.trace"}).exit, 1);
    const Ran monitor = run({"emit", "monitor", folder.path(), "-o", folder / "out"});
    EXPECT_EQ(monitor.exit, 0) << monitor.out << monitor.err;
    const Ran suite = run({"emit", "tests", folder.path(), "-o", folder / "out"});
    EXPECT_EQ(suite.exit, 0) << suite.out << suite.err;
    const Ran own = run({"conform", folder.path(), "--traces", folder / "out/tests/Dimmer/Dimmer.trace"});
    EXPECT_EQ(own.exit, 0) << own.out << own.err;
}

/// A variable that the machine writes itself has the value that was written.
TEST(RoboSimVerbs, WritesOfTheMachineAreKept) {
    const Folder folder(
        {{"count.rst",
          std::string("package p\ninterface N { var n : nat }\nstm S {\n    cycleDef cycle == 1\n"
                      "    input context { requires N }\n    output context { requires N }\n    initial i\n"
                      "    state A { entry $n = $n + 1 }\n    transition t0 { from i to A }\n"
                      "    transition t1 { from A to A exec }\n}\n")}});
    std::ofstream(folder / "count.trace") << "robochart-trace 1\ncomponent p::S\ncycle 1\nrun a\n"
                                             "n!1 tock\nn!2 tock\nn?0 n!1 tock\nn!2 tock\n";
    const Ran loaded = run({"step", folder.path()}, "load " + (folder / "count.trace") + "\n");
    EXPECT_EQ(loaded.exit, 0) << loaded.err;
    EXPECT_EQ(run({"conform", folder.path(), "--traces", folder / "count.trace"}).exit, 0);
    EXPECT_THAT(run({"step", folder.path()}, "cycle\ncycle\n").out, HasSubstr("cycle 2   in {n = 1}  out <n = 2>"));
}

/// An input that no connection fills is read without the environment. `cycle` gives its content, too.
TEST(RoboSimVerbs, StepFillsUnconnectedInputs) {
    const Folder folder(
        {{"open.rst", std::string("package p\nstm A {\n    cycleDef cycle == 1\n    input context { event e }\n"
                                  "    output context { event yes }\n    initial i\n    state S { }\n"
                                  "    transition t0 { from i to S }\n"
                                  "    transition t1 { from S to S condition $e action $yes ; exec }\n"
                                  "    transition t2 { from S to S condition not $e action exec }\n}\n"
                                  "controller C {\n    cycleDef cycle == 1\n    event yes\n    sref a = A\n"
                                  "    connection a on yes to C on yes\n}\n")}});
    const Ran ran = run({"step", folder.path(), "C"}, "cycle\ncycle e\ncycle\n");
    EXPECT_EQ(ran.exit, 0) << ran.err;
    EXPECT_THAT(ran.out, AllOf(HasSubstr("cycle 1   in {}  out <>"), HasSubstr("cycle 2   in {}  out <yes>"),
                               HasSubstr("cycle 3   in {}  out <>")));
}

/// The model accepts the logs of the robots that it describes, but rejects those of robots whose lamp is on when it
/// should be off.
TEST(RoboSimVerbs, RobotsOfAScenarioRunInCycles) {
    const Folder folder({{"lamp.rst", lamp("2")}, {"blink.scenario", scenario}});
    const Ran ran =
        run({"simulate", folder / "blink.scenario", "--no-pictures", "--log", folder / "logs", "--monitor"});
    EXPECT_EQ(ran.exit, 0) << ran.out << ran.err;
    const std::string log = read_contents(folder / "logs/trial-01/robot-00.trace");
    EXPECT_THAT(log, AllOf(HasSubstr("pressed?"), HasSubstr("lit!true")));
    const Ran accepted = run({"conform", folder.path(), "--traces", folder / "logs"});
    EXPECT_EQ(accepted.exit, 0) << accepted.out << accepted.err;
    EXPECT_THAT(accepted.out, HasSubstr("2 accepted"));
    std::string swapped = lamp("2");
    swapped.replace(swapped.find("$lit(true)"), 10, "$lit(false)");
    const Folder other({{"lamp.rst", swapped}});
    EXPECT_EQ(run({"conform", other.path(), "--traces", folder / "logs"}).exit, 1);
    const Folder unequal({{"lamp.rst", lamp("1")}, {"blink.scenario", scenario}});
    const Ran refused = run({"simulate", unequal / "blink.scenario", "--no-pictures"});
    EXPECT_EQ(refused.exit, 2) << refused.out;
    EXPECT_THAT(refused.err, AllOf(HasSubstr("RC-M03"), HasSubstr("1 time units"), HasSubstr("is 2")));
}

}  // namespace
}  // namespace robochart::app::robosim_test
