// SPDX-License-Identifier: Apache-2.0
// Tests the reasons why a model is too large, too short or undefined. They are given in terms of the model.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "semantics/instantiate/instantiate.hpp"
#include "semantics/instantiate/large_types.hpp"
#include "semantics/instantiate/sequence_limits.hpp"
#include "semantics/ir/open_constants.hpp"
#include "tests/semantics/lower/lowering_fixture.hpp"

namespace robochart::ir {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::unique_ptr<samples::Lowered> with_guard(const std::string& declarations, const std::string& guard) {
    return samples::lower_text(
        "import sequence_toolkit::*\n"
        "stm S { " +
        declarations + " initial j state A { } transition t0 { from j to A } transition t { from A to A condition " +
        guard + " } }");
}

std::string large(const std::string& declarations, const std::string& guard) {
    const auto lowered = with_guard(declarations, guard);
    return large_type(lowered->system, instantiate_system(lowered->system, {}, lowered->diagnostics), 5e6,
                      lowered->sources);
}

TEST(Causes, ALargeTypeIsNamedWithTheNumberAndTheOption) {
    EXPECT_THAT(large("event e : Seq(nat) var n : nat", "n < 3000"),
                AllOf(HasSubstr("type Seq(nat) has about 9e+06 values: nat has 3002, since the model has the number "
                                "3000 ("),
                      HasSubstr("--range nat=0..2 narrows it")));
    EXPECT_THAT(large("event e : real * real var n : nat", "n < 3000"),
                AllOf(HasSubstr("real has 3004"), HasSubstr("--range nat=0..2 --range int=-2..2 --range real=-2..2")));
    EXPECT_EQ(large("event e : Seq(boolean) var n : nat", "n < 3000"), "") << "not made of numbers";
    EXPECT_EQ(large("event e : nat var s : Seq(nat) var n : nat", "n < 3000"), "") << "nobody communicates a sequence";
}

std::vector<std::int64_t> needed(const std::string& guard) {
    const auto lowered = with_guard("var s : Seq(nat) var n : nat", guard);
    std::vector<std::int64_t> result;
    for (const SequenceLimit& limit :
         sequence_limits(lowered->system, instantiate_system(lowered->system, {}, lowered->diagnostics)))
        result.push_back(limit.needed);
    return result;
}

TEST(Causes, LengthsThatNoSequenceHasAreFound) {
    EXPECT_THAT(needed("size(extract([2, 4], s)) > 0"), ElementsAre(4));
    EXPECT_THAT(needed("s[3] > 0"), ElementsAre(3));
    EXPECT_THAT(needed("size(s) > 2"), ElementsAre(3));
    EXPECT_THAT(needed("size(s) <= 2"), ElementsAre(3)) << "true of all";
    EXPECT_THAT(needed("2 < size(s)"), ElementsAre(3));
    EXPECT_THAT(needed("size(s) == 3"), ElementsAre(3));
    EXPECT_THAT(needed("size(s) >= 2 /\\ size(s) < 2 /\\ size(extract([1, 2], s)) == 1 /\\ s[n] > 0"), IsEmpty());
}

TEST(Causes, OpenDivisorsAreNamed) {
    const auto divisors = [](const std::string& guard) {
        const auto lowered = with_guard("const speed : nat, half : nat const two : nat = 2 var n : nat", guard);
        return open_divisors(lowered->system, lowered->transition("S", "t").guard->span);
    };
    EXPECT_THAT(divisors("n > half / speed"), ElementsAre("speed"));
    EXPECT_THAT(divisors("n > half % (two * speed - half)"), ElementsAre("speed", "half"));
    EXPECT_THAT(divisors("n > speed / two"), IsEmpty());
}

}  // namespace
}  // namespace robochart::ir
