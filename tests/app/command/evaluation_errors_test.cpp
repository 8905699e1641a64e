// SPDX-License-Identifier: Apache-2.0
// Tests that every verb that evaluates a script reports an evaluation error with its place in the model, and exits with
// code 2.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/app/command.hpp"

namespace robochart::app::testing::evaluation_errors_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

// Line 7 divides by the weight, which may be 0.
const std::string sorter = R"(stm Sorter {
	event weight : nat
	event lane : nat
	var w : nat
	initial i
	state Ready { }
	transition t0 { from Ready to Ready trigger weight ? w action send lane ! (6 % w) }
	transition t1 { from i to Ready }
}
)";
const std::string rules = R"(def_start
	event weight
	event lane
def_end
rule_start
	Lane when weight then lane within 2 seconds
rule_end
)";
const std::string log = "robochart-trace 1\ncomponent Sorter\nrun one\nweight?0 lane!0 tock\n";

struct Question {
    const char* name;
    std::vector<std::string> arguments;  ///< follow those of the verb; "MODEL", "RULES" and "LOG" are files
    std::string input;
};

void PrintTo(const Question& question, std::ostream* out) {
    *out << question.name;
}

class EvaluationErrors : public ::testing::TestWithParam<Question> {};

TEST_P(EvaluationErrors, HaveThePlaceOfTheModel) {
    const Folder folder({{"sorter.rct", sorter}, {"lanes.sleec", rules}, {"one.trace", log}});
    std::vector<std::string> arguments = GetParam().arguments;
    for (std::string& argument : arguments) {
        if (argument == "MODEL") argument = folder / "sorter.rct";
        if (argument == "RULES") argument = folder / "lanes.sleec";
        if (argument == "LOG") argument = folder / "one.trace";
        if (argument == "OUT") argument = folder / "out";
    }
    const Ran ran = run(arguments, GetParam().input);
    EXPECT_EQ(ran.exit, 2) << ran.out << ran.err;
    EXPECT_THAT(ran.out + ran.err, HasSubstr("sorter.rct:7")) << ran.out << ran.err;
    EXPECT_THAT(ran.out + ran.err, HasSubstr("division by zero"));
    EXPECT_THAT(ran.out + ran.err, HasSubstr("Sorter::t0"));
    EXPECT_THAT(ran.err, Not(HasSubstr("internal error")));
}

INSTANTIATE_TEST_SUITE_P(Verbs, EvaluationErrors,
                         ::testing::Values(Question{"check", {"check", "MODEL", "--core"}, ""},
                                           Question{"rules", {"rules", "RULES", "MODEL"}, ""},
                                           Question{"conform", {"conform", "MODEL"}, ""},
                                           Question{"monitor", {"emit", "monitor", "MODEL", "--out", "OUT"}, ""},
                                           Question{"tests", {"emit", "tests", "MODEL", "--out", "OUT"}, ""},
                                           Question{"traces", {"conform", "MODEL", "--traces", "LOG"}, ""},
                                           Question{"step", {"step", "MODEL", "Sorter"}, "1\n1\n1\n"}),
                         [](const auto& instance) { return std::string(instance.param.name); });

// Line 7 reads element i of a sequence of two. With i = 1 the element exists. With i = 0, a function of the scripts'
// library detects the error at its end.
const std::string indexed = R"(stm Belt {
	event next
	event lane : nat
	var lanes : Seq(nat) = <1, 2>
	var i : int = 1
	initial j
	state On { entry lane ! (lanes[i]) }
	transition t0 { from j to On }
	transition t1 { from On to On trigger next action i = 1 - i }
}
)";

class MissingElements : public ::testing::TestWithParam<Question> {};

TEST_P(MissingElements, HaveThePlaceOfTheModel) {
    const Folder folder({{"belt.rct", indexed}});
    std::vector<std::string> arguments = GetParam().arguments;
    for (std::string& argument : arguments) {
        if (argument == "MODEL") argument = folder / "belt.rct";
        if (argument == "OUT") argument = folder / "out";
    }
    const Ran ran = run(arguments, GetParam().input);
    EXPECT_EQ(ran.exit, 2) << ran.out << ran.err;
    const std::string printed = ran.out + ran.err;
    EXPECT_THAT(printed, HasSubstr("belt.rct:7"));
    EXPECT_THAT(printed, HasSubstr("the sequence <1, 2> has no element 0: the first is element 1, in Belt::On"));
    EXPECT_THAT(printed, Not(HasSubstr("library of generated scripts")));
}

