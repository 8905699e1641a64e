// Counterexamples in the words of the model, for each form of claim: the path, the deadline that was missed, the loop.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/app/command.hpp"

namespace robochart::app::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

const char* const machines = R"(
interface O { go() }
stm Late { event a event b initial i state A { } state B { }
  transition t0 { from i to A }
  transition t1 { from A to B trigger a <{ 2 } }
  transition t2 { from B to B trigger b } }
stm Sends { event a event b initial i state A { } transition t0 { from i to A }
  transition t1 { from A to A trigger a action b <{ 1 } } }
stm Calls { requires O event a initial i state A { } transition t0 { from i to A }
  transition t1 { from A to A trigger a action go() } }
stm Spins { event a initial i state A { } state B { } state C { } transition t0 { from i to A }
  transition t1 { from A to B trigger a }
  transition t2 { from B to C }
  transition t3 { from C to B } }
stm Stops { event a initial i state A { } state B { } transition t0 { from i to A }
  transition t1 { from A to B trigger a } }
stm Ends { event a initial i state A { } final f transition t0 { from i to A }
  transition t1 { from A to f trigger a } }
stm Runs { event a initial i state A { } transition t0 { from i to A } transition t1 { from A to A trigger a } }
)";

/// What the report says of this claim.
std::string told(const std::string& claim) {
    const TemporaryFile model("told.rct", machines);
    const std::string folder = std::filesystem::path(model.path()).parent_path().string();
    std::ofstream(folder + "/told.assertions") << claim << "\n";
    const Ran ran = run({"check", folder});
    EXPECT_EQ(ran.exit, 1) << ran.out << ran.err;
    return ran.out;
}

TEST(Told, ATimelockNamesTheDeadlineThatWasMissed) {
    EXPECT_THAT(
        told("timed assertion A : Late is timelock-free"),
        AllOf(HasSubstr("2 time units pass"), HasSubstr("why time cannot pass: the deadline of Late::t1 has run out ("),
              HasSubstr("told.rct:5)")));
    EXPECT_THAT(told("timed assertion A : Sends is timelock-free"),
                AllOf(HasSubstr("at b (deadline left = 0)"), HasSubstr("the deadline of Sends::t1 has run out ("),
                      HasSubstr("told.rct:8)")));
    EXPECT_THAT(told("timed assertion A : Calls is timelock-free"),
                HasSubstr("time cannot pass: call go waits for the environment, which may refuse it ("));
    EXPECT_THAT(told("timed assertion A : Ends is timelock-free"), HasSubstr("time cannot pass: it has terminated"));
}

TEST(Told, ADivergenceShowsItsLoop) {
    EXPECT_THAT(told("untimed assertion A : Spins is divergence-free"),
                AllOf(HasSubstr("then for ever:"), HasSubstr("t2: B -> C"), HasSubstr("t3: C -> B"),
                      HasSubstr("go on internally for ever")));
}

TEST(Told, ADeadlockInTimeIsNoDivergence) {
    EXPECT_THAT(told("timed assertion A : Stops is deadlock-free"),
                AllOf(HasSubstr("now at t=0: in B"), HasSubstr("why nothing is possible any more but that time passes"),
                      Not(HasSubstr("internally"))));
}

TEST(Told, ReachabilityShowsThePath) {
    EXPECT_THAT(told("untimed assertion A : Ends::f is not reachable in Ends"),
                AllOf(HasSubstr("t0: i -> A"), HasSubstr("input a"), HasSubstr("why the state has been reached")));
    EXPECT_THAT(told("untimed assertion A : Late::B is reachable in Late\nassertion B : Runs does not refine Runs"),
                HasSubstr("it refines the other"));
}

TEST(Told, TerminationIsSaid) {
    EXPECT_THAT(told("untimed assertion A : Ends does not terminate"), HasSubstr("why it has terminated"));
    EXPECT_THAT(told("timed assertion A : Runs terminates"),
                HasSubstr("no run terminates, and none ends in a deadlock"));
}

TEST(Told, ClaimsThatNothingBreaksSayWhatIsSo) {
    EXPECT_THAT(told("untimed assertion A : Runs is not deadlock-free"), HasSubstr("it is deadlock-free"));
    EXPECT_THAT(told("untimed assertion A : Runs is not deterministic"), HasSubstr("it is deterministic"));
    EXPECT_THAT(told("untimed assertion A : Runs is not divergence-free"), HasSubstr("it is divergence-free"));
    EXPECT_THAT(told("untimed assertion A : Runs is not equal to Runs"),
                HasSubstr("each of the two refines the other"));
}

TEST(Told, TickTockNamesWhatWasRefused) {
    EXPECT_THAT(told("timed assertion A : Stops refines Runs in the tick-tock model"),
                AllOf(HasSubstr("refusal of input a"), HasSubstr("why refusal of input a is not allowed here")));
}

}  // namespace
}  // namespace robochart::app::testing
