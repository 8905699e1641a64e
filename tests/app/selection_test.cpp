// SPDX-License-Identifier: Apache-2.0
// Tests empty selections, empty inputs, unknown names and numbers out of range. Each case has a message and its own
// exit code, so a script can distinguish "nothing was checked" from "all checks hold".
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/command.hpp"

namespace robochart::app::testing::selection_test {
namespace {

using ::testing::HasSubstr;

struct Row {
    const char* name;
    const char* arguments;
    int exit;
    const char* message;  ///< expected on standard output or error
};

void PrintTo(const Row& row, std::ostream* out) {
    *out << row.name;
}

// Commands that make a model with two assertions, a model without assertions, a model without machines, a script with
// an assertion, a script without one, an empty folder, and pipes without a writer.
constexpr const char* files = R"(
mkdir claimed plain types empty logs
echo 'stm Walker { event e const speed : nat initial i state A { } transition t0 { from i to A } transition t1 { from A to A trigger e } }' > claimed/m.rct
echo 'assertion Moves : Walker is deadlock-free' > claimed/m.assertions
echo 'timed assertion MovesInTime : Walker is deadlock-free' >> claimed/m.assertions
echo 'stm Sitter { initial i state A { } transition t0 { from i to A } }' > plain/m.rct
echo 'enumeration Colour { red blue }' > types/m.rct
printf 'channel a\nP = a -> P\nassert P :[deadlock free [F]]\n' > s.csp
printf 'channel a\nP = a -> P\n' > none.csp
printf 'print 1 + 1\n' > prints.csp
cp none.csp beside.csp; printf 'include "beside.csp"\nassert P :[deadlock free]\n' > beside_assertions.csp
printf -- '-- nothing\n' > comment.csp
printf 'robochart-trace 1\ncomponent Sitter\ncycle 1\n' > logs/none.trace
cp -r claimed checks
cp -r plain blocks; printf 'csp Instantiations csp-begin\nf(x) = x\ncsp-end\n' > blocks/m.assertions
mkfifo pipe.rct; mkdir piped; mkfifo piped/m.rct
mkdir patrols; touch patrols/patrol.scenario patrols/duties.sleec
)";

class Selection : public ::testing::TestWithParam<Row> {};

TEST_P(Selection, IsSaid) {
    const Row& row = GetParam();
    const Ran ran = run_shell(std::string(files) + "timeout 60 \"$verify\" " + row.arguments);
    EXPECT_EQ(ran.exit, row.exit) << row.arguments << "\n" << ran.out << ran.err;
    EXPECT_THAT(ran.out + ran.err, HasSubstr(row.message)) << row.arguments;
}

INSTANTIATE_TEST_SUITE_P(
    Options, Selection,
    ::testing::Values(
        // Names.
        Row{"KnownAssertion", "check claimed --assertion Moves", 0, "2 of 2 checks hold"},
        Row{"KnownAssertions", "check claimed --assertion MovesInTime --assertion Moves", 0, "3 of 3 checks hold"},
        Row{"UnknownAssertionBesideAKnown", "check claimed --assertion Moves --assertion Move", 4,
            "did you mean 'Moves'?"},
        Row{"UnknownAssertion", "check claimed --assertion Move", 4, "did you mean 'Moves'?"},
        Row{"MisspeltAssertionOfAll", "claimed --assertion Movs", 4, "did you mean 'Moves'?"},
        Row{"UnknownAssertionOfAll", "claimed --assertion nothing_like_it", 4,
            "the model has no assertion of this name; there are"},
        Row{"AssertionOfAModelWithout", "check plain --assertion A", 4, "the model has no assertions"},
        Row{"EmptyAssertion", "check claimed --assertion ''", 4, "the name is empty"},
        Row{"CoreProperty", "check plain --assertion 'Sitter: divergence-free'", 0, "1 of 1 checks hold"},
        Row{"CorePropertiesByPattern", "check plain --assertion 'Sitter: d*-free'", 1, "1 of 2 checks hold"},
        Row{"CorePropertyBesideClaims", "check claimed --assertion Moves --assertion 'Walker: timelock-free'", 0,
            "3 of 3 checks hold"},
        Row{"MisspeltCoreProperty", "check plain --assertion 'Sitter: deadlock_free'", 4,
            "did you mean 'Sitter: deadlock-free'?"},
        Row{"CorePropertyJson", "check plain --timed --assertion 'Sitter: timelock-free' --format json", 0,
            "\"name\": \"Sitter: timelock-free\""},
        Row{"NumberOfNoClaim", "check plain --core --assertion 1", 4, "the model has no assertions"},
        Row{"AssertionOfTheOtherTime", "check claimed --untimed --assertion MovesInTime", 2, "nothing is claimed"},
        Row{"AssertionByNumber", "check claimed --timed --assertion 2", 0, "1 of 1 checks hold"},
        Row{"AssertionsByNumbers", "check claimed --assertion 1..2", 0, "3 of 3 checks hold"},
        Row{"AssertionsByPattern", "check claimed --assertion 'Mov?s*'", 0, "3 of 3 checks hold"},
        Row{"AssertionsByPatternOfTheEnd", "check claimed --assertion '*Time'", 0, "1 of 1 checks hold"},
        Row{"NumberOfNoAssertion", "check claimed --assertion 3", 4, "--assertion 3: the model has 2 assertions"},
        Row{"NumbersOfNoAssertion", "check claimed --assertion 2..1", 4, "2..1: the model has 2 assertions"},
        Row{"PatternOfNoAssertion", "check claimed --assertion 'Sits*'", 4, "no assertion that fits this pattern"},
        Row{"ScriptsAssertionByPattern", "cspm --assertion '*deadlock*' s.csp", 0, "1 of 1 checks hold"},
        Row{"ScriptsAssertionByText", "cspm --assertion 'P :[deadlock free [F]]' s.csp", 0, "1 of 1 checks hold"},
        Row{"ScriptsPatternOfNone", "cspm --assertion 'Q*' s.csp", 4, "s.csp has no assertion that fits"},
        Row{"UnknownComponentOfConform", "conform claimed --component Q", 4, "--component Q"},
        Row{"MisspeltComponentOfConform", "conform claimed --component Walkr", 4, "did you mean 'Walker'?"},
        Row{"UnknownComponentOfEmit", "emit cpp claimed --component Walkr", 4, "did you mean 'Walker'?"},
        Row{"UnknownComponentOfMonitor", "emit monitor claimed --component Walkr", 4, "did you mean 'Walker'?"},
        Row{"UnknownComponentOfTests", "emit tests claimed --component Walkr", 4, "did you mean 'Walker'?"},
        Row{"EmptyComponent", "conform claimed --component ''", 4, "the name is empty"},
        Row{"UnknownConstant", "check claimed --const sped=1", 4, "sped"},
        Row{"MisspeltConstant", "emit csp claimed --const sped=1", 4, "did you mean 'speed'?"},
        Row{"MisspeltConstantOfConform", "conform claimed --const sped=1", 4, "did you mean 'speed'?"},
        Row{"ConstantBeforeTheModel", "check --const speed=1 claimed", 0, "checks hold"},
        Row{"ConstantWithoutValue", "check claimed --const speed", 4, "NAME=VALUE"},
        Row{"ConstantOfAnotherType", "check claimed --const speed=fast", 4, "fast"},
        Row{"UnknownRange", "check claimed --range natural=0..1", 4, "natural"},
        Row{"MisspeltRange", "check claimed --range nta=0..1", 4, "did you mean 'nat'?"},
        Row{"MisspeltRangeOfEmit", "emit cpp claimed --range clok=0..1", 4, "did you mean 'clock'?"},
        Row{"EmptyRange", "check claimed --range nat=1..0", 4, "the range is empty"},
        Row{"UnknownWarning", "check claimed --allow RC-XX", 4, "not the code of a warning"},
        Row{"MisspeltWarning", "validate claimed --allow RC-W9", 4, "did you mean 'RC-W"},
        Row{"UnknownPhase", "check claimed --print tokens", 4, "--print"},
        Row{"UnknownTarget", "emit cpp claimed --target cobol", 4, "--target"},
        Row{"UnknownStrategy", "emit cpp claimed --strategy luck", 4, "--strategy"},
        Row{"UnknownRelation", "conform claimed --model traces", 4, "--model"},
        Row{"UnknownExport", "conform claimed --export x.txt", 4, ".aut, .dot or .csp"},
        Row{"UnknownRule", "explain XX9999", 4, "no rule has the code"},
        Row{"RuleWithoutHyphen", "explain RCW07", 0, "RC-W07: "},
        Row{"RuleWithoutPrefix", "explain W17", 0, "RC-W17: "},
        Row{"RuleInSmallLetters", "explain rc-w17", 0, "RC-W17: "},
        Row{"RulesOfOneNumber", "explain p01", 4, "; there are CLM-P01, CSPM-P01, PRISM-P01, RC-P01, SLEEC-P01"},
        Row{"MisspeltRule", "explain RC-W077", 4, "did you mean 'RC-W07'?"},
        Row{"WarningWithoutPrefix", "check claimed --allow w19", 0, "hold"},
        Row{"MisspeltChoice", "check claimed --format jsn", 4, "did you mean 'json'?"},
        Row{"MisspeltOption", "check claimed --assertin A", 4, "did you mean '--assertion'?"},
        Row{"OptionOfAnotherVerb", "check claimed --walks 3", 4, "`check` has no option --walks; `conform` has"},
        Row{"MisspeltVerb", "chek claimed", 4, "did you mean 'check'?"},
        Row{"NoVerbAndNoFile", "overview claimed", 4, "there is no verb, file or folder 'overview'"},
        Row{"MisspeltFolder", "claimd", 4, "did you mean 'claimed'?"}, Row{"NoFile", "Overview.rct", 2, "RC-F01"},
        Row{"MisspeltThingToEmit", "emit cp claimed", 4, "did you mean 'csp'?"},
        Row{"NothingToEmit", "emit", 4, "emit needs one of csp, cpp, prism, monitor, rst, tests"},
        Row{"MisspeltVerbOfHelp", "help conforn", 4, "did you mean 'conform'?"},
        Row{"EmitInAnotherSpelling", "emit c++ claimed", 4, "did you mean 'cpp'?"},
        Row{"BeginningOfAVerbOfHelp", "help sim", 4, "did you mean 'simulate'?"},
        Row{"UnknownOptionBeforeTheModel", "check --bogus claimed", 4, "`check` has no option --bogus"},
        Row{"UnknownOptionWithoutAModel", "check --bogus", 4, "`check` has no option --bogus"},
        Row{"OptionWithoutItsFile", "check claimed --html", 4, "--html needs FILE"},
        Row{"OptionGivenTwice", "check claimed --timeout 5 --timeout 6", 4, "--timeout is given twice"},
        Row{"FolderForAScenario", "simulate patrols", 2, "it has patrol.scenario"},
        Row{"FolderForRules", "rules patrols", 2, "it has duties.sleec"},
        Row{"FolderCalledAlmostLikeAVerb", "checks", 0, "checks hold"}, Row{"NoModel", "check", 4, "MODEL is required"},
        Row{"UnknownScriptExport", "cspm --export png P s.csp", 4, "is not one of aut, dot, csp"},
        Row{"AssertionOutOfRange", "cspm --assertion 7 s.csp", 4, "s.csp has 1 assertion"},
        Row{"AssertionOutOfRangeJson", "cspm --format framed_json --assertion 7 s.csp", 4, "s.csp has 1 assertion"},
        // Inputs without checks.
        Row{"NoAssertions", "check plain", 1, "2 of 3 checks hold"},
        Row{"BlocksWithoutAssertions", "check blocks", 1, "2 of 3 checks hold"},
        Row{"NoAssertionsJson", "check --format json plain", 1, "\"core\""},
        Row{"NoAssertionsButCore", "check plain --core --timed", 1, "2 of 3 checks hold"},
        Row{"NoAssertionsButSizes", "check plain --sizes --untimed", 0, "nothing is claimed"},
        Row{"NoAssertionsOfAll", "plain", 1, "2 of 3 checks hold"},
        Row{"TypesAlone", "check types", 2, "nothing is claimed"},
        Row{"NoComponentToConform", "conform types", 2, "no component"},
        Row{"NoComponentToEmit", "emit cpp types", 2, "no component"},
        Row{"NoComponentToMonitor", "emit monitor types", 2, "no component"},
        Row{"NoComponentToTest", "emit tests types", 2, "no component"},
        Row{"NoAssertionsInScript", "cspm none.csp", 3, "there are no assertions"},
        Row{"NoAssertionsInScriptJson", "cspm --format json none.csp", 3, "there are no assertions"},
        Row{"NoAssertionsInScriptJunit", "cspm --format junit none.csp", 3, "<error message=\"nothing is claimed\""},
        Row{"AssertionsBesideTheScript", "cspm s.csp", 0, "1 of 1"},
        Row{"NoAssertionsInOneOfTheScripts", "cspm none.csp s.csp", 0, "1 of 1"},
        Row{"AssertionsInAnotherScript", "cspm beside.csp", 3, "assertions are in beside_assertions.csp"},
        Row{"EmptyScript", "cspm /dev/null", 2, "/dev/null"},
        Row{"CommentsAlone", "cspm comment.csp", 2, "it is empty"}, Row{"PrintsInScript", "cspm prints.csp", 0, "2"},
        Row{"EmptyFolder", "check empty", 2, "empty"}, Row{"EmptyFolderToValidate", "validate empty", 2, "empty"},
        Row{"EmptyFolderToFormat", "format empty", 2, "empty"}, Row{"NoFileToFormat", "format", 4, "required"},
        Row{"NoSuchFile", "check nowhere.rct", 2, "no such file"},
        Row{"NoRunsInLogs", "conform plain --traces logs", 4, "nothing to compare"},
        Row{"NoLogs", "conform plain --traces empty", 4, "no .trace or .mcap files"},
        Row{"Pipe", "check pipe.rct", 2, "is a pipe"}, Row{"PipeInFolder", "validate piped", 2, "is a pipe"},
        Row{"Device", "check /dev/zero", 2, "is a device"}, Row{"PipeToFormat", "format pipe.rct", 2, "is a pipe"},
        Row{"PipeAsLog", "conform plain --traces pipe.rct", 2, "pipe.rct"},
        Row{"PipeAsScript", "cspm pipe.rct", 2, "is a pipe"},
        Row{"PipeAsScenario", "simulate pipe.rct", 2, "is a pipe"},
        // Numbers.
        Row{"TimeoutNone", "check claimed --timeout 0", 0, "checks hold"},
        Row{"TimeoutParts", "check claimed --timeout 55.5", 0, "checks hold"},
        Row{"TimeoutNan", "check claimed --timeout nan", 4, "--timeout"},
        Row{"TimeoutInfinite", "check claimed --timeout inf", 4, "--timeout"},
        Row{"TimeoutNegative", "check claimed --timeout -1", 4, "--timeout"},
        Row{"TimeoutHuge", "check claimed --timeout 1e300", 4, "--timeout"},
        Row{"TimeoutWord", "check claimed --timeout soon", 4, "--timeout"},
        Row{"TimeoutEmpty", "check claimed --timeout ''", 4, "--timeout"},
        Row{"TimeoutOfValidate", "validate claimed --timeout nan", 4, "--timeout"},
        Row{"MemoryUnits", "check claimed --memory 2GiB", 0, "checks hold"},
        Row{"MemoryLetter", "check claimed --memory 2000M", 0, "checks hold"},
        Row{"MemoryNone", "check claimed --memory 0B", 4, "--memory"},
        Row{"MemoryInBytes", "check claimed --memory 2000000000B", 0, "checks hold"},
        Row{"MemoryWithoutUnit", "check claimed --memory 4", 4, "4: expected a size above 0 with a unit"},
        Row{"MemoryNegative", "check claimed --memory -1GiB", 4, "--memory"},
        Row{"MemoryHuge", "check claimed --memory 99999999TiB", 4, "--memory"},
        Row{"MemoryWord", "check claimed --memory much", 4, "--memory"},
        Row{"MemoryUnknownUnit", "check claimed --memory 3parsecs", 4, "--memory"},
        Row{"Threads", "check claimed --threads 1000000", 4, "--threads"},
        Row{"ThreadsNegative", "check claimed --threads -1", 4, "--threads"},
        Row{"StatesNone", "check claimed --max-states 0", 4, "--max-states"},
        Row{"StatesNegative", "check claimed --max-states -5", 4, "--max-states"},
        Row{"StatesHuge", "check claimed --max-states 99999999999999999999999", 4, "--max-states"},
        Row{"CycleNone", "conform claimed --cycle 0", 4, "--cycle"},
        Row{"WalksNegative", "conform claimed --walks -1", 4, "--walks"},
        Row{"TrialsNone", "simulate x --trials 0", 4, "--trials"},
        Row{"SeedNegative", "simulate x --seed -1", 4, "--seed"},
        Row{"ExtraStates", "emit tests claimed --extra-states 9", 4, "--extra-states"},
        Row{"AssertionZero", "cspm --assertion 0 s.csp", 4, "--assertion"}),
    [](const auto& instance) { return std::string(instance.param.name); });

/// Every verb that takes a name reports an unknown name and suggests the nearest one.
TEST(NamesInEveryVerb, AreSuggested) {
    const std::vector<std::string> models{"verify",       "check",      "emit csp", "emit cpp",
                                          "emit monitor", "emit tests", "conform"};
    std::vector<std::pair<std::string, std::string>> commands;
    for (const std::string& verb : models) {
        commands.emplace_back(verb + " claimed --const sped=1", "did you mean 'speed'?");
        commands.emplace_back(verb + " claimed --range nta=0..1", "did you mean 'nat'?");
        commands.emplace_back(verb + " claimed --allow RC-W077", "did you mean 'RC-W07'?");
        commands.emplace_back(verb + " claimed --format jsn", "did you mean 'json'?");
        commands.emplace_back(verb + " claimed --quite", "did you mean '--quiet'?");
    }
    for (const std::string verb : {"verify", "check"})
        commands.emplace_back(verb + " claimed --assertion Movs", "did you mean 'Moves'?");
    for (const std::string verb : {"verify", "emit cpp", "emit monitor", "emit tests", "conform"})
        commands.emplace_back(verb + " claimed --component Walkr", "did you mean 'Walker'?");
    for (const std::string verb : {"validate claimed", "simulate 'CORPUS'"})
        commands.emplace_back(verb + " --allow RC-W077", "did you mean 'RC-W07'?");
    commands.emplace_back("simulate 'CORPUS' --const Turns=1", "--const Turns: the model has no constant");
    std::string script = files;
    for (const auto& [command, message] : commands) {
        std::string line = "timeout 60 \"$verify\" " + command + "; echo \"exit $?\"\n";
        if (const std::size_t at = line.find("CORPUS"); at != std::string::npos)
            line.replace(at, 6, repository("corpus/aggregation/aggregation.scenario"));
        const Ran ran = run_shell(script + line);
        EXPECT_EQ(ran.out, "exit 4\n") << command;
        EXPECT_THAT(ran.err, HasSubstr(message)) << command;
    }
}

}  // namespace
}  // namespace robochart::app::testing::selection_test
