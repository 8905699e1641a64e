// SPDX-License-Identifier: Apache-2.0
// Tests the record of the run. Every report in JSON has it, with all of its keys. The constants, ranges and inputs in
// it are those of the run.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/command/run_record.hpp"
#include "tests/app/command.hpp"

namespace robochart::app::testing::run_record_test {
namespace {

using nlohmann::json;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::UnorderedElementsAre;

// ---------------------------------------------------------------- every report

constexpr const char* files = R"(
mkdir walker swarm
cat > walker/m.rct <<'END'
package p
interface Sights { event e }
interface Limits { const limit : nat = 2 const step : nat const mode : boolean }
robotic platform Body { provides Limits uses Sights }
stm Walker { requires Limits uses Sights const own : real = 1.5 var n : nat = 0
  initial i state A { }
  transition t0 { from i to A } transition t1 { from A to A trigger e condition n < limit action n = n + step } }
controller Legs { requires Limits uses Sights sref walker = Walker connection Legs on e to walker on e }
module Robot { rref body = Body cref legs = Legs connection body on e to legs on e ( _async ) }
END
echo 'assertion Moves : p::Walker is deadlock-free' > walker/m.assertions
cp -r walker wrong; echo 'stm {' >> wrong/m.rct
printf 'channel a\nP = a -> P\nassert P :[deadlock free]\n' > s.csp
printf 'include "s.csp"\nprint 1 + 1\n' > outer.csp
cat > fork.prism <<'END'
dtmc const double p; const int n = 2;
module M s:[0..n]; [] s=0 -> p:(s'=1) + 1-p:(s'=2); [] s>0 -> true; endmodule
END
echo 'dtmc const int a; const int b; module M s:[0..b]; [] true -> true; endmodule' > lines.prism
printf 'def_start\nevent Go event Stop constant wait = 5\ndef_end\nrule_start\nA when Go then Stop within wait seconds\nrule_end\n' > duty.sleec
printf 'robochart-trace 1\ncomponent p::Walker\ncycle 1\nrun one\ntock\n' > one.trace
)";

struct Row {
    const char* name;
    const char* command;  ///< writes the objects, one after the other, to standard output or to the file report.json
    bool to_file = false;
};

void PrintTo(const Row& row, std::ostream* out) {
    *out << row.name;
}

/// Returns the keys of an object, in order.
std::vector<std::string> keys(const nlohmann::ordered_json& object) {
    std::vector<std::string> names;
    for (const auto& [name, value] : object.items()) names.push_back(name);
    return names;
}

bool is_digest(const std::string& text) {
    return text.size() == 64 && text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

bool is_whole_or_null(const nlohmann::ordered_json& value) {
    return value.is_null() || value.is_number_unsigned();
}

/// Checks `run` with the schema in docs/cli.md.
void expect_valid(const nlohmann::ordered_json& run) {
    ASSERT_THAT(keys(run), ElementsAre("program", "command", "inputs", "constants", "ranges", "seed", "limits",
                                       "reduction", "threads", "peakMemoryBytes"));
    const auto& program = run.at("program");
    ASSERT_THAT(keys(program), ElementsAre("name", "version", "commit", "modified"));
    EXPECT_EQ(program.at("name"), "robochart-verify");
    EXPECT_EQ(program.at("version"), program_version);
    const Commit commit = built_commit();
    if (commit.id.empty()) {
        EXPECT_TRUE(program.at("commit").is_null());
    } else {
        EXPECT_EQ(program.at("commit"), commit.id);
        EXPECT_EQ(program.at("modified"), commit.modified);
    }
    ASSERT_GE(run.at("command").size(), 2U);
    EXPECT_EQ(run.at("command").at(0), "robochart-verify");
    for (const auto& input : run.at("inputs")) {
        ASSERT_THAT(keys(input), ElementsAre("path", "sha256"));
        EXPECT_TRUE(is_digest(input.at("sha256"))) << input;
    }
    for (const auto& constant : run.at("constants"))
        ASSERT_THAT(keys(constant), ElementsAre("model", "name", "value", "source"));
    for (const auto& range : run.at("ranges")) {
        ASSERT_THAT(keys(range), ElementsAre("model", "type", "low", "high", "values", "source"));
        EXPECT_TRUE(range.at("low").is_number() && range.at("high").is_number()) << range;
        EXPECT_TRUE(range.at("values").is_number_unsigned()) << range;
    }
    EXPECT_TRUE(is_whole_or_null(run.at("seed")));
    const auto& limits = run.at("limits");
    ASSERT_THAT(keys(limits), ElementsAre("memoryBytes", "seconds", "assertionSeconds", "states"));
    EXPECT_GT(limits.at("memoryBytes"), 0);
    EXPECT_TRUE(limits.at("seconds").is_null() || limits.at("seconds") > 0.0);
    EXPECT_TRUE(limits.at("assertionSeconds").is_null() || limits.at("assertionSeconds") > 0.0);
    EXPECT_TRUE(is_whole_or_null(limits.at("states")));
    EXPECT_TRUE(run.at("reduction").is_null() || run.at("reduction").is_boolean());
    EXPECT_TRUE(is_whole_or_null(run.at("threads")));
    EXPECT_TRUE(is_whole_or_null(run.at("peakMemoryBytes")));
}

/// Returns all values of a text that contains one JSON value after the other.
std::vector<nlohmann::ordered_json> values_in(const std::string& text) {
    std::vector<nlohmann::ordered_json> values;
    std::istringstream in(text);
    while (in >> std::ws && in.peek() != std::istringstream::traits_type::eof()) {
        nlohmann::ordered_json value;
        in >> value;
        values.push_back(std::move(value));
    }
    return values;
}

class ReportInJson : public ::testing::TestWithParam<Row> {};

TEST_P(ReportInJson, HasTheRecordOfTheRun) {
    const Row& row = GetParam();
    const std::string command = std::string(files) + "\"$verify\" " + row.command;
    const Ran ran = run_shell(row.to_file ? command + " > /dev/null; cat report.json" : command);
    const auto reports = values_in(ran.out);
    ASSERT_FALSE(reports.empty()) << ran.err;
    for (const auto& report : reports) {
        ASSERT_TRUE(report.contains("run")) << row.command << "\n" << report;
        EXPECT_THAT(report.at("schema").get<std::string>(), HasSubstr("robochart-verify/"));
        expect_valid(report.at("run"));
    }
}

INSTANTIATE_TEST_SUITE_P(
    Verbs, ReportInJson,
    ::testing::Values(
        Row{"verify", "walker --format json"}, Row{"verify_to_a_file", "verify walker --json report.json", true},
        Row{"check", "check walker --format json"}, Row{"check_to_a_file", "check walker --json report.json", true},
        Row{"check_refused", "check wrong --format json"},
        Row{"check_at_a_limit", "check walker --timeout 0.000001 --format json"},
        Row{"validate", "validate walker wrong --format json"}, Row{"emit_csp", "emit csp walker --format json"},
        Row{"emit_cpp", "emit cpp walker --format json"}, Row{"emit_prism", "emit prism walker --format json"},
        Row{"emit_monitor", "emit monitor walker --component Walker --format json"},
        Row{"emit_monitor_of_rules", "emit monitor duty.sleec --format json"},
        Row{"emit_tests", "emit tests walker --component Walker --format json"},
        Row{"conform", "conform walker --component Walker --format json"},
        Row{"conform_logs", "conform walker --traces one.trace --format json"},
        Row{"conform_logs_with_rules", "conform duty.sleec --traces one.trace --format json"},
        Row{"cspm", "cspm s.csp outer.csp --format json"},
        Row{"cspm_by_assertion", "cspm s.csp outer.csp --format framed_json"},
        Row{"cspm_to_a_file", "cspm s.csp --json report.json", true},
        Row{"cspm_types", "cspm s.csp --types --format json"},
        Row{"prism", "prism fork.prism --const p=0.5 --property 'P=? [ F s=1 ]' --format json"},
        Row{"prism_to_a_file", "prism fork.prism --const p=0.5 --json report.json", true},
        Row{"prism_by_paths",
            "prism fork.prism --const p=0.5 --property 'P=? [ F s=1 ]' --sim ci,samples=100 --format json"},
        Row{"rules", "rules duty.sleec --format json"},
        Row{"rules_of_a_model", "rules duty.sleec walker --format json"}),
    [](const auto& row) { return std::string(row.param.name); });

/// Returns the report of a scenario of the corpus.
json simulated(const std::string& scenario, const std::vector<std::string>& more) {
    std::vector<std::string> words{"simulate", repository("corpus/aggregation/" + scenario), "--format", "json",
                                   "--no-pictures"};
    words.insert(words.end(), more.begin(), more.end());
    const Ran ran = run(words);
    const auto report = nlohmann::ordered_json::parse(ran.out, nullptr, false);
    EXPECT_TRUE(report.is_object()) << ran.out << ran.err;
    if (!report.is_object() || !report.contains("run")) return {};
    expect_valid(report.at("run"));
    return json::parse(report.dump());
}

TEST(Report, OfASimulationHasTheRecordOfTheRun) {
    const json report = simulated("aggregation.scenario", {"--trials", "1", "--seed", "5"});
    EXPECT_EQ(report.at("run").at("seed"), 5);
    EXPECT_EQ(report.at("run").at("inputs").at(0).at("path"), repository("corpus/aggregation/aggregation.scenario"));
    EXPECT_GE(report.at("run").at("inputs").size(), 2U) << "the scenario and its model";
}

TEST(Report, OfASweepHasTheRecordOfTheRun) {
    const json report = simulated("sizes.scenario", {"--trials", "1"});
    EXPECT_EQ(report.at("schema"), "robochart-verify/sweep/1");
    EXPECT_TRUE(report.contains("run"));
}

TEST(Report, OfASimulationAtALimitHasTheRecordOfTheRun) {
    EXPECT_TRUE(simulated("aggregation.scenario", {"--timeout", "0.000001"}).contains("run"));
}

// ---------------------------------------------------------------- its contents

json run_of(const std::string& command) {
    const Ran ran = run_shell(std::string(files) + "\"$verify\" " + command);
    const json report = json::parse(ran.out, nullptr, false);
    EXPECT_TRUE(report.is_object()) << ran.out << ran.err;
    return report.is_object() ? report.value("run", json()) : json();
}

/// Returns "limit 2 model" for each constant, with the last part of its name.
std::vector<std::string> constants_of(const json& run) {
    std::vector<std::string> texts;
    for (const auto& constant : run.at("constants")) {
        const std::string name = constant.at("name");
        texts.push_back(name + " " + constant.at("value").get<std::string>() + " " +
                        constant.at("source").get<std::string>());
    }
    return texts;
}

std::string range_of(const json& run, const std::string& type) {
    for (const auto& range : run.at("ranges"))
        if (range.at("type") == type)
            return range.at("low").dump() + ".." + range.at("high").dump() + " " +
                   range.at("source").get<std::string>();
    return "none";
}

TEST(RunRecord, ConstantsHaveTheirValuesAndSources) {
    const auto constants = constants_of(run_of("check walker --const own=2.5 --const Robot::step=1 --format json"));
    EXPECT_THAT(constants, Contains("p::Walker::own 2.5 option"));
    EXPECT_THAT(constants, Contains("p::Robot::step 1 option"));
    EXPECT_THAT(constants, Contains("p::Robot::limit 2 model"));
    EXPECT_THAT(constants, Contains("p::Robot::mode true default"));
    EXPECT_THAT(constants, Not(Contains(HasSubstr("walker")))) << "the machine in the controller has the same value";
}

TEST(RunRecord, TheValueOfAComponentInAControllerMayDiffer) {
    const auto constants = constants_of(run_of("check walker --const walker::own=3.5 --format json"));
    EXPECT_THAT(constants, Contains("p::Walker::own 1.5 model"));
    EXPECT_THAT(constants, Contains("p::Legs::walker::own 3.5 option"));
}

TEST(RunRecord, RangesHaveTheirSources) {
    const json run = run_of("check walker --range nat=0..5 --range clock=0..20 --format json");
    EXPECT_EQ(range_of(run, "nat"), "0..5 option");
    EXPECT_EQ(range_of(run, "clock"), "0..20 option");
    EXPECT_EQ(range_of(run, "Seq"), "0..2 default");
    EXPECT_EQ(range_of(run, "given"), "0..1 default");
    EXPECT_EQ(range_of(run, "int"), "-2..5 default") << "it contains nat";
}

TEST(RunRecord, PreferencesGiveRanges) {
    const json run = run_of(
        "--version > /dev/null; printf 'NAT_MIN=0\nNAT_MAX=7\n' > rc2prism.prefs; "
        "\"$verify\" emit prism walker --prefs rc2prism.prefs --format json");
    EXPECT_EQ(range_of(run, "nat"), "0..7 preferences");
    EXPECT_EQ(range_of(run, "int"), "-2..3 default") << "the file does not give it";
}

constexpr const char* blocks =
    "--version > /dev/null; printf 'csp Instantiations csp-begin\nnametype core_nat = {0..4}\nconst_p_Walker_own = "
    "25\ncsp-end\n' >> walker/m.assertions; \"$verify\" ";

TEST(RunRecord, ABlockReplacesValuesOfScripts) {
    const json run = run_of(std::string(blocks) + "check walker --const own=3 --format json");
    EXPECT_THAT(constants_of(run), Contains("core_nat {0..4} block"));
    EXPECT_THAT(constants_of(run), Contains("p::Walker::own 2.5 block"));
    EXPECT_THAT(constants_of(run), Not(Contains("p::Walker::own 3 option")));
    EXPECT_EQ(range_of(run, "nat"), "none");
    EXPECT_EQ(range_of(run, "Seq"), "0..2 default");
}

TEST(RunRecord, GeneratedCodeKeepsTheValuesThatABlockReplaces) {
    const json run = run_of(std::string(blocks) + "verify walker --const own=3 --format json");
    EXPECT_THAT(constants_of(run), Contains("p::Walker::own 2.5 block"));
    EXPECT_THAT(constants_of(run), Contains("p::Walker::own 3 option"));
}

TEST(RunRecord, ConstantsOfOtherFilesAreListed) {
    EXPECT_THAT(constants_of(run_of("prism fork.prism --const p=0.25:0.25:0.75 --format json")),
                UnorderedElementsAre("n 2 model", "p 0.25:0.25:0.75 option"));
    EXPECT_THAT(constants_of(run_of("prism lines.prism --const 'a=1,b=max(1,2)' --format json")),
                UnorderedElementsAre("a 1 option", "b max(1,2) option"));
    EXPECT_THAT(constants_of(run_of("rules duty.sleec --format json")), ElementsAre("wait 5 model"));
}

TEST(RunRecord, InputsHaveTheDigestsOfSha256sum) {
    const Ran ran = run_shell(std::string(files) +
                              "\"$verify\" cspm outer.csp --format json > report.json; sha256sum outer.csp s.csp; "
                              "cat report.json");
    const json report = json::parse(ran.out.substr(ran.out.find('{')), nullptr, false);
    std::string printed;
    for (const auto& input : report.at("run").at("inputs"))
        printed += input.at("sha256").get<std::string>() + "  " + input.at("path").get<std::string>() + "\n";
    EXPECT_EQ(printed, ran.out.substr(0, ran.out.find('{')));
}

std::vector<std::string> inputs_of(const json& run) {
    std::vector<std::string> paths;
    for (const auto& input : run.at("inputs")) paths.push_back(input.at("path"));
    return paths;
}

TEST(RunRecord, EveryFileThatIsReadIsAnInput) {
    EXPECT_THAT(inputs_of(run_of("check walker --format json")),
                UnorderedElementsAre("walker/m.rct", "walker/m.assertions"));
    EXPECT_THAT(inputs_of(run_of("validate walker --format json")),
                UnorderedElementsAre("walker/m.rct", "walker/m.assertions"));
    EXPECT_THAT(inputs_of(run_of("conform walker --traces one.trace --format json")),
                UnorderedElementsAre("walker/m.rct", "walker/m.assertions", "one.trace"));
    EXPECT_THAT(inputs_of(run_of("rules duty.sleec walker --format json")),
                UnorderedElementsAre("duty.sleec", "walker/m.rct", "walker/m.assertions"));
    EXPECT_THAT(inputs_of(run_of("rules - --format json < duty.sleec")), ElementsAre("standard input"));
}

TEST(RunRecord, OptionsOfTheRunAreRecorded) {
    const json run = run_of(
        "check walker --timeout 60 --assertion-timeout 5 --memory 1GiB --max-states 1000 --threads 1 --no-reduction "
        "--seed 4 --format json");
    EXPECT_EQ(run.at("limits").at("memoryBytes"), 1U << 30U);
    EXPECT_EQ(run.at("limits").at("seconds"), 60);
    EXPECT_EQ(run.at("limits").at("assertionSeconds"), 5);
    EXPECT_EQ(run.at("limits").at("states"), 1000);
    EXPECT_EQ(run.at("threads"), 1);
    EXPECT_EQ(run.at("reduction"), false);
    EXPECT_EQ(run.at("seed"), 4);
    EXPECT_THAT(run.at("command").get<std::vector<std::string>>(),
                ElementsAre("robochart-verify", "check", "walker", "--timeout", "60", "--assertion-timeout", "5",
                            "--memory", "1GiB", "--max-states", "1000", "--threads", "1", "--no-reduction", "--seed",
                            "4", "--format", "json"));
}

TEST(RunRecord, AbsentValuesAreNull) {
    const json run = run_of("prism fork.prism --const p=0.5 --format json");
    EXPECT_TRUE(run.at("reduction").is_null());
    EXPECT_TRUE(run.at("seed").is_null());
    EXPECT_TRUE(run.at("limits").at("seconds").is_null());
    EXPECT_TRUE(run.at("limits").at("assertionSeconds").is_null());
}

TEST(RunRecord, ADefaultSeedIsRecordedIfPathsAreRandom) {
    EXPECT_EQ(run_of("prism fork.prism --const p=0.5 --property 'P=? [ F s=1 ]' --sim ci,samples=50 --format json")
                  .at("seed"),
              0);
}

// ---------------------------------------------------------------- equal runs

/// Removes what may differ between equal runs (docs/cli.md).
void remove_times(json& value) {
    if (value.is_object())
        for (const char* key : {"seconds", "cpuSeconds", "peakMemoryBytes"}) value.erase(key);
    if (value.is_structured())
        for (auto& part : value) remove_times(part);
}

TEST(RunRecord, AFileHasTheSameReportAsTheOutput) {
    for (const char* command :
         {"check walker", "cspm s.csp", "cspm s.csp --types", "rules duty.sleec", "prism fork.prism --const p=0.5"}) {
        const Ran ran = run_shell(std::string(files) + "\"$verify\" " + command +
                                  " --format json --json report.json > printed; cmp printed report.json && echo same");
        EXPECT_EQ(ran.out, "same\n") << command << ran.err;
    }
}

TEST(RunRecord, EqualRunsHaveEqualReports) {
    const Ran ran =
        run_shell(std::string(files) + "for i in 1 2; do \"$verify\" check walker --no-cache --format json; done");
    auto reports = values_in(ran.out);
    ASSERT_EQ(reports.size(), 2U);
    json first = reports[0], second = reports[1];
    remove_times(first);
    remove_times(second);
    EXPECT_EQ(first, second);
}

// ---------------------------------------------------------------- text, pages, logs

TEST(RunRecord, TextReportsHaveItOnRequest) {
    const Ran without = run_shell(std::string(files) + "\"$verify\" check walker");
    EXPECT_THAT(without.out, Not(HasSubstr("sha256")));
    const Ran with = run_shell(std::string(files) + "\"$verify\" check walker --const 'own=2.5' --provenance");
    EXPECT_THAT(with.out, HasSubstr("checks hold\n\nrobochart-verify " + std::string(program_version) + " ("));
    EXPECT_THAT(with.out, HasSubstr("\n  command     robochart-verify check walker --const own=2.5 --provenance\n"));
    EXPECT_THAT(with.out, HasSubstr("p::Walker::own = 2.5 (option)\n"));
    EXPECT_EQ(with.out.find("robochart-verify " + std::string(program_version)),
              with.out.rfind("robochart-verify " + std::string(program_version)));
}

TEST(RunRecord, ARunThatALimitEndsHasItToo) {
    const Ran ran = run_shell(std::string(files) + "\"$verify\" check walker --timeout 0.000001 --provenance");
    EXPECT_EQ(ran.exit, 3);
    EXPECT_THAT(ran.out, HasSubstr("\n  limits      memory "));
}

TEST(RunRecord, APageShowsItEscaped) {
    const Ran ran = run_shell(std::string(files) +
                              "cp walker/m.rct '<b>x.rct'; \"$verify\" check '<b>x.rct' --html page.html > /dev/null; "
                              "cat page.html");
    const std::size_t record = ran.out.find("<section id=\"run\">");
    ASSERT_NE(record, std::string::npos);
    EXPECT_THAT(ran.out.substr(record), HasSubstr("input       &lt;b&gt;x.rct sha256 "));
    EXPECT_THAT(ran.out, Not(HasSubstr("<b>x")));
}

TEST(RunRecord, ALineIsPrintableAscii) {
    RunRecord record;
    record.command = {"robochart-verify", "check", "m\n\xe2\x80\xae\xff.rct"};
    record.peak_memory_bytes = 1;
    const std::string line = run_line(record);
    for (const char c : line) EXPECT_TRUE(c >= ' ' && c <= '~') << line;
    EXPECT_TRUE(json::parse(line).at("peakMemoryBytes").is_null());
}

TEST(RunRecord, TextQuotesWordsForAShell) {
    RunRecord record;
    record.command = {"robochart-verify", "check", "a b", "it's", "", "x\x1b"};
    EXPECT_THAT(run_text(record), HasSubstr(R"(robochart-verify check 'a b' 'it'\''s' '' 'x\x1b')"));
}

TEST(RunRecord, IsTheLastMemberOfADocumentInAnyLayout) {
    const RunRecord record;
    const std::string line = with_run("{\"schema\":\"s/1\",\"list\":[{}]}\n", record);
    EXPECT_THAT(line, HasSubstr("\"list\":[{}],\"run\":{"));
    EXPECT_EQ(std::ranges::count(line, '\n'), 1);
    const std::string lines = with_run("{\n  \"schema\": \"s/1\",\n  \"list\": []\n}\n", record);
    EXPECT_EQ(nlohmann::ordered_json::parse(lines).dump(2) + "\n", lines) << "it is laid out like the rest";
    EXPECT_EQ(json::parse(line).at("run"), json::parse(lines).at("run"));
}

}  // namespace
}  // namespace robochart::app::testing::run_record_test
