// The verb `prism` as a user runs it: answers, formats, exit codes, bad input.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/app/command.hpp"

namespace robochart::app::testing {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// From 0 to 1 with p, else to 2.
constexpr const char* fork =
    "dtmc const double p; const int n = 2;\n"
    "module M s:[0..n]; [] s=0 -> p:(s'=1) + 1-p:(s'=2); [] s>0 -> true; endmodule\n"
    "label \"one\" = s=1;\n";

class Prism : public ::testing::Test {
protected:
    Ran ask(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), {"prism", model_.path()});
        return run(arguments);
    }
    TemporaryFile model_{"fork.prism", fork};
};

TEST_F(Prism, ExitCodesFollowTheAnswers) {
    EXPECT_EQ(ask({"--const", "p=1/3", "--property", "P=? [ F \"one\" ]"}).exit, 0);
    EXPECT_EQ(ask({"--const", "p=1/3", "--property", "P>0.3 [ F s=1 ]"}).exit, 0);
    EXPECT_EQ(ask({"--const", "p=1/3", "--property", "P>0.4 [ F s=1 ]"}).exit, 1);
    EXPECT_EQ(ask({"--const", "p=1/3", "--property", "P=? [ F (s=1 & (X s=2)) ]"}).exit, 3);
    EXPECT_EQ(ask({"--const", "p=1/3", "--property", "P=? [ F t=1 ]"}).exit, 2);
    EXPECT_EQ(ask({"--const", "p=1.5"}).exit, 2);
    EXPECT_EQ(ask({}).exit, 2);
    EXPECT_EQ(ask({"--const", "q=1"}).exit, 4);
    EXPECT_EQ(ask({"--const", "p=true"}).exit, 4);
    EXPECT_EQ(ask({"--const", "p=0.1", "--const", "p=0.2"}).exit, 4);
    EXPECT_EQ(ask({"--const", "p=0.1", "--epsilon", "2"}).exit, 4);
    const Ran missing = run({"prism", "missing.prism"});
    EXPECT_EQ(missing.exit, 2);
    EXPECT_THAT(missing.err, HasSubstr("error[PRISM-P08]"));
    EXPECT_EQ(run({"prism"}).exit, 4);
}

TEST_F(Prism, FractionsAreExact) {
    const Ran ran = ask({"--const", "p=1/3", "--property", "P=? [ F s=1 ]", "--exact", "-q"});
    EXPECT_EQ(ran.out, "P=? [ F s = 1 ]\n  1/3\n");
}

TEST_F(Prism, JsonHoldsTheValueBetweenItsBounds) {
    const Ran ran = ask(
        {"--const", "p=1/3", "--property", "\"a\": P=? [ F s=1 ]; P>=0.5 [ F s=1 ]; R=? [ C ]", "--format", "json"});
    EXPECT_EQ(ran.exit, 2);  // there are no rewards: nothing is decided
    const json found = json::parse(
        ask({"--const", "p=1/3", "--property", "\"a\": P=? [ F s=1 ]; P>=0.5 [ F s=1 ]", "--format", "json"}).out);
    EXPECT_EQ(found["schema"], "robochart-verify/prism/1");
    const json& run = found["runs"][0];
    EXPECT_EQ(run["states"], 3);
    EXPECT_EQ(run["transitions"], 4);
    EXPECT_EQ(run["constants"]["p"], "1/3");
    EXPECT_LE(run["answers"][0]["low"].get<double>(), 1.0 / 3);
    EXPECT_GE(run["answers"][0]["high"].get<double>(), 1.0 / 3);
    EXPECT_EQ(run["answers"][1]["answer"], "false");
    EXPECT_EQ(run["answers"][1]["state"], "s=0");
    EXPECT_EQ(found["properties"][0]["name"], "a");
}

