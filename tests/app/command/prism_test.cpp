// SPDX-License-Identifier: Apache-2.0
// Tests the verb `prism`: answers, formats, exit codes, bad input.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/app/command.hpp"
#include "tests/contents.hpp"

namespace robochart::app::testing::prism_test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// A model that goes from 0 to 1 with probability p, otherwise to 2.
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
    EXPECT_EQ(ask({"--const", "p=1/3", "--property", "P=? [ G (s=1 => F (s=0 & G s=2)) ]"}).exit, 3);
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
    EXPECT_EQ(ran.exit, 2);  // the model has no rewards, so no property is decided
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

TEST_F(Prism, JsonSaysOfWhichKindTheModelIsAlsoWhereAPropertyIsWrong) {
    const TemporaryFile mdp("open.prism", "mdp\nmodule M s:[0..1]; [] true -> (s'=1); endmodule\n");
    EXPECT_EQ(json::parse(run({"prism", mdp.path(), "--property", "P=? [", "--format", "json"}).out)["kind"], "mdp");
    EXPECT_EQ(json::parse(ask({"--property", "P=? [", "--format", "json"}).out)["kind"], "dtmc");
    const TemporaryFile none("none.prism", "module");
    EXPECT_FALSE(json::parse(run({"prism", none.path(), "--format", "json"}).out).contains("kind"));
}

TEST_F(Prism, StatesOfAnExtremeValueAreListed) {
    const std::vector<std::string> options{"--const", "p=1/3", "--property", "filter(argmax, P=? [ F s=1 ])"};
    const Ran text = ask(options);
    EXPECT_EQ(text.exit, 0);
    EXPECT_THAT(text.out, HasSubstr("  1 state\n  "));
    EXPECT_THAT(text.out, HasSubstr("  s=1: 1\n"));
    std::vector<std::string> as_json = options;
    as_json.insert(as_json.end(), {"--format", "json"});
    const json answer = json::parse(ask(as_json).out)["runs"][0]["answers"][0];
    EXPECT_EQ(answer["answer"], "states");
    EXPECT_EQ(answer["printed"][0]["state"], "s=1");
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

/// If a property cannot be evaluated, the others are still answered.
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

TEST_F(Prism, PathsAreSampled) {
    const std::vector<std::string> question{"--const", "p=0.25", "--property", "P=? [ F s=1 ]", "--sim", "ci"};
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.begin(), question.begin(), question.end());
        return ask(more);
    };
    const Ran text = with({"--seed", "3"});
    EXPECT_EQ(text.exit, 0) << text.err;
    // A path stops after one step if it reaches the target. Otherwise it stops when s=2 repeats. The mean length is
    // about 1.75 steps.
    EXPECT_THAT(text.out, HasSubstr("at 99 % (ci, 1000 paths of 1.8 steps, 1 to 2)"));
    EXPECT_THAT(text.out, HasSubstr("Clopper-Pearson: from 0.2"));
    EXPECT_THAT(text.out, ::testing::Not(HasSubstr("states")));
    EXPECT_EQ(text.out, with({"--seed", "3", "--threads", "1"}).out);
    EXPECT_NE(text.out, with({"--seed", "4"}).out);
    const json answer = json::parse(with({"--format", "json"}).out)["runs"][0]["answers"][0];
    EXPECT_EQ(answer["answer"], "estimate");
    EXPECT_DOUBLE_EQ(answer["value"].get<double>(), answer["estimate"]["hits"].get<double>() / 1000);
    EXPECT_LE(answer["low"].get<double>(), 0.25);
    EXPECT_GE(answer["high"].get<double>(), 0.25);
    EXPECT_FALSE(answer.contains("exact"));
    EXPECT_THAT(with({"--format", "csv"}).out, HasSubstr(",estimate,"));
    EXPECT_EQ(with({"--exact"}).exit, 4);
    EXPECT_EQ(with({"--export", "tra"}).exit, 4);
    EXPECT_EQ(ask({"--const", "p=0.25", "--property", "P=? [ F s=1 ]", "--sim", "cii"}).exit, 4);
    EXPECT_EQ(ask({"--const", "p=0.25", "--property", "P>=0.25 [ F s=1 ]", "--sim", "ci"}).exit, 3);
    EXPECT_EQ(ask({"--const", "p=0.25", "--property", "P>=0.6 [ F s=1 ]", "--sim", "sprt"}).exit, 1);
}

