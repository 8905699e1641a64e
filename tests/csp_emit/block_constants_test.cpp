// SPDX-License-Identifier: Apache-2.0
// Tests the names of constants. A constant has one name for its machine, and one name for each place in which a
// controller runs the machine. In RoboTool's scripts a claim about a controller or a module starts with `let
// const_C_ref_c = const_S_c within`.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <algorithm>

#include "tests/csp_emit/fixture.hpp"

namespace robochart::csp_emit::block_constants_test {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

/// A gate that opens if its limit is above 0. A controller instantiates it twice.
const char* const gates = R"(
stm Gate {
  const limit : nat
  event go
  initial i
  state Shut { }
  state Open { }
  transition t { from i to Shut }
  transition u { from Shut to Open trigger go condition limit > 0 }
}
controller C {
  event go
  sref left = Gate
  sref right = Gate
  connection C on go to left on go
}
robotic platform P { event go }
module M { rref p = P cref c = C connection p on go to c on go ( _async ) }
)";

std::unique_ptr<testing::Model> with_block(const std::string& definitions, const std::string& claims) {
    return testing::load_model(gates, "csp Instantiations csp-begin\n" + definitions + "\ncsp-end\n" + claims);
}

const char* const opens =
    "untimed assertion A : Gate::Open is reachable in Gate\n"
    "untimed assertion B : C::left::Open is reachable in C\n"
    "untimed assertion D : M::c::left::Open is reachable in M\n";

TEST(BlockConstants, TheMachinesOwnNameDecidesInAllClaims) {
    const auto model = with_block("const_Gate_limit = 1\nconst_C_left_limit = 0", opens);
    EXPECT_THAT(testing::decide_obligations(*model, Time::untimed), ElementsAre("holds", "holds", "holds"));
    EXPECT_THAT(model->codes(), Contains("RC-C17"));
    EXPECT_THAT(model->messages(), HasSubstr("const_C_left_limit = 0 does not apply to claims about the controller"));
    EXPECT_THAT(model->messages(), HasSubstr("const_Gate_limit = 1"));
    const auto shut = with_block("const_Gate_limit = 0\nconst_C_left_limit = 1", opens);
    EXPECT_THAT(testing::decide_obligations(*shut, Time::untimed), ElementsAre("fails", "fails", "fails"));
}

TEST(BlockConstants, WithoutItThePartsNameCounts) {
    const auto model = with_block("const_C_left_limit = 1", opens);
    EXPECT_THAT(testing::decide_obligations(*model, Time::untimed), ElementsAre("fails", "holds", "holds"));
    EXPECT_THAT(model->codes(), Not(Contains("RC-C17")));
}

TEST(BlockConstants, ClaimsSetTheMachinesConstantWhicheverNameABlockDefines) {
    const char* const claim =
        "untimed assertion B : C::left::Open is reachable in C with constant limit of Gate set to 1\n";
    for (const char* const name : {"const_Gate_limit = 0", "const_C_left_limit = 0"}) {
        const auto model = with_block(name, claim);
        EXPECT_THAT(testing::decide_obligations(*model, Time::untimed), ElementsAre("holds")) << name;
        EXPECT_THAT(model->codes(), Not(Contains("RC-C08"))) << name;
    }
}

TEST(BlockConstants, TwoPlacesCannotDiffer) {
    const auto model = with_block("const_C_left_limit = 1\nconst_C_right_limit = 0", opens);
    (void)model->emit(Time::untimed);
    EXPECT_THAT(model->codes(), Contains("RC-C18"));
    EXPECT_THAT(model->messages(),
                HasSubstr("const_C_right_limit = 0 and const_C_left_limit = 1 are two values of one constant"));
    (void)model->emit(Time::timed);
    const auto codes = model->codes();
    EXPECT_EQ(std::ranges::count(codes, "RC-C18"), 1) << "the other script has the same fault";
}

TEST(BlockConstants, EqualValuesAreFine) {
    for (const char* const same : {"const_C_left_limit = 2\nconst_C_right_limit = 1 + 1",
                                   "two = 2\nconst_C_left_limit = two\nconst_C_right_limit = (2)",
                                   "const_Gate_limit = 3\nconst_C_left_limit = const_Gate_limit"}) {
        const auto model = with_block(same, opens);
        (void)model->emit(Time::untimed);
        EXPECT_THAT(model->codes(), Not(::testing::AnyOf(Contains("RC-C17"), Contains("RC-C18")))) << same;
    }
}

}  // namespace
}  // namespace robochart::csp_emit::block_constants_test
