// SPDX-License-Identifier: Apache-2.0
// Tests the possible successors of a machine's states after some time. The expected results are computed by hand.
#include "prism/assertions/process/following.hpp"

#include <gtest/gtest.h>
#include <algorithm>

#include "prism/assertions/experiments/encoding.hpp"
#include "semantics/instantiate/instantiate.hpp"
#include "tests/prism/assertions/models.hpp"

namespace robochart::probability {
namespace {

/// The machine stays in A for two time units, then goes to B immediately, and from B to C on request.
const char* const machine =
    "stm S { event go initial i state A { entry wait(2) } state B { } state C { } transition t0 { from i to A } "
    "transition t1 { from A to B } transition t2 { from B to C trigger go } }";

Following found(const std::string& model, const std::vector<std::string>& states, std::uint64_t units) {
    const auto loaded = testing::load({{"m.rct", model}});
    diagnostics::Diagnostics none;
    const ir::ComponentRef subject = testing::whole_component(loaded->system);
    const auto process = explore_process(loaded->system, subject, ir::instantiate_system(loaded->system, {}, none), {},
                                         loaded->sources, {});
    return find_following(*process, loaded->system, subject, states, units, diagnostics::unlimited);
}

bool may(const Following& following, std::uint32_t from, std::uint32_t to) {
    const auto place = [&](std::uint32_t bits) {
        return std::ranges::find(following.classes, bits) - following.classes.begin();
    };
    return following.after.at(static_cast<std::size_t>(place(from))).at(static_cast<std::size_t>(place(to)));
}

constexpr std::uint32_t none = 0;
constexpr std::uint32_t a = 1;
constexpr std::uint32_t b = 2;
constexpr std::uint32_t c = 4;

/// The first two time units pass in A. The third passes in B, or in C after an immediate request.
TEST(Following, OneTimeUnit) {
    const Following one = found(machine, {"A", "B", "C"}, 1);
    EXPECT_EQ(one.classes, (std::vector<std::uint32_t>{none, a, b, c}));
    EXPECT_EQ(one.first, (std::vector<bool>{true, false, false, false}));
    EXPECT_TRUE(may(one, none, a));
    EXPECT_FALSE(may(one, none, b));
    for (const std::uint32_t action : {a, b, c}) EXPECT_TRUE(may(one, a, action)) << action;
    EXPECT_TRUE(may(one, b, b));
    EXPECT_TRUE(may(one, b, c));
    EXPECT_TRUE(may(one, c, c));
    for (const auto& [from, to] : {std::pair{b, a}, std::pair{c, a}, std::pair{c, b}, std::pair{c, none}})
        EXPECT_FALSE(may(one, from, to)) << from << " " << to;
}

/// Three time units later, the machine is not in A. Two time units after the start, it still is.
TEST(Following, SeveralTimeUnits) {
    const Following two = found(machine, {"A", "B", "C"}, 2);
    EXPECT_TRUE(may(two, none, a));
    EXPECT_FALSE(may(two, none, b));
    EXPECT_FALSE(may(two, a, a)) << "at least one of A's two time units has passed";
    const Following three = found(machine, {"A", "B", "C"}, 3);
    EXPECT_FALSE(may(three, none, a));
    EXPECT_TRUE(may(three, none, b));
    EXPECT_TRUE(may(three, none, c));
    EXPECT_FALSE(may(three, a, a));
    EXPECT_TRUE(may(three, a, c));
    // The result after a thousand time units equals the result after three.
    EXPECT_FALSE(may(found(machine, {"A", "B", "C"}, 1000), b, a));
    EXPECT_TRUE(may(found(machine, {"A", "B", "C"}, 1000), b, b));
}

/// States that the query does not name form one class.
TEST(Following, OfSomeStates) {
    const Following only = found(machine, {"C"}, 1);
    EXPECT_EQ(only.classes, (std::vector<std::uint32_t>{none, 1}));
    EXPECT_TRUE(may(only, none, 1));
    EXPECT_FALSE(may(only, 1, none));
    EXPECT_THROW((void)found(machine, {"Nowhere"}, 1), Wrong);
}

/// A robot in a nested state is in both states.
TEST(Following, StatesInside) {
    const std::string nested =
        "stm S { initial i state Outer { initial j state In { entry wait(1) } state Out { } transition u0 { from j to "
        "In } "
        "transition u1 { from In to Out } } transition t0 { from i to Outer } }";
    const Following found_in = found(nested, {"Outer", "Outer::In"}, 1);
    EXPECT_EQ(found_in.classes, (std::vector<std::uint32_t>{none, 1, 3}));
    EXPECT_TRUE(may(found_in, 3, 1));
    EXPECT_FALSE(may(found_in, 1, 3));
    EXPECT_FALSE(may(found_in, 1, none));
}

std::string why_not(const std::string& model, const std::vector<std::string>& states) {
    try {
        (void)found(model, states, 1);
    } catch (const Wrong& wrong) {
        return wrong.what();
    }
    return "";
}

/// The code may continue after the process has terminated.
TEST(Following, NothingOfWhatMayTerminate) {
    const std::string ends =
        "stm S { event go initial i state A { } final f transition t0 { from i to A } "
        "transition t1 { from A to f trigger go } }";
    EXPECT_NE(why_not(ends, {"A"}), "");
}

/// There is no answer if time can stop. Here, an action of two time units has a deadline of one.
TEST(Following, NothingWhereTimeStops) {
    const auto model = [](const std::string& entry) {
        return "stm S { event go initial i state A { } state B { entry " + entry + " } " +
               "transition t0 { from i to A } transition t1 { from A to B trigger go } }";
    };
    EXPECT_EQ(why_not(model("wait(1)"), {"A"}), "");
    EXPECT_NE(why_not(model("wait(2) <{ 1 }"), {"A"}), "");
}

/// While time passes in the action or exit action of a transition, the code shows the source state, although the
/// process has already left it.
TEST(Following, NothingWhereTimePassesInATransition) {
    const auto model = [](const std::string& exit, const std::string& action) {
        return "stm S { event go initial i state A { " + exit + " } state B { } transition t0 { from i to A } " +
               "transition t1 { from A to B trigger go " + action + " } }";
    };
    EXPECT_EQ(why_not(model("", ""), {"A"}), "");
    EXPECT_NE(why_not(model("", "action wait(1)"), {"A"}), "");
    EXPECT_NE(why_not(model("exit wait(1)", ""), {"A"}), "");
}

/// By default, no received value is greater than 2.
TEST(Following, NothingWhereValuesAreLeftOut) {
    const auto model = [](const std::string& type, const std::string& guard) {
        return "stm S { event far : " + type + " var d : " + type + " initial i state A { } state B { } " +
               "transition t0 { from i to A } transition t1 { from A to A trigger far?d } " +
               "transition t2 { from A to B condition " + guard + " } }";
    };
    EXPECT_NE(why_not(model("real", "d > 50"), {"A"}), "");
    EXPECT_NE(why_not(model("nat", "d > 50"), {"A"}), "");
    EXPECT_EQ(why_not(model("boolean", "not d"), {"A"}), "");
}

}  // namespace
}  // namespace robochart::probability