TEST_F(Prism, AnMdpIsSampledUnderANamedSchedulerOnly) {
    const TemporaryFile mdp("choice.prism",
                            "mdp module M s:[0..2]; [] s=0 -> (s'=1); [] s=0 -> (s'=2); [] s>0 -> true; endmodule");
    const std::vector<std::string> question{"prism", mdp.path(), "--property", "P=? [ F s=1 ]"};
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.begin(), question.begin(), question.end());
        return run(more);
    };
    const Ran refused = with({"--sim", "ci"});
    EXPECT_EQ(refused.exit, 4);
    EXPECT_THAT(refused.err, HasSubstr("--scheduler uniform"));
    EXPECT_EQ(with({"--sim", "ci", "--scheduler", "uniform"}).exit, 0);
    const Ran exact = with({"--exact", "--scheduler", "uniform"});
    EXPECT_THAT(exact.out, HasSubstr("mdp under the scheduler uniform, 3 states"));
    EXPECT_THAT(exact.out, HasSubstr("\n  0.5\n"));
}

TEST_F(Prism, ViolatedBoundsShowPaths) {
    const std::vector<std::string> question{"--const", "p=0.75", "--property", "P<=0.5 [ F s=1 ]"};
    const Ran text = ask(question);
    EXPECT_EQ(text.exit, 1);
    EXPECT_THAT(text.out, HasSubstr("    a path on which the formula holds has probability 0.75, above 0.5\n"
                                    "    0.75: s=0\n      M (line 2): s=1\n"));
    std::vector<std::string> as_json = question;
    as_json.insert(as_json.end(), {"--format", "json"});
    const json found = json::parse(ask(as_json).out)["runs"][0]["answers"][0]["counterexample"];
    EXPECT_EQ(found["count"], 1);
    EXPECT_EQ(found["low"], 0.75);
    EXPECT_EQ(found["paths"][0]["steps"][0]["state"], "s=1");
    EXPECT_EQ(found["paths"][0]["steps"][0]["by"][0]["commands"][0]["line"], 2);
    std::vector<std::string> graph = question;
    graph.insert(graph.end(), {"--export", "counterexample"});
    EXPECT_THAT(ask(graph).out, StartsWith("digraph counterexample"));
    EXPECT_EQ(ask({"--const", "p=0.25", "--property", "P<=0.5 [ F s=1 ]", "--export", "counterexample"}).exit, 3);
    EXPECT_EQ(ask({"--const", "p=0.25", "--property", "P<=0.5 [ F s=1 ]; true", "--export", "strategy"}).exit, 4);
    EXPECT_EQ(ask({"--const", "p=0.25", "--property", "P<=0.5 [ F<=3 s=1 ]", "--export", "strategy"}).exit, 3);
}

/// Parallel runs give the same results as a sequential run.
TEST_F(Prism, ExperimentsAreTheSameForAnyNumberOfThreads) {
    const std::vector<std::string> question{"--const", "p=0:0.1:1,t=1:3", "--property",
                                            "const int t; P=? [ F<=t s=1 ]; P<=0.5 [ F<=t s=1 ]"};
    std::string first;
    for (const char* const threads : {"1", "2", "5"}) {
        std::vector<std::string> arguments = question;
        arguments.insert(arguments.end(), {"--threads", threads});
        const Ran ran = ask(arguments);
        EXPECT_EQ(ran.exit, 1);
        if (first.empty()) first = ran.out;
        EXPECT_EQ(ran.out, first) << threads;
    }
    // The experiment ends with the first set of values whose model is invalid, whichever thread finds an invalid model
    // first.
    for (const char* const threads : {"1", "4"}) {
        const Ran wrong =
            ask({"--const", "p=0.8:0.1:1.9", "--property", "P=? [ F s=1 ]", "--format", "json", "--threads", threads});
        EXPECT_EQ(wrong.exit, 2);
        EXPECT_EQ(json::parse(wrong.out)["runs"].size(), 4U) << threads;  // 0.8, 0.9, 1 and 1.1
    }
}

TEST_F(Prism, ExperimentsAreDrawn) {
    const TemporaryFile plot("plot.svg", "");
    const std::vector<std::string> question{"--property", "P=? [ F s=1 ]; 2 * P=? [ F s=1 ]", "--plot", plot.path()};
    const auto with = [&](const std::string& constants) {
        std::vector<std::string> arguments{"--const", constants};
        arguments.insert(arguments.end(), question.begin(), question.end());
        return ask(arguments);
    };
    EXPECT_EQ(with("p=0:0.25:1").exit, 0);
    const std::string svg = tests::read_contents(plot.path());
    EXPECT_THAT(svg, StartsWith("<svg"));
    std::size_t points = 0;
    for (std::size_t at = svg.find("<circle"); at != std::string::npos; at = svg.find("<circle", at + 1)) ++points;
    EXPECT_EQ(points, 10U);  // two properties for five values
    EXPECT_THAT(svg, HasSubstr("P=? [ F s = 1 ]"));
    EXPECT_EQ(with("p=0.5").exit, 4);
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
}  // namespace robochart::app::testing::prism_test
