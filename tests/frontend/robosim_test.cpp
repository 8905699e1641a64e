// SPDX-License-Identifier: Apache-2.0
// Tests RoboSim: what its files may contain, how names after `$` resolve, that both dialects share names, that wrong
// input gives one finding with its place, and that the public models load, print and format. The pages of the rules
// (docs/rules/RC-Y*.md) have further examples.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "fixture.hpp"
#include "frontend/format/format.hpp"
#include "frontend/project/occurrences.hpp"
#include "frontend/syntax/print.hpp"

namespace robochart::frontend {
namespace {

namespace fs = std::filesystem;
using testing::Reading;

/// Parses and resolves files as one project.
std::unique_ptr<Reading> resolved(const std::vector<std::pair<std::string, std::string>>& files) {
    auto reading = std::make_unique<Reading>();
    for (const auto& [path, text] : files) {
        const auto id = reading->sources.add(path, text);
        reading->model.files.push_back(parse(reading->sources, id, is_assertion_path(path), reading->findings));
    }
    resolve(reading->model, reading->findings);
    return reading;
}

std::unique_ptr<Reading> resolved(const std::string& text) {
    return resolved({{"t.rst", text}});
}

const std::string lamp = R"(package Lamp
interface Button { event pressed }
interface Light { lit(bright : boolean) }
interface Level { var level : nat }
stm Switch {
	cycleDef cycle == 1
	clock since_press
	const most : nat = 3
	var n : nat = 0
	input context { uses Button event dim : nat requires Level }
	output context { requires Light requires Level event done : nat }
	initial i
	state Off { entry $lit(false) ; $level = 0 }
	state On { entry $lit(true) ; $level = $level + 1 exit $done!n }
	transition t0 { from i to Off }
	transition t1 { from Off to On exec condition $pressed action #since_press }
	transition t2 { from Off to Off condition not $pressed action exec }
	transition t3 { from On to Off exec condition since(since_press) >= most * cycle }
	transition t4 { from On to On exec condition $dim?n : (n > 1) /\ $level < 2 }
	transition t5 { from On to On exec condition $dim?$level }
	transition t6 { from On to On exec }
}
)";

const std::string lamp_claims =
    R"(assertion A0 : Lamp::Switch is deadlock-free with cycleDef of Lamp::Switch set to 2, and constant most of Lamp::Switch set to 1
assertion A1 : Lamp::Switch refines N in the tick-tock model with cycleDef of N set to 2 and cycleDef of Lamp::Switch set to 2
assertion A2 : N is not schedulable
simulation N of Chart { cycleDef { cycle == 1 } input context { uses Lamp::Button } output context { requires Lamp::Light } }
)";

const std::string chart = R"(stm Chart {
	uses Lamp::Button
	requires Lamp::Light
	initial i
	state Off { entry lit(false) }
	transition t0 { from i to Off }
	transition t1 { from Off to Off trigger pressed }
}
)";

TEST(RoboSim, AModelWithEveryConstructHasNoFindings) {
    const auto reading = resolved({{"lamp.rst", lamp}, {"chart.rct", chart}, {"claims.rsa", lamp_claims}});
    EXPECT_EQ(reading->codes(), "") << reading->report();
    EXPECT_EQ(reading->dumped(true).find("-> nothing"), std::string::npos) << reading->dumped(true);
}

/// The printed text parses to the same tree.
TEST(RoboSim, PrintsWhatItReads) {
    for (const auto& [path, text] : {std::pair("lamp.rst", lamp), std::pair("claims.rsa", lamp_claims)}) {
        const auto reading = resolved({{path, text}});
        const std::string printed = to_text(reading->file());
        const auto again = resolved({{path, printed}});
        EXPECT_FALSE(again->file().has_syntax_errors) << printed;
        EXPECT_EQ(to_text(again->file()), printed);
        if (is_model_path(path)) {
            EXPECT_EQ(again->dumped(), reading->dumped());
        }
        EXPECT_NE(printed.find(is_model_path(path) ? "$dim?n : (n > 1)" : "cycleDef of N set to 2"), std::string::npos)
            << printed;
    }
}

