// SPDX-License-Identifier: Apache-2.0
// Tests guards that keep updates within their ranges in unreachable states. A command that cannot leave a range stays
// unchanged.
#include "prism/emit/ranges.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "prism/syntax/printer.hpp"
#include "tests/prism/emit/models.hpp"
#include "tests/prism/support.hpp"

namespace robochart::prism_emit {
namespace {

using prism::testing::Explored;
using prism::testing::Read;
using ::testing::HasSubstr;
using ::testing::Not;

std::string print_guarded(const std::string& text) {
    Read read;
    const prism::ModelFile file = prism::read_model(read.sources, read.add(text), read.diagnostics);
    EXPECT_TRUE(read.diagnostics.ok()) << read.report();
    return prism::print(in_ranges(file));
}

/// A counter with a limit below the upper end of its range.
const char* const counter =
    "dtmc const int limit = 2; module M at : [0..1]; n : [0..3];\n"
    "[] at=0 & n<limit -> (at'=1); [] at=1 -> (n'=n+1) & (at'=0); [] n=limit -> true; endmodule\n";

TEST(PrismRanges, UpdatesThatMayLeaveTheirRangeAreGuarded) {
    const std::string text = print_guarded(counter);
    EXPECT_THAT(text, HasSubstr("[] at = 1 & n + 1 <= 3 -> (n' = n + 1) & (at' = 0);"));
    EXPECT_THAT(text, HasSubstr("label \"out_of_range\" = at = 1 & !n + 1 <= 3;"));
    const Explored before(counter);
    Explored after(text);
    EXPECT_EQ(after.space->chain().states(), before.space->chain().states());
    EXPECT_EQ(after.space->transitions(), before.space->transitions());
    EXPECT_FALSE(after.ask("E [ F \"out_of_range\" ]").truth);
}

TEST(PrismRanges, WhatStaysInItsRangeHasNoGuard) {
    const std::string text = print_guarded(
        "dtmc const int k = 3; module M n : [0..3]; m : [-1..4]; b : bool;\n"
        "[] n=k -> (n'=k) & (m'=n+1) & (b'=!b); [] n<k -> (m'=n-1) & (n'=b ? 0 : k); endmodule\n");
    EXPECT_THAT(text, Not(HasSubstr("out_of_range")));
    EXPECT_THAT(text, Not(HasSubstr(">=")));
}

/// The constant may have any value, and a branch of probability 0 has no effect.
TEST(PrismRanges, OpenConstantsAndBranchesAreGuarded) {
    const std::string text = print_guarded(
        "dtmc const int k; const double p; module M n : [0..3];\n"
        "[] n=0 -> p : (n'=k) + 1-p : true; endmodule\n");
    EXPECT_THAT(text, HasSubstr("n = 0 & (p = 0 | k >= 0 & k <= 3) ->"));
}

/// The label is true where a guard suppresses a step of both modules, and false where N is not ready for the step.
TEST(PrismRanges, TheLabelAsksWhetherOthersTakePart) {
    const std::string text = print_guarded(
        "dtmc module M n : [0..1]; [a] true -> (n'=n+1); endmodule\n"
        "module N m : [0..1]; [a] m=0 -> (m'=1); [] m=1 -> true; endmodule\n");
    EXPECT_THAT(text, HasSubstr("label \"out_of_range\" = m = 0 & !n + 1 <= 1;"));
    EXPECT_FALSE(Explored(text).ask("E [ F \"out_of_range\" ]").truth);
}

const char* const ascending =
    "robotic platform R { }\n"
    "stm S { var n : nat = 0 const top : nat = 1 initial i state Up { } junction j state End { }\n"
    "transition t0 { from i to Up } transition t1 { from Up to j action n = n + 1 }\n"
    "transition t2 { from j to Up condition n < top } transition t3 { from j to End condition n >= top } }\n"
    "controller C { sref s = S }\nmodule M { rref r = R cref c = C }\n";

TEST(PrismRanges, FilesSayWhatWasLeftOut) {
    const auto model = testing::encode_model(ascending);
    ASSERT_TRUE(model->emission) << model->report();
    const std::string written = file_text(*model->emission);
    EXPECT_THAT(written, HasSubstr("// Steps that would leave the range of a variable are left out in states with"));
    EXPECT_THAT(written, HasSubstr("M_c_s_n + 1 <= 2"));
    const Explored found(written);
    EXPECT_EQ(found.space->chain().states(), testing::size_of(*model).states);
}

}  // namespace
}  // namespace robochart::prism_emit