TEST_F(Prism, ExperimentsHaveARowForEachCombination) {
    const Ran ran = ask(
        {"--const", "p=0:0.5:1,t=1:2", "--property", "const int t; P=? [ F<=t s=1 ]", "--format", "csv", "--exact"});
    EXPECT_EQ(ran.exit, 0) << ran.err;
    EXPECT_EQ(ran.out,
              "p,t,property,answer,value,low,high\n"
              "0,1,P=? [ F<=t s = 1 ],number,0,0,0\n0,2,P=? [ F<=t s = 1 ],number,0,0,0\n"
              "0.5,1,P=? [ F<=t s = 1 ],number,0.5,0.5,0.5\n0.5,2,P=? [ F<=t s = 1 ],number,0.5,0.5,0.5\n"
              "1,1,P=? [ F<=t s = 1 ],number,1,1,1\n1,2,P=? [ F<=t s = 1 ],number,1,1,1\n");
}

TEST_F(Prism, ExportsTheStateSpace) {
    EXPECT_EQ(ask({"--const", "p=0.5", "--export", "tra"}).out, "3 4\n0 1 0.5\n0 2 0.5\n1 1 1\n2 2 1\n");
    EXPECT_EQ(ask({"--const", "p=0.5", "--export", "sta"}).out, "(s)\n0:(0)\n1:(1)\n2:(2)\n");
    EXPECT_THAT(ask({"--const", "p=0.5", "--export", "dot"}).out, StartsWith("digraph"));
    EXPECT_EQ(ask({"--const", "p=0:1", "--export", "dot"}).exit, 4);
}

TEST_F(Prism, ErrorsInAStateNameIt) {
    const TemporaryFile grows("grows.prism", "dtmc module M x:[0..2]; [] true -> (x'=x+1); endmodule");
    const Ran ran = run({"prism", grows.path(), "--format", "json"});
    EXPECT_EQ(ran.exit, 2);
    EXPECT_THAT(ran.err, HasSubstr("in the state x=2"));
    EXPECT_THAT(json::parse(ran.out)["errors"][0].get<std::string>(), HasSubstr("outside its range"));
}

/// One property that cannot be evaluated does not hide the others.
TEST_F(Prism, EachPropertyIsDecidedForItself) {
    const Ran ran = ask({"--const", "p=0.5", "--property", "mod(1,0); P=? [ F s=1 ]", "--format", "json"});
    EXPECT_EQ(ran.exit, 2);
    const json answers = json::parse(ran.out)["runs"][0]["answers"];
    EXPECT_EQ(answers[0]["answer"], "error");
    EXPECT_EQ(answers[1]["low"], 0.5);
}

TEST_F(Prism, LimitsEndItWithWhatIsKnown) {
    const TemporaryFile large(
        "large.prism",
        "dtmc module M x:[0..2000000000]; [] x<2000000000 -> (x'=x+1); [] x=2000000000 -> true; endmodule");
    const Ran few = run({"prism", large.path(), "--max-states", "1000", "--format", "json"});
    EXPECT_EQ(few.exit, 3);
    EXPECT_THAT(json::parse(few.out)["limit"].get<std::string>(), HasSubstr("more than 1000 states"));
    const Ran late = run({"prism", large.path(), "--timeout", "0.5", "--property", "P=? [ F x=3 ]"});
    EXPECT_EQ(late.exit, 3);
    EXPECT_THAT(late.err, HasSubstr("the time limit was reached while exploring"));
}

TEST_F(Prism, HostileTextsAreRefused) {
    const std::string deep(200'000, '(');
    for (const std::string& text :
         {std::string("dtmc \x01\xff\x1b[31m"), "dtmc formula f = " + deep, "dtmc label \"" + deep,
          std::string("dtmc module M x:[0..1]; [] true -> (x'=\x1b[2J); endmodule")}) {
        const Ran ran = run({"prism", "-"}, text);
        EXPECT_EQ(ran.exit, 2);
        EXPECT_EQ(ran.err.find('\x1b'), std::string::npos);
    }
}

}  // namespace
}  // namespace robochart::app::testing
