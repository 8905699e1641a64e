// SPDX-License-Identifier: Apache-2.0
// Tests that constants that are only durations do not extend a carrier.
#include <gtest/gtest.h>

#include "semantics/instantiate/instantiate.hpp"
#include "semantics/ir/literals.hpp"
#include "tests/semantics/lower/lowering_fixture.hpp"

namespace robochart::ir {
namespace {

/// Returns the greatest number of nat, for a machine with these actions and transitions.
std::int64_t greatest(const std::string& parts, const InstantiationOptions& options = {}) {
    const auto lowered = samples::lower_text(
        "stm S { event e : nat const c : nat = 30 const d : nat = 40 var x : nat clock T initial i " + parts +
        " transition t0 { from i to A } }");
    return instantiate_system(lowered->system, options, lowered->diagnostics).nat.back();
}

TEST(Durations, AreConstantsThatAreOnlyWaitedForOrComparedWithClocks) {
    EXPECT_EQ(greatest("state A { entry wait(c) } transition t { from A to A #T condition since(T) >= d }"), 2);
    EXPECT_EQ(greatest("state A { entry e?x <{c} } transition t { from A to A trigger e?x <{d} }"), 2);
}

TEST(Durations, AreNoneWhereTheyAreValuesToo) {
    EXPECT_EQ(greatest("state A { entry wait(c); x = c } transition t { from A to A condition since(T) >= d }"), 30);
    EXPECT_EQ(greatest("state A { entry wait(c) } transition t { from A to A trigger e?x condition x > d }"), 41)
        << "one beyond what x is compared with";
    EXPECT_EQ(greatest("state A { entry wait(c + d) }"), 40) << "computed with, so within the type";
    EXPECT_EQ(greatest("state A { entry wait(c) } transition t { from A to A condition since(T) >= c + 1 }"), 40)
        << "d is used nowhere: it counts as before";
}

TEST(Durations, AValueFromTheCommandLineIsOneToo) {
    InstantiationOptions options;
    options.constants["c"] = "70";
    const std::string waits = "state A { entry wait(c); wait(d) }";
    EXPECT_EQ(greatest(waits, options), 2);
    EXPECT_EQ(greatest("state A { entry wait(d); x = c }", options), 70);
}

}  // namespace
}  // namespace robochart::ir