TEST(RoboSim, NamesAfterTheSignAreRegisters) {
    const auto reading = resolved(lamp);
    std::map<std::string, std::set<Access>> uses;
    for (const Occurrence& occurrence : find_occurrences(reading->model))
        if (occurrence.target != nullptr && !occurrence.declares)
            uses[occurrence.target->name].insert(occurrence.access);
    EXPECT_EQ(uses["pressed"], std::set{Access::read});
    EXPECT_EQ(uses["dim"], std::set{Access::read});
    EXPECT_EQ(uses["done"], std::set{Access::write});
    EXPECT_EQ(uses["level"], (std::set{Access::read, Access::write}));
    EXPECT_EQ(uses["n"], (std::set{Access::read, Access::write})) << "stored by `$dim?n`, read by `$done!n`";
}

/// The words that RoboSim reserves are names in RoboChart.
TEST(RoboSim, RoboChartKeepsItsWords) {
    const auto reading = resolved({{"t.rct", R"(stm S {
	event exec event input
	var cycle : nat = 1
	var context : nat = cycle
	initial i
	state output { entry exec ; cycle = context + 1 }
	transition t { from i to output }
	transition u { from output to output trigger input condition cycle < 3 }
}
)"}});
    EXPECT_EQ(reading->codes(), "") << reading->report();
}

/// If a RoboChart and a RoboSim component have the same simple name, a file refers to the component of its own dialect,
/// and a simulation refers to the RoboChart component.
TEST(RoboSim, EachDialectMeansItsOwnComponents) {
    const std::string machine = "initial i state A { } transition t0 { from i to A } ";
    const auto reading = resolved(
        {{"a.rct", "stm S { event e " + machine + "transition t1 { from A to A trigger e } }"},
         {"b.rst", "stm S { cycleDef cycle == 1 input context { } output context { } " + machine +
                       "transition t1 { from A to A exec } } " + "controller C { cycleDef cycle == 1 sref s = S }"},
         {"c.assertions", "assertion A : S is deadlock-free"},
         {"d.rsa",
          "assertion B : S is deadlock-free\n"
          "simulation N of S { cycleDef cycle == 1 input context { event e } output "
          "context { } }"}});
    EXPECT_TRUE(reading->findings.ok()) << reading->report();
    const Declaration* const chart_machine = reading->model.files[0]->declarations[0].get();
    const Declaration* const sim_machine = reading->model.files[1]->declarations[0].get();
    const auto& controller = dynamic_cast<const Component&>(*reading->model.files[1]->declarations[1]);
    EXPECT_EQ(controller.references[0]->target, sim_machine);
    EXPECT_EQ(reading->model.files[2]->assertions[0].subject_path.steps.at(0), chart_machine);
    EXPECT_EQ(reading->model.files[3]->assertions[0].subject_path.steps.at(0), sim_machine);
    EXPECT_EQ(reading->model.files[3]->simulations[0]->subject_path.steps.at(0), chart_machine);
}

// ---------------------------------------------------------------- wrong input

/// Returns a machine with a state, two contexts, and further members on separate lines, from line 5.
std::string machine(const std::string& input, const std::string& output, const std::string& members) {
    return "stm S { cycleDef cycle == 1 var n : nat = 0\ninput context { " + input + " }\noutput context { " + output +
           " }\ninitial i state A { } transition t0 { from i to A }\n" + members +
           "\ntransition t9 { from A to A exec condition n > 3 } transition t8 { from A to A exec action n = n + 1 } }";
}

std::string codes_of(const std::string& text) {
    return resolved(text)->codes();
}

TEST(RoboSim, ConstructsOfRoboChartAreNamed) {
    const auto with = [](const std::string& members) { return codes_of(machine("event e", "event o : nat", members)); };
    EXPECT_EQ(with("transition t1 { from A to A trigger e }"), "RC-P36@5");
    EXPECT_EQ(with("transition t1 { from A to A condition $e action o!1 }"), "RC-P36@5");
    EXPECT_EQ(with("transition t1 { from A to A condition $e action send o!1 }"), "RC-P36@5");
    EXPECT_EQ(with("transition t1 { from A to A condition $e action wait(1) }"), "RC-P36@5");
    EXPECT_EQ(with("transition t1 { from A to A <{ 3 } condition $e }"), "RC-P36@5");
    EXPECT_EQ(codes_of(machine("event e", "_broadcast event o", "")), "RC-P36@3");
}

TEST(RoboSim, ItsConstructsAreNamedInRoboChart) {
    const auto with = [](const std::string& members) {
        return resolved({{"t.rct",
                          "stm S { event e : nat var x : nat = 0\ninitial i state A { } transition t0 { from i "
                          "to A }\ntransition t9 { from A to A trigger e?x condition x > 3 }\n" +
                              members + "\n}"}})
            ->codes();
    };
    EXPECT_EQ(with(""), "");
    EXPECT_EQ(with("transition t1 { from A to A condition $x > 1 }"), "RC-P36@4");
    EXPECT_EQ(with("transition t1 { from A to A trigger e?x action $x = 1 }"), "RC-P36@4");
    EXPECT_EQ(with("transition t1 { from A to A exec condition x > 1 }"), "RC-P36@4");
    EXPECT_EQ(with("input context { event go }").substr(0, 8), "RC-P36@4");
    EXPECT_EQ(with("cycleDef 1"), "RC-P36@4");
    EXPECT_THAT(with("transition t1 { from A to A trigger e?x action exec }"), ::testing::HasSubstr("RC-N01@4"));
    EXPECT_EQ(resolved({{"t.assertions", "simulation N of S { }"},
                        {"s.rct",
                         "stm S { initial i state A { } transition "
                         "t { from i to A } }"}})
                  ->codes()
                  .substr(0, 8),
              "RC-P36@1");
}

TEST(RoboSim, RegistersAreReadAndWrittenInTheirDirection) {
    const auto with = [](const std::string& clauses) {
        return codes_of("interface V { var v : nat }\n" +
                        machine("event in_ : nat requires V", "event out_ : nat",
                                "transition t1 { from A to A exec " + clauses + " }"));
    };
    EXPECT_EQ(with("condition $in_?n action $out_!$v"), "");
    EXPECT_EQ(with("condition $out_"), "RC-Y04@6");
    EXPECT_EQ(with("condition $v?n == true"), "RC-Y04@6");
    EXPECT_EQ(with("condition $in_ action $in_!1"), "RC-Y03@6");
    EXPECT_EQ(with("condition $in_ action $v = 1"), "RC-Y03@6");
    EXPECT_EQ(with("condition $n > 1"), "RC-Y05@6");
    EXPECT_EQ(with("condition $in_ action $n = 1"), "RC-Y05@6");
    EXPECT_EQ(with("condition $gone"), "RC-N01@6");
    EXPECT_EQ(with("condition $in_ action $gone"), "RC-N01@6");
    EXPECT_EQ(with("condition $in_ action $go(1)"), "RC-N01@6");
}

TEST(RoboSim, StoresHaveTheTypeOfTheirEvent) {
    const auto with = [](const std::string& type, const std::string& stored) {
        return codes_of(
            machine("event e" + type, "", "transition t1 { from A to A exec condition $e?" + stored + " }"));
    };
    EXPECT_EQ(with(" : nat", "n"), "");
    EXPECT_EQ(with("", "n"), "Tg5@5");
    EXPECT_EQ(with(" : boolean", "n"), "RC-T08@5");
    EXPECT_EQ(with(" : nat", "gone"), "RC-N01@5");
    EXPECT_EQ(with(" : nat", "$n"), "RC-Y05@5") << "a store into a register needs a variable of the output context";
    EXPECT_EQ(with(" : nat", "n : (n > 1)"), "");
    EXPECT_EQ(with(" : nat", "n : (n + 1)"), "RC-T28@5");
}

TEST(RoboSim, ContextsAndCyclesAreChecked) {
    EXPECT_EQ(codes_of("operation f() { initial i final g transition t { from i to g } }"), "RC-Y01@1 RC-Y01@1");
    const std::string body =
        "input context { } output context { } initial i state A { } transition t0 { from i to A } "
        "transition t1 { from A to A exec } }";
    EXPECT_EQ(codes_of("stm S { " + body), "RC-Y07@1");
    EXPECT_EQ(codes_of("stm S { cycleDef cycle == 0 " + body), "RC-Y07@1");
    EXPECT_EQ(codes_of("stm S { cycleDef cycle == -1 " + body), "RC-Y07@1");
    EXPECT_EQ(codes_of("stm S { const c : nat = 2 cycleDef cycle == c " + body), "");
    EXPECT_EQ(codes_of("stm S { const c : nat cycleDef cycle == c " + body), "RC-Y07@1");
    EXPECT_EQ(codes_of("stm S { cycleDef { cycle == 0.1 } " + body), "");
    EXPECT_EQ(codes_of("stm S { cycleDef (cycle == 1) " + body), "");
    EXPECT_EQ(codes_of("stm S { cycleDef 2 " + body), "");
    EXPECT_EQ(codes_of("stm S { cycleDef 1 cycleDef 2 " + body), "RC-P37@1");
    EXPECT_EQ(codes_of("interface I { event e }\nmodule M { cycleDef 1 input context { uses I } robotic platform P { } "
                       "cref c = C }\ncontroller C { cycleDef 1 sref s = S }\nstm S { cycleDef 1 " +
                       body),
              "RC-Y01@2");
}

TEST(RoboSim, ClaimsAreAboutTimeAndCycles) {
    const auto with = [](const std::string& claims) {
        return resolved({{"lamp.rst", lamp}, {"chart.rct", chart}, {"claims.rsa", claims}})->codes();
    };
    EXPECT_EQ(with("timed assertion A : Lamp::Switch is deterministic"), "");
    EXPECT_EQ(with("untimed assertion A : Lamp::Switch is deterministic"), "RC-P36@1");
    EXPECT_EQ(with("assertion A : Chart is deterministic"), "RC-Y11@1");
    EXPECT_EQ(with("assertion A : Lamp::Switch is schedulable"), "RC-Y10@1");
    EXPECT_EQ(with("assertion A : Lamp::Switch is deterministic with cycleDef of Lamp::Switch set to 0"), "RC-Y07@1");
    EXPECT_EQ(with("assertion A : Lamp::Switch is deterministic with cycleDef of Nobody set to 1"), "RC-Q01@1");
    EXPECT_EQ(with("simulation N of Chart { cycleDef 1 }"), "RC-Y10@1 RC-Y10@1");
    EXPECT_EQ(with("simulation N of Lamp::Switch { cycleDef 1 }"), "RC-Y10@1");
    EXPECT_EQ(with("simulation N of Nobody { cycleDef 1 }"), "RC-Q01@1");
    EXPECT_EQ(with("simulation N of Chart { cycleDef 1 input context { } output context { } }\ncsp N csp-begin\nN = "
                   "STOP\ncsp-end"),
              "RC-Y10@1");
}

TEST(RoboSim, ClaimsCompareAndNameWhatExists) {
    const std::string module =
        "interface Io { event go }\nmodule M { cycleDef 1 robotic platform P { uses Io } "
        "cref c = C connection P on go to c on go }\ncontroller C { cycleDef 1 event go sref s = "
        "S connection C on go to s on go }\nstm S { cycleDef 1 input context { event go } output "
        "context { } initial i state A { } transition t { from i to A } transition u { from A to A "
        "exec condition $go } transition v { from A to A exec condition not $go } }\nstm T { cycleDef 1 input context "
        "{ } output context { event other } initial i "
        "state A { entry $other } transition t { from i to A } transition u { from A to A exec } }";
    const auto with = [&](const std::string& claims) {
        return resolved({{"m.rst", module}, {"claims.rsa", claims}})->codes();
    };
    EXPECT_EQ(with("assertion A : C refines M"), "");
    EXPECT_EQ(with("assertion A : S equals C"), "");
    EXPECT_EQ(with("assertion A : S refines T"), "RC-Y15@1");
    EXPECT_EQ(with("assertion A : M equals T"), "RC-Y15@1");
    const auto block = [&](const std::string& text) {
        return with("csp Spec csp-begin\nSpec = " + text + "\ncsp-end\nassertion A : C equals Spec");
    };
    EXPECT_EQ(block("C::endexec -> Spec"), "");
    EXPECT_EQ(block("M::c::endexec -> Spec"), "");
    EXPECT_EQ(block("M::endexec -> tock -> Spec"), "RC-Y16@2");
    EXPECT_EQ(block("M::terminate -> SKIP"), "RC-Y16@2");
    EXPECT_EQ(block("STOP -- M::endexec"), "");
}

/// Hostile input meets the limits of the parser.
TEST(RoboSim, DeepNestingIsOneFinding) {
    std::string text = "stm S { cycleDef cycle == 1 input context { } output context { } ";
    for (int i = 0; i < 10'000; ++i) text += "state A { ";
    EXPECT_EQ(resolved(text)->codes(), "RC-P02@1");
    std::string condition(10'000, '(');
    EXPECT_EQ(codes_of(machine("event e", "", "transition t1 { from A to A condition " + condition + "$e")),
              "RC-P02@5");
}

// ---------------------------------------------------------------- public models

/// Returns the folders of suite/robosim, each with the files of one project.
std::vector<fs::path> projects_in(const fs::path& suite) {
    std::vector<fs::path> result;
    for (const char* group : {"models", "models/read", "own", "robotool-csp"})
        for (const auto& entry : fs::directory_iterator(suite / group))
            if (entry.is_directory() && entry.path().filename() != "read") result.push_back(entry.path());
    std::ranges::sort(result);
    return result;
}

/// These models are wrong for the reasons that suite/robosim/README.md and the reference give. In MobileRobotOA, a
/// constant is assigned and `abs` has no parameter. In AutonomousSegregation, `$` precedes a local variable, and a
/// record is stored in a vector.
const std::map<std::string, std::multiset<std::string>> wrong_models = {
    {"MobileRobotOA", {"RC-N01", "RC-T13", "RC-T13", "RC-T13", "RC-T13", "RC-T30", "RC-T30"}},
    {"AutonomousSegregation", {"RC-Y05", "RC-Y05", "RC-T08"}}};

TEST(RoboSim, ThePublicModelsLoad) {
    const fs::path shared = testing::shared_folder();
    if (!fs::is_directory(shared / "suite/robosim")) GTEST_SKIP() << "no suite/robosim beside the repository";
    for (const fs::path& project : projects_in(shared / "suite/robosim")) {
        Reading reading;
        const auto model = load_project(reading.sources, project.string(), reading.findings);
        std::multiset<std::string> errors;
        for (const auto& finding : reading.findings.sorted_findings())
            if (finding.rule->severity == diagnostics::Severity::error) errors.emplace(finding.rule->code);
        const auto wrong = wrong_models.find(project.filename().string());
        EXPECT_EQ(errors, wrong == wrong_models.end() ? std::multiset<std::string>() : wrong->second)
            << project << "\n"
            << reading.report();
    }
}

void expect_formatted(const std::string& path, const std::string& text) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics findings;
    const bool claims = is_assertion_path(path);
    const auto once = format(sources, sources.add(path, text), claims, findings);
    ASSERT_TRUE(once) << path << diagnostics::render_text(sources, findings);
    EXPECT_EQ(format(sources, sources.add(path, *once), claims, findings), once) << path;
    EXPECT_TRUE(same_words(text, *once, claims, path)) << path;
}

TEST(RoboSim, FormattingIsStable) {
    expect_formatted("lamp.rst", lamp);
    expect_formatted("claims.rsa", lamp_claims);
    const fs::path suite = testing::shared_folder() / "suite/robosim";
    if (!fs::is_directory(suite)) return;
    for (const auto& entry : fs::recursive_directory_iterator(suite))
        if (dialect_of(entry.path().string()) == Dialect::robosim)
            expect_formatted(entry.path().string(), testing::read_contents(entry.path()));
}

TEST(RoboSim, TheStandardLayout) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics findings;
    const auto source = sources.add("t.rst",
                                    "stm S { cycleDef ( cycle ==1 ) input context{ uses  I\n event e:nat } output "
                                    "context { } transition t { from A to B\nexec\ncondition $ e ? x : ( x > 1 ) "
                                    "action $ out ! $ y;$op( 1 ) ; $x.f=2; exec } }");
    EXPECT_EQ(
        format(sources, source, false, findings).value_or(""),
        "stm S {\n\tcycleDef (cycle == 1)\n\tinput context { uses I event e : nat }\n\toutput context {}\n\t"
        "transition t {\n\t\tfrom A to B\n\t\texec\n\t\tcondition $e?x : (x > 1)\n\t\taction $out!$y; $op(1); $x.f "
        "= 2; exec\n\t}\n}\n");
}

}  // namespace
}  // namespace robochart::frontend