INSTANTIATE_TEST_SUITE_P(Verbs, MissingElements,
                         ::testing::Values(Question{"check", {"check", "MODEL", "--core"}, ""},
                                           Question{"monitor", {"emit", "monitor", "MODEL", "--out", "OUT"}, ""},
                                           Question{"tests", {"emit", "tests", "MODEL", "--out", "OUT"}, ""}),
                         [](const auto& instance) { return std::string(instance.param.name); });

TEST(MissingElementsOfTheEmptySequence, AreSaid) {
    const std::string belt =
        "stm Belt {\n event lane : nat\n var lanes : Seq(nat) = <>\n initial j\n"
        " state On { entry lane ! (lanes[1]) }\n transition t0 { from j to On }\n}\n";
    const Folder folder({{"belt.rct", belt}});
    const Ran ran = run({"check", folder / "belt.rct", "--core"});
    EXPECT_EQ(ran.exit, 2) << ran.out << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("belt.rct:5: the sequence is empty"));
}

/// Returns two machines. Worker computes a remainder by a number that only Feeder sends. Feeder sends 2, 1 and then 3
/// or, if it `may`, 0.
std::vector<std::pair<std::string, std::string>> fed_worker(bool may) {
    const std::string last = may ? "0" : "3";
    return {{"m/m.rct",
             "stm Worker {\n event n : nat\n event done : nat\n var w : nat\n initial i\n state A { }\n"
             " transition t0 { from i to A }\n"
             " transition t1 { from A to A trigger n ? w action done ! (6 % w) }\n}\n"
             "stm Feeder {\n event go\n event n : nat\n initial i\n state A { }\n state B { }\n state C { }\n"
             " state D { }\n transition t0 { from i to A }\n"
             " transition t1 { from A to B trigger go action n ! 2 }\n"
             " transition t2 { from B to C trigger go action n ! 1 }\n"
             " transition t3 { from C to D trigger go action n ! " +
                 last +
                 " }\n}\n"
                 "controller Pair {\n event go\n event done : nat\n sref w = Worker\n sref f = Feeder\n"
                 " connection Pair on go to f on go\n connection f on n to w on n\n"
                 " connection w on done to Pair on done\n}\n"},
            {"m/m.assertions",
             "untimed csp Nothing csp-begin Nothing = STOP csp-end\n"
             "untimed assertion Diverges : Pair is divergence-free\n"
             "untimed assertion Silent : Pair refines Nothing in the traces model\n"
             "untimed assertion Feeds : Feeder is divergence-free\n"
             "untimed assertion Ends : Pair is deadlock-free\n"}};
}

nlohmann::json answers_of(const Ran& ran) {
    const nlohmann::json report = nlohmann::json::parse(ran.out, nullptr, false);
    nlohmann::json result;
    if (report.is_discarded()) return result;
    for (const nlohmann::json& assertion : report.at("assertions"))
        result[assertion.at("name").get<std::string>()] = assertion;
    return result;
}

/// Worker alone would accept 0, but no run of the controller divides by 0.
TEST(EvaluationErrorsOfParts, ThatNoRunReachesDecideNothing) {
    const Folder folder(fed_worker(false));
    const Ran ran = run({"check", folder / "m", "--no-cache", "--format", "json"});
    const nlohmann::json answers = answers_of(ran);
    ASSERT_FALSE(answers.is_null()) << ran.out << ran.err;
    EXPECT_EQ(answers.at("Diverges").at("answer"), "holds") << ran.out;
    EXPECT_EQ(answers.at("Silent").at("answer"), "fails") << ran.out;
    EXPECT_EQ(answers.at("Feeds").at("answer"), "holds") << ran.out;
    EXPECT_EQ(answers.at("Ends").at("answer"), "fails") << ran.out;
}

