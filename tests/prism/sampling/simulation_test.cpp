// SPDX-License-Identifier: Apache-2.0
// Compares statistical model checking with exact answers. Seeds are fixed. If an interval at 1e-6 does not contain the
// exact value, this is almost certainly a bug.
#include "prism/session/simulation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "prism/sampling/path_question.hpp"
#include "prism/session/experiment.hpp"
#include "tests/contents.hpp"
#include "tests/needed.hpp"
#include "tests/prism/support.hpp"
#include "tests/shared_folder.hpp"

namespace robochart::prism {
namespace {

using testing::Explored;
using testing::failure_text;
using ::testing::HasSubstr;
using testing::Read;
using Kind = Result::Kind;

/// A model that is sampled without exploration.
struct Sampled {
    explicit Sampled(const std::string& model, const Values& constants = {}) {
        const ModelFile file = read_model(read.sources, read.add(model), read.diagnostics);
        if (read.diagnostics.ok()) checked = check_model(file, read.diagnostics);
        if (!checked) throw std::runtime_error(read.report());
        instance.emplace(*checked, constants);
    }

    Result ask(const std::string& text, const std::string& method = "ci", std::uint64_t seed = 1,
               unsigned threads = 2) {
        const PropertyFile file = read_properties(read.sources, read.add(text, "model.props"), read.diagnostics);
        const CheckedProperties properties = check_properties(*checked, file, read.diagnostics);
        if (!read.diagnostics.ok()) throw std::runtime_error(read.report());
        try {
            return simulate(*instance, properties, properties.properties.size() - 1, {},
                            {read_method(method), seed, threads, nullptr}, read.diagnostics);
        } catch (const EvaluationError& error) {
            error.report(read.diagnostics);
            throw std::runtime_error(read.report());
        }
    }

