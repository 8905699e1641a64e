// SPDX-License-Identifier: Apache-2.0
// Tests counterexamples and strategies of small models. The expected results are computed by hand.
#include "prism/session/counterexample.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "prism/session/export.hpp"
#include "tests/prism/support.hpp"

namespace robochart::prism {
namespace {

using testing::Explored;
using ::testing::HasSubstr;
using testing::Read;

std::optional<Counterexample> why(Explored& model, const std::string& property) {
    const PropertyFile file =
        read_properties(model.read.sources, model.read.add(property, "model.props"), model.read.diagnostics);
    const CheckedProperties properties = check_properties(*model.checked, file, model.read.diagnostics);
    if (!model.read.diagnostics.ok()) throw std::runtime_error(model.read.report());
    const Session session(*model.space, properties, {});
    EXPECT_FALSE(session.check(0, {}).truth) << property;
    return session.counterexample(0, {});
}

/// Returns the states of a path, and the commands of its steps.
std::string path_text(const ProbablePath& path, const diagnostics::SourceManager& sources) {
    std::string result = path.from;
    for (const ProbablePath::Step& step : path.steps) result += " -" + text_of(step.by, sources) + "-> " + step.changes;
    return result;
}

constexpr const char* robot =
    "dtmc\n"
    "module Robot s:[0..3];\n"
    "[go] s=0 -> 0.5:(s'=1) + 0.25:(s'=2) + 0.25:(s'=0);\n"
    "[] s=1 -> 0.5:(s'=2) + 0.5:(s'=3);\n"
    "[] s>=2 -> true;\n"
    "endmodule\n"
    "module Human h:bool;\n"
    "[go] true -> (h'=true);\n"
    "endmodule\n";

TEST(PrismCounterexample, TheMostProbablePathsThatExceedTheBound) {
    Explored model(robot);
    // The paths 0 2 and 0 1 2 have probability 0.25 each. If 0 is repeated once, each has a quarter of that, 0.0625.
    const std::optional<Counterexample> found = why(model, "P<=0.55 [ F s=2 ]");
    ASSERT_TRUE(found);
    EXPECT_TRUE(found->holds);
    EXPECT_TRUE(found->enough);
    EXPECT_FALSE(found->never);
    ASSERT_EQ(found->count, 3U);
    EXPECT_EQ(found->total, (Enclosure{0.5625, 0.5625}));
    EXPECT_EQ(found->paths[0].probability, (Enclosure{0.25, 0.25}));
    EXPECT_EQ(found->paths[2].probability, (Enclosure{0.0625, 0.0625}));
    const std::string first = path_text(found->paths[0], model.read.sources);
    const std::string second = path_text(found->paths[1], model.read.sources);
    const std::string short_one = "s=0, h=false -[go] Robot (line 3), Human (line 8)-> s=2, h=true";
    const std::string long_one =
        "s=0, h=false -[go] Robot (line 3), Human (line 8)-> s=1, h=true -Robot (line 4)-> s=2";
    EXPECT_TRUE((first == short_one && second == long_one) || (first == long_one && second == short_one))
        << first << "\n"
        << second;
}

TEST(PrismCounterexample, BoundsOnSteps) {
    Explored model(robot);
    const std::optional<Counterexample> found = why(model, "P<0.25 [ F<=1 s=2 ]");
    ASSERT_TRUE(found);
    EXPECT_EQ(found->count, 1U);
    EXPECT_EQ(found->total, (Enclosure{0.25, 0.25}));
    EXPECT_FALSE(found->strict);
    EXPECT_FALSE(why(model, "P<=0.1 [ F[1,2] s=2 ]"));
}

/// The probability to leave the safe states is greater than allowed. So paths to the bad state violate G.
TEST(PrismCounterexample, LowerBoundsOfSafety) {
    Explored model(robot);
    const std::optional<Counterexample> found = why(model, "P>=0.9 [ G s!=3 ]");
    ASSERT_TRUE(found);
    EXPECT_FALSE(found->holds);
    EXPECT_FALSE(found->never);
    EXPECT_TRUE(found->enough);
    EXPECT_EQ(found->count, 1U);  // 0 1 3 has 1/4, which is more than 0.1
    EXPECT_EQ(found->bound.text(), "0.1");
}

/// The probability is too small, so the counterexample consists of paths to states from which the goal is unreachable.
TEST(PrismCounterexample, LowerBoundsOfReachability) {
    Explored model(robot);
    const std::optional<Counterexample> found = why(model, "P>=0.8 [ F s=2 ]");
    ASSERT_TRUE(found);
    EXPECT_TRUE(found->never);
    EXPECT_FALSE(found->holds);
    EXPECT_TRUE(found->enough);
    ASSERT_EQ(found->count, 1U);
    EXPECT_EQ(found->paths[0].steps.back().state, "s=3, h=true");
    EXPECT_FALSE(why(model, "P>=0.8 [ F<=4 s=2 ]"));
}

/// Finite sets of paths approach the probability 2/3, but none reaches it.
TEST(PrismCounterexample, WhereNoFiniteSetIsEnoughItSaysSo) {
    Explored model(robot);
    const std::optional<Counterexample> found = why(model, "P<2/3 [ F s=2 ]");
    ASSERT_TRUE(found);
    EXPECT_FALSE(found->enough);
    EXPECT_LE(found->total.low, 2.0 / 3);
    EXPECT_GT(found->total.low, 0.66);
    EXPECT_LE(found->paths.size(), Counterexample::most_kept);
}

constexpr const char* choice =
    "mdp\n"
    "module M s:[0..3];\n"
    "[left] s=0 -> 0.9:(s'=1) + 0.1:(s'=2);\n"
    "[right] s=0 -> 0.2:(s'=1) + 0.8:(s'=3);\n"
    "[] s>0 -> true;\n"
    "endmodule\n"
    "rewards [left] true : 5; [right] true : 2; endrewards\n";

TEST(PrismCounterexample, OfAnMdpTheyAreThoseOfOneScheduler) {
    Explored model(choice);
    const std::optional<Counterexample> upper = why(model, "P<=0.5 [ F s=1 ]");
    ASSERT_TRUE(upper);
    EXPECT_TRUE(upper->scheduled);
    ASSERT_EQ(upper->count, 1U);
    EXPECT_EQ(upper->paths[0].steps[0].by[0].action, "left");
    const std::optional<Counterexample> lower = why(model, "P>=0.5 [ F s=1 ]");
    ASSERT_TRUE(lower);
    ASSERT_EQ(lower->count, 1U);
    EXPECT_EQ(lower->paths[0].steps[0].by[0].action, "right");
    EXPECT_FALSE(why(model, "P<=0.5 [ F<=3 s=1 ]"));
}

std::string strategy(const char* text, const std::string& property) {
    Explored model(text);
    const PropertyFile file =
        read_properties(model.read.sources, model.read.add(property, "model.props"), model.read.diagnostics);
    const CheckedProperties properties = check_properties(*model.checked, file, model.read.diagnostics);
    const Session session(*model.space, properties, {});
    std::string result;
    export_strategy(*model.space, session.best_choices(0, {}), model.read.sources,
                    [&](std::string_view piece) { result += piece; });
    return result;
}

TEST(PrismStrategy, IsInTermsOfTheModel) {
    EXPECT_EQ(strategy(choice, "Pmax=? [ F s=1 ]"), "s=0: [left] M (line 3)\n");
    EXPECT_EQ(strategy(choice, "Pmin=? [ F s=1 ]"), "s=0: [right] M (line 4)\n");
    EXPECT_EQ(strategy(choice, "Pmax=? [ G s!=1 ]"), "s=0: [right] M (line 4)\n");
    EXPECT_EQ(strategy(choice, "P>=0.5 [ F s=1 ]"), "s=0: [right] M (line 4)\n");
    EXPECT_EQ(strategy(choice, "Rmax=? [ F s>0 ]"), "s=0: [left] M (line 3)\n");
    EXPECT_EQ(strategy(choice, "Rmin=? [ C ]"), "s=0: [right] M (line 4)\n");
    EXPECT_THROW((void)strategy(choice, "Pmax=? [ F<=3 s=1 ]"), Undecided);
    EXPECT_THROW((void)strategy(choice, "Pmax=? [ G F s=1 ]"), Undecided);
    EXPECT_THROW((void)strategy(choice, "1 + Pmax=? [ F s=1 ]"), Undecided);
}

TEST(PrismCounterexample, AsAGraph) {
    Explored model(robot);
    std::string graph;
    export_counterexample(*why(model, "P<=0.4 [ F s=2 ]"), model.read.sources,
                          [&](std::string_view piece) { graph += piece; });
    EXPECT_THAT(graph, HasSubstr("digraph counterexample {"));
    EXPECT_THAT(graph, HasSubstr("[go] Robot (line 3), Human (line 8)"));
    EXPECT_THAT(graph, HasSubstr("s=2, h=true"));
    EXPECT_THAT(graph, HasSubstr("peripheries=2"));
    EXPECT_EQ(graph.find("s=3"), std::string::npos);
}

}  // namespace
}  // namespace robochart::prism
