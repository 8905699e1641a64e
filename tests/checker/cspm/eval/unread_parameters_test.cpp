// SPDX-License-Identifier: Apache-2.0
// Tests which arguments are part of a state. Calls that differ only in arguments that are never read are one state.
// Calls that differ in an argument that is read are different states.
#include <gtest/gtest.h>

#include "checker/cspm/session.hpp"
#include "checker/cspm/syntax/build.hpp"
#include "checker/lts/graph.hpp"
#include "tests/checker/cspm/support.hpp"

namespace robochart::cspm::test {
namespace {

/// Returns the number of states that P reaches by events, in a script over one channel.
std::size_t states_of_p(const std::string& definitions) {
    const Reading reading("channel c : {0..3}\n" + definitions + "\n");
    EXPECT_TRUE(reading.ok()) << reading.report();
    Session session(reading.script);
    const auto system = session.system(build::name("P"));
    return lts::explore(*system, [](std::size_t) {}).graph.size() -
           1;  // without the initial state P, to which no event leads back
}

TEST(UnreadParametersTest, AreNoPartOfAState) {
    EXPECT_EQ(states_of_p("P = M(0, 0)\nM(x, y) = c?v -> M(v, y) [] c?v -> M(x, v)"), 1U);
    EXPECT_EQ(states_of_p("P = M(0, 0)\nM(x, _) = c?v -> M(v, x)"), 1U) << "x goes where nothing looks";
    EXPECT_EQ(states_of_p("P = M(0, 0)\nM(x, y) = c!3 -> N(y, x)\nN(x, y) = c!2 -> M(y, x)"), 2U);
    EXPECT_EQ(states_of_p("P = let M(x, y) = c?v -> M(y, v) within M(1, 2)"), 1U) << "members of a let alike";
    EXPECT_EQ(states_of_p("P = c?x -> c?y -> M(x, y)\nM(x, y) = c!0 -> M(y, x)"), 5U)
        << "before the call x is still there: 4, then 1";
}

TEST(UnreadParametersTest, AreReadWhereTheirValueMatters) {
    const std::string four = "P = M(0)\n";
    EXPECT_EQ(states_of_p(four + "M(x) = c!x -> M((x + 1) % 4)"), 4U);
    EXPECT_EQ(states_of_p(four + "M(x) = c?v:{0, x} -> M(v) [] c?v -> M(v)"), 4U);
    EXPECT_EQ(states_of_p(four + "M(x) = (if x == 0 then c!1 -> STOP else STOP) [] c?v -> M(v)"), 5U);
    EXPECT_EQ(states_of_p(four + "M(x) = let y = x within c!y -> M((y + 1) % 4)"), 4U);
    EXPECT_EQ(states_of_p(four + "M(x) = let f(z) = x + z within c!f(0) -> M((x + 1) % 4)"), 4U);
    EXPECT_EQ(states_of_p(four + "M(x) = c!(\\ z @ z + x)(0) -> c?v -> M(v)"), 5U) << "4, and c?v";
    EXPECT_EQ(states_of_p(four + "M(0) = c?v -> M(v)\nM(x) = c!0 -> M(0)"), 4U) << "0, and three unlike it by pattern";
    EXPECT_EQ(states_of_p(four + "M(x) = ([] y : {x} @ c!y -> M((y + 1) % 4))"), 4U);
}

}  // namespace
}  // namespace robochart::cspm::test
