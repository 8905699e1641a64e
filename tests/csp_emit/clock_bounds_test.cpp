// SPDX-License-Identifier: Apache-2.0
// Tests the bounds at which clocks saturate. In these bounds, RoboTool uses 1 in place of a divisor of 0, so a guard
// that no run evaluates makes no claim fail. The guards themselves keep the model's divisor.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "checker/cspm/eval/evaluation_error.hpp"
#include "checker/cspm/syntax/reader.hpp"
#include "tests/csp_emit/fixture.hpp"

namespace robochart::csp_emit::clock_bounds_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

/// Returns a machine that never starts to turn, because constants without a value are 0.
std::string turning_machine(const std::string& bound) {
    return "stm S { event go clock C const speed : nat, half : nat initial i state Move { } state Turn { }\n"
           "transition t0 { from i to Move }\n"
           "transition t1 { from Move to Turn trigger go # C condition speed > 0 }\n"
           "transition t2 { from Turn to Move condition since ( C ) >= " +
           bound + " } }";
}

TEST(ClockBounds, DoNotDivideByZero) {
    const std::string claims =
        "timed assertion A : S::Turn is not reachable in S\n"
        "timed assertion B : S::Turn is reachable in S with constant speed of S set to 1\n";
    for (const char* const bound : {"half / speed", "half % speed", "half / (speed * 2)"}) {
        const auto model = testing::load_model(turning_machine(bound), claims);
        EXPECT_THAT(testing::decide_obligations(*model, Time::timed), ElementsAre("holds", "holds")) << bound;
    }
}

TEST(ClockBounds, LargestNumberIsItsOwnLimit) {
    const auto model = testing::load_model(turning_machine("9223372036854775807"));
    const std::string script = cspm::print(model->emit(Time::timed).script);
    EXPECT_THAT(script, HasSubstr("clock_step(c_C, 9223372036854775807)"));
    EXPECT_THAT(script, Not(HasSubstr("-9223372036854775807")));
}

TEST(ClockBounds, GuardsDoDivide) {
    std::string model = turning_machine("half / speed");
    model.erase(model.find("condition speed > 0"), std::string("condition speed > 0").size());
    const auto failing = testing::load_model(model, "timed assertion A : S is deadlock-free\n");
    EXPECT_THROW((void)testing::decide_obligations(*failing, Time::timed), cspm::EvaluationError);
}

}  // namespace
}  // namespace robochart::csp_emit::clock_bounds_test