/// A claim that fails before the division by 0 fails. A claim that does not is undecided, and its report shows a run to
/// the division.
TEST(EvaluationErrorsOfParts, ThatARunReachesAreShownWithTheRun) {
    const Folder folder(fed_worker(true));
    const Ran ran = run({"check", folder / "m", "--no-cache", "--format", "json"});
    const nlohmann::json answers = answers_of(ran);
    ASSERT_FALSE(answers.is_null()) << ran.out << ran.err;
    EXPECT_EQ(answers.at("Silent").at("answer"), "fails") << ran.out;
    EXPECT_EQ(answers.at("Feeds").at("answer"), "holds") << ran.out;
    const nlohmann::json& open = answers.at("Diverges");
    EXPECT_EQ(open.at("answer"), "error") << ran.out;
    EXPECT_THAT(open.at("reason").get<std::string>(), HasSubstr("m.rct:8: division by zero, in Worker::t1"));
    ASSERT_TRUE(open.contains("counterexample")) << ran.out;
    const nlohmann::json& run_to_error = open.at("counterexample");
    EXPECT_EQ(run_to_error.at("end").at("kind"), "undefined");
    std::size_t inputs = 0;
    for (const nlohmann::json& step : run_to_error.at("steps")) inputs += step.at("kind") == "input" ? 1U : 0U;
    EXPECT_EQ(inputs, 3U) << "go, go, go\n" << ran.out;
    EXPECT_EQ(ran.exit, 2) << ran.err;
}

// The error has the place of line 2, which declares the call: its two real parameters have too many combinations of
// values.
TEST(EvaluationErrorsOfTypes, HaveThePlaceOfTheDeclaration) {
    const Folder folder(
        {{"arm.rct",
          "interface Arm {\n reach(x : real, y : real)\n}\nstm Turn {\n requires Arm\n event go\n initial i\n "
          "state A { entry reach(-70000, 0.01) }\n transition t0 { from i to A }\n transition t1 { from A to A "
          "trigger go }\n}\n"},
         {"arm.sleec",
          "def_start\n event go\n event done\n measure near : boolean\ndef_end\nrule_start\n R when go then "
          "done\nrule_end\n"}});
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"check", folder / "arm.rct", "--core", "--concrete"},
          std::vector<std::string>{"rules", folder / "arm.sleec", folder / "arm.rct"}}) {
        const Ran ran = run(arguments);
        EXPECT_EQ(ran.exit, 2) << ran.out << ran.err;
        EXPECT_THAT(ran.out + ran.err, HasSubstr("arm.rct:2: a type has more than")) << arguments.front();
    }
}

TEST(EvaluationErrorsOfRules, AreVerdicts) {
    const Folder folder(
        {{"half.rct",
          "stm Half {\n event go\n event done\n var w : nat\n initial i\n state A { }\n transition t0 { from i "
          "to A }\n transition t1 { from A to A trigger go condition 6 % w > 0 action send done }\n}\n"},
         {"half.sleec",
          "def_start\n event go\n event done\ndef_end\nrule_start\n R when go then done within 2 "
          "seconds\nrule_end\n"}});
    const Ran ran = run({"rules", folder / "half.sleec", folder / "half.rct", "--format", "json"});
    EXPECT_EQ(ran.exit, 2) << ran.out << ran.err;
    const auto json = nlohmann::json::parse(ran.out);
    EXPECT_EQ(json.at("verdicts").at(0).at("verdict"), "error");
    EXPECT_THAT(json.at("verdicts").at(0).at("reason").get<std::string>(), HasSubstr("half.rct:8"));
}

TEST(EvaluationErrorsOfConformance, AreOutcomes) {
    const Folder folder({{"sorter.rct", sorter}});
    const Ran ran = run({"conform", folder / "sorter.rct", "--format", "json"});
    EXPECT_EQ(ran.exit, 2);
    const auto json = nlohmann::json::parse(ran.out);
    EXPECT_EQ(json.at("conformance").at(0).at("outcome"), "error");
    EXPECT_THAT(run({"conform", folder / "sorter.rct", "--format", "junit"}).out, HasSubstr("<error"));
}

}  // namespace
}  // namespace robochart::app::testing::evaluation_errors_test