    Read read;
    std::optional<CheckedModel> checked;
    std::optional<Instance> instance;
};

/// A die that is simulated with coins (Knuth and Yao). Its sides have equal probability.
constexpr const char* die =
    "dtmc module M s:[0..7]; d:[0..6];\n"
    "[] s=0 -> 0.5:(s'=1) + 0.5:(s'=2); [] s=1 -> 0.5:(s'=3) + 0.5:(s'=4); [] s=2 -> 0.5:(s'=5) + 0.5:(s'=6);\n"
    "[] s=3 -> 0.5:(s'=1) + 0.5:(s'=7)&(d'=1); [] s=4 -> 0.5:(s'=7)&(d'=2) + 0.5:(s'=7)&(d'=3);\n"
    "[] s=5 -> 0.5:(s'=7)&(d'=4) + 0.5:(s'=7)&(d'=5); [] s=6 -> 0.5:(s'=2) + 0.5:(s'=7)&(d'=6);\n"
    "[] s=7 -> (s'=7); endmodule\n"
    "rewards \"flips\" [] s<7 : 1; endrewards rewards \"here\" s<7 : 2; endrewards\n";

/// Two modules with a common action, commands that overlap, and a deadlock at x=3.
constexpr const char* pair =
    "dtmc module A x:[0..3]; [a] x<3 -> 0.3:(x'=x+1) + 0.7:true; [a] x=1 -> (x'=3); [] x=0 -> 0.5:(x'=1) + 0.5:true;\n"
    "endmodule module B y:[0..2]; [a] y<2 -> (y'=y+1); [a] true -> 0.9:(y'=0) + 0.1:(y'=2); endmodule\n"
    "label \"end\" = x=3; rewards \"r\" [a] true : y; x=1 : 0.5; endrewards\n";

struct Case {
    const char* model;
    const char* property;
};

/// Compares an estimate with the exact value, which must be inside the Clopper-Pearson interval, or within five
/// standard deviations of a mean.
void expect_near_exact(const Case& test_case, const std::string& method) {
    const double exact = Explored(test_case.model).ask(test_case.property).low.bounds().middle();
    const Result found = Sampled(test_case.model).ask(test_case.property, method);
    ASSERT_EQ(found.kind, Kind::number) << test_case.property << ": " << found.reason;
    const Estimate& estimate = *found.estimate;
    const double low = estimate.binomial ? estimate.binomial->low : estimate.mean - *estimate.width;
    const double high = estimate.binomial ? estimate.binomial->high : estimate.mean + *estimate.width;
    EXPECT_LE(low, exact) << test_case.property;
    EXPECT_GE(high, exact) << test_case.property;
    EXPECT_LE(high - low, 0.2 * std::max(1.0, exact)) << test_case.property;
}

TEST(PrismSimulation, EstimatesAgreeWithExactValues) {
    const Case cases[] = {
        {die, "P=? [ F d=6 ]"},
        {die, "P=? [ X s=1 ]"},
        {die, "P=? [ X X s=3 ]"},
        {die, "P=? [ F<=4 d>0 ]"},
        {die, "P=? [ F<4 d>0 ]"},
        {die, "P=? [ F>3 s=2 ]"},
        {die, "P=? [ F[2,3] s=1 | s=2 ]"},
        {die, "P=? [ s!=2 U d>0 ]"},
        {die, "P=? [ s<3 U<=2 s=3 ]"},
        {die, "P=? [ G s!=2 ]"},
        {die, "P=? [ G<=3 s!=7 ]"},
        {die, "P=? [ s!=1 W d=6 ]"},
        {die, "P=? [ d=3 R s!=2 ]"},
        {die, "P=? [ !(F d=6) ]"},
        {die, "P=? [ s=0 ]"},
        {pair, "P=? [ F \"end\" ]"},
        {pair, "P=? [ F \"deadlock\" ]"},
        {pair, "P=? [ !\"init\" U y=2 ]"},
        {pair, "P=? [ F<=5 x=3 & y=2 ]"},
        {die, "R{\"flips\"}=? [ F s=7 ]"},
        {die, "R{\"flips\"}=? [ C<=5 ]"},
        {die, "R{\"here\"}=? [ I=3 ]"},
        {die, "R{\"here\"}=? [ F d>0 ]"},
        {pair, "R{\"r\"}=? [ F x=3 ]"},
        {pair, "R{\"r\"}=? [ C<=4 ]"},
    };
    for (const Case& test_case : cases) expect_near_exact(test_case, "ci,samples=4000,confidence=0.000001");
}

/// Without a scheduler, an mdp is refused. With the uniform scheduler, it is simulated like a dtmc with the same text.
TEST(PrismSimulation, AnMdpIsRefusedWithoutAScheduler) {
    EXPECT_THAT(Sampled("mdp module M x:[0..1]; [] true -> (x'=1); endmodule").ask("Pmax=? [ F x=1 ]").reason,
                HasSubstr("scheduler"));
}

/// The numeric engine does not support nested path formulas. The paths to sides 1 to 3 go through s=1.
TEST(PrismSimulation, ConnectivesOfPathFormulas) {
    const auto about = [](const char* property, double value) {
        const Result found = Sampled(die).ask(property, "ci,samples=4000,confidence=0.000001");
        ASSERT_TRUE(found.estimate) << property << ": " << found.reason;
        EXPECT_LE(found.estimate->binomial->low, value) << property;
        EXPECT_GE(found.estimate->binomial->high, value) << property;
    };
    about("P=? [ (F s=1) & (F d=2) ]", 1.0 / 6);
    about("P=? [ (F d=1) | (F d=2) ]", 1.0 / 3);
    about("P=? [ (F s=1) => (F d=1) ]", 1 - 1.0 / 2 + 1.0 / 6);
    about("P=? [ (F s=1) <=> (F d<=3 & d>0) ]", 1);
}

TEST(PrismSimulation, TheSameForAnyNumberOfThreads) {
    for (const char* const method : {"ci", "aci,width=0.02", "apmc,width=0.03,confidence=0.1", "sprt,width=0.02"}) {
        const bool bound = std::string(method).starts_with("sprt");
        const char* const property = bound ? "P>=0.1 [ F d=6 ]" : "P=? [ F d=6 ]";
        const Result one = Sampled(die).ask(property, method, 7, 1);
        for (const unsigned threads : {2U, 3U, 7U}) {
            const Result more = Sampled(die).ask(property, method, 7, threads);
            EXPECT_EQ(one.estimate->samples, more.estimate->samples) << method;
            EXPECT_EQ(one.estimate->hits, more.estimate->hits) << method;
            EXPECT_EQ(one.estimate->mean_steps, more.estimate->mean_steps) << method;
            EXPECT_EQ(one.truth, more.truth) << method;
        }
        const Result other = Sampled(die).ask(property, method, 8, 1);
        EXPECT_TRUE(other.estimate->hits != one.estimate->hits ||
                    other.estimate->mean_steps != one.estimate->mean_steps)
            << "the seed changes nothing";
    }
    const Result one = Sampled(die).ask("R{\"flips\"}=? [ F s=7 ]", "ci", 3, 1);
    EXPECT_EQ(one.estimate->mean, Sampled(die).ask("R{\"flips\"}=? [ F s=7 ]", "ci", 3, 5).estimate->mean);
}

/// Of samples, width and confidence, two numbers determine the third, by the formulas of PRISM's manual.
TEST(PrismSimulation, ParametersOfMethods) {
    const auto ask = [](const char* method) { return *Sampled(die).ask("P=? [ F d=6 ]", method).estimate; };
    const Estimate usual = ask("ci");
    EXPECT_EQ(usual.samples, 1000U);
    EXPECT_EQ(usual.alpha, 0.01);
    // t(0.005, 999) = 2.5808 (the table has 2.581 for 1000), and the variance of the samples is n/(n-1) p (1-p).
    const double p = usual.mean;
    EXPECT_NEAR(*usual.width, 2.5808 * std::sqrt(p * (1 - p) / 999), 1e-5);
    EXPECT_NEAR(*ask("aci").width, 2.5758 * std::sqrt(p * (1 - p) / 999), 1e-5);
    const Estimate narrow = ask("ci,width=0.01,confidence=0.05");
    // N is the first number with N >= v t^2 / w^2: about 0.1389 * 1.9604^2 / 0.0001 = 5338.
    EXPECT_NEAR(static_cast<double>(narrow.samples), 5338, 600);
    EXPECT_LE(*narrow.width, 0.01);
    const Estimate given = ask("ci,samples=2000,width=0.02");
    EXPECT_EQ(given.samples, 2000U);
    EXPECT_EQ(*given.width, 0.02);
    // The normal tail beyond 0.02 / sqrt(0.1389 / 2000) = 2.4 is 0.0082, and alpha is twice that.
    EXPECT_NEAR(given.alpha, 0.0164, 0.006);
    EXPECT_EQ(ask("apmc,width=0.05,confidence=0.01").samples, 1060U);  // ln(200) / 0.005
    EXPECT_NEAR(*ask("apmc,samples=1060").width, 0.05, 1e-4);
    EXPECT_NEAR(ask("apmc,samples=1060,width=0.05").alpha, 0.01, 1e-4);
}

TEST(PrismSimulation, MethodsAsText) {
    const Method method = read_method("aci,samples=50,confidence=0.02,path=77");
    EXPECT_EQ(method.kind, Method::Kind::aci);
    EXPECT_EQ(method.samples, 50U);
    EXPECT_EQ(method.confidence, 0.02);
    EXPECT_EQ(method.path, 77U);
    for (const char* const wrong :
         {"", "cia", "ci,", "ci,samples", "ci,samples=0", "ci,samples=-1", "ci,samples=1.5", "ci,width=0",
          "ci,width=inf", "ci,width=nan", "ci,confidence=1", "ci,confidence=0", "ci,path=0", "ci,seed=1",
          "sprt,samples=10", "ci,samples=9,width=0.1,confidence=0.1", "ci samples=1"})
        EXPECT_THROW((void)read_method(wrong), BadMethod) << wrong;
}

TEST(PrismSimulation, BoundsAreDecidedOrLeftOpen) {
    const auto ask = [](const char* property, const char* method) { return Sampled(die).ask(property, method); };
    EXPECT_TRUE(ask("P>=0.1 [ F d=6 ]", "ci").truth);
    EXPECT_FALSE(ask("P>=0.3 [ F d=6 ]", "ci").truth);
    EXPECT_TRUE(ask("P<0.3 [ F d=6 ]", "apmc").truth);
    EXPECT_EQ(ask("P>=1/6 [ F d=6 ]", "ci").kind, Kind::unknown);
    EXPECT_THAT(ask("P>=1/6 [ F d=6 ]", "ci").reason, HasSubstr("more samples"));
    EXPECT_TRUE(ask("P>=0.1 [ F d=6 ]", "sprt,width=0.02").truth);
    EXPECT_FALSE(ask("P<0.1 [ F d=6 ]", "sprt,width=0.02").truth);
    EXPECT_TRUE(ask("P<=0.3 [ F d=6 ]", "sprt").truth);
    // One path shows that the event is possible, or that it is not certain. No number of paths shows that it is
    // impossible.
    EXPECT_TRUE(ask("P>0 [ F d=6 ]", "ci").truth);
    EXPECT_FALSE(ask("P<=0 [ F d=6 ]", "ci").truth);
    EXPECT_FALSE(ask("P>=1 [ F d=6 ]", "ci").truth);
    EXPECT_EQ(ask("P<=0 [ F d=6 & s=0 ]", "ci").kind, Kind::unknown);
    EXPECT_TRUE(ask("R{\"flips\"}<=5 [ F s=7 ]", "ci").truth);
    EXPECT_FALSE(ask("R{\"flips\"}>5 [ F s=7 ]", "ci").truth);
    EXPECT_EQ(ask("R{\"flips\"}>=11/3 [ F s=7 ]", "ci").kind, Kind::unknown);
}

/// If a path without choices returns to a state, an event that has not occurred by then never occurs.
TEST(PrismSimulation, LoopsAreNoticed) {
    const std::string model =
        "dtmc module M x:[0..9]; [] x=0 -> 0.5:(x'=1) + 0.5:(x'=5); [] x=1 -> (x'=2); [] x=2 -> (x'=3);\n"
        "[] x=3 -> (x'=1); [] x=5 -> true; endmodule rewards true : 1; endrewards\n";
    const auto ask = [&](const char* property) { return Sampled(model).ask(property, "ci,path=200"); };
    EXPECT_EQ(ask("P=? [ F x=9 ]").estimate->hits, 0U);
    EXPECT_EQ(ask("P=? [ F>=20 x=0 ]").estimate->hits, 0U);
    EXPECT_EQ(ask("P=? [ G x!=9 ]").estimate->hits, 1000U);
    EXPECT_NEAR(ask("P=? [ F>=50 x=3 ]").estimate->mean, 0.5, 0.1);
    EXPECT_LE(ask("P=? [ F x=9 ]").estimate->most_steps, 10U);
    EXPECT_TRUE(std::isinf(ask("R=? [ F x=5 ]").estimate->mean));
    EXPECT_FALSE(ask("R<=100 [ F x=5 ]").truth);
}

/// A path that is undecided at its limit is not a sample, because unknown is not "false".
TEST(PrismSimulation, AnOpenPathIsAnErrorAndNoAnswer) {
    const std::string walk =
        "dtmc module M x:[-1..9] init 0; [] x>=0 -> 0.5:(x'=min(9,x+1)) + 0.5:(x'=max(0,x-1)); endmodule\n"
        "rewards true : 1; endrewards";
    const Result open = Sampled(walk).ask("P=? [ F x=-1 ]", "ci,path=100");
    EXPECT_EQ(open.kind, Kind::unknown);
    EXPECT_THAT(open.reason, HasSubstr("path 1 is open after 100 steps"));
    EXPECT_EQ(Sampled(walk).ask("R=? [ C<=101 ]", "ci,path=100").kind, Kind::unknown);
    EXPECT_EQ(Sampled(walk).ask("R=? [ C<=100 ]", "ci,path=100").kind, Kind::number);
    EXPECT_EQ(Sampled(walk).ask("P>=0.5 [ F x=-1 ]", "sprt,path=100").kind, Kind::unknown);
}

TEST(PrismSimulation, WhatPathsDoNotAnswerIsRefusedByName) {
    const auto why = [](const char* property, const char* method = "ci") {
        return Sampled(pair).ask(property, method).reason;
    };
    EXPECT_THAT(why("P=? [ F P>0.5 [ F x=3 ] ]"), HasSubstr("samples do not answer nested queries"));
    EXPECT_THAT(why("P=? [ G F x=3 ]"), HasSubstr("path formulas inside"));
    EXPECT_THAT(why("P=? [ F x=3 ] + 1"), HasSubstr("samples answer only"));
    EXPECT_THAT(why("filter(min, P=? [ F x=3 ])"), HasSubstr("samples answer only"));
    EXPECT_THAT(why("S=? [ x=3 ]"), HasSubstr("samples answer only"));
    EXPECT_THAT(why("x=3"), HasSubstr("samples answer only"));
    EXPECT_THAT(why("E [ F x=3 ]"), HasSubstr("samples answer only"));
    EXPECT_THAT(why("R{\"r\"}=? [ C ]"), HasSubstr("R of F of states"));
    EXPECT_THAT(why("R{\"r\"}=? [ S ]"), HasSubstr("R of F of states"));
    EXPECT_THAT(why("R{\"r\"}=? [ F x=3 ]", "apmc"), HasSubstr("apmc"));
    EXPECT_THAT(why("P=? [ F x=3 ]", "sprt"), HasSubstr("sprt"));
    EXPECT_THAT(why("P>=0.99 [ F x=3 ]", "sprt"), HasSubstr("smaller width"));
    EXPECT_THAT(
        Sampled("dtmc module M x:[0..1]; [] true -> true; endmodule init true endinit").ask("P=? [ F x=1 ]").reason,
        HasSubstr("several"));
}

TEST(PrismSimulation, ErrorsOfStatesHaveTheirPlaceAndState) {
    const std::string model = "dtmc module M x:[0..2]; [] true -> (x'=x+1); endmodule";
    const std::string text = failure_text([&] { (void)Sampled(model).ask("P=? [ F x=5 ]"); });
    EXPECT_THAT(text, HasSubstr("PRISM-E03"));
    EXPECT_THAT(text, HasSubstr("x=2"));
    EXPECT_THAT(failure_text([] { (void)Sampled(die).ask("P=? [ F<=-1 s=7 ]"); }), HasSubstr("PRISM-E10"));
    EXPECT_THAT(failure_text([] { (void)Sampled(die).ask("P>=1.5 [ F s=7 ]"); }), HasSubstr("PRISM-E14"));
}

TEST(PrismSimulation, WarningsComeOnceWhateverTheThreads) {
    Sampled model("dtmc module M x:[0..1]; [] true -> 0.333333:(x'=1) + 0.666666:(x'=0); endmodule");
    (void)model.ask("P=? [ F<=9 x=1 ]", "ci", 1, 4);
    EXPECT_EQ(model.read.findings(), "PRISM-E12:1");
}

/// A state has too many combinations to enumerate, so none of them is listed.
TEST(PrismSimulation, ManyCombinationsAreNotListed) {
    std::string text = "dtmc\n";
    for (int i = 0; i < 20; ++i) {
        const std::string x = "x" + std::to_string(i);
        text +=
            "module M" + x + " " + x + ":[0..1]; [a] true -> (" + x + "'=0); [a] true -> (" + x + "'=1); endmodule\n";
    }
    const Result found = Sampled(text).ask("P=? [ X x0=1 & x19=0 ]", "ci,confidence=0.000001");
    EXPECT_LE(found.estimate->binomial->low, 0.25);
    EXPECT_GE(found.estimate->binomial->high, 0.25);
}

/// RoboTool's model of a high-voltage controller has more than 2.2 thousand million states, which no test explores.
/// PRISM's logs contain the mean lengths of 100 paths. This program's mean lengths must be within five standard
/// deviations of both means.
TEST(PrismSimulation, PathsOfAControllerAreAsLongAsThoseOfPrism) {
    const auto shared = tests::shared_folder();
    ROBOCHART_NEEDS(!shared.empty(), "../shared");
    const auto folder = shared / "suite/prism/robotool/hvc/prism-gen";
    const std::string text = tests::read_contents(folder / "P5.prism");
    const std::string properties = tests::read_contents(folder / "P5.props");
    const struct {
        const char* state;
        double mean, resolution;  // the logs give two digits
        int samples;
    } logs[] = {{"Ramping", 6.3, 0.05, 1000},
                {"Init", 27, 0.5, 500},
                {"Wait24Vpower", 95, 0.5, 300},
                {"ErrorMode", 240, 5, 100},
                {"ClosedLoop", 1800, 50, 100}};
    Read read;
    Sampled model(text);
    for (const auto& log : logs) {
        const std::string name = std::string("mod_sys_ctrl_ref0_stm_ref0_") + log.state;
        const std::string target = "F mod_sys_ctrl_ref0_stm_ref0_scpc_8=" + name;
        const std::string method = "ci,path=1000000,samples=" + std::to_string(log.samples);
        const Result found = model.ask("P>0 [ " + target + " ]", method, 5);
        EXPECT_TRUE(found.kind == Kind::truth && found.truth) << log.state << ": " << found.reason;
        EXPECT_EQ(found.estimate->hits, static_cast<std::uint64_t>(log.samples)) << log.state;
        std::cout << log.state << ": " << found.estimate->mean_steps << " steps (" << found.estimate->least_steps
                  << " to " << found.estimate->most_steps << "), PRISM " << log.mean << "\n";
        // The length of a path is a constant plus waiting times, whose standard deviation is at most their mean.
        const double deviation = log.mean * std::sqrt(1.0 / 100 + 1.0 / log.samples);
        EXPECT_NEAR(found.estimate->mean_steps, log.mean, 5 * deviation + log.resolution) << log.state;
    }
}

}  // namespace
}  // namespace robochart::prism
