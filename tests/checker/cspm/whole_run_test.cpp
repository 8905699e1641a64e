// SPDX-License-Identifier: Apache-2.0
// Tests the descriptions of processes in which placeholders replace omitted values.
#include "checker/cspm/whole_run.hpp"

#include <gtest/gtest.h>

namespace robochart::cspm {
namespace {

TEST(WholeRun, PlacesOfValues) {
    for (const char* with : {"P(_)", "P(_,1)", "P(1,_)", "a.b -> Q(2,_,3) ||| R"})
        EXPECT_TRUE(leaves_values_out(with)) << with;
    for (const char* without : {"P", "P_(1)", "P(_x)", "_", "P(a_,b)", ""})
        EXPECT_FALSE(leaves_values_out(without)) << without;
}

TEST(WholeRun, DescriptionsFitIfAllButThePlacesIsEqual) {
    EXPECT_TRUE(matches_description("P(_,1) ||| Q(_)", "P((2, 3),1) ||| Q(<>)"));
    EXPECT_TRUE(matches_description("P(1)", "P(1)"));
    EXPECT_TRUE(matches_description("P(_)", "P(_)"));
    EXPECT_FALSE(matches_description("P(_,1)", "P(2,3)"));
    EXPECT_FALSE(matches_description("P(_)", "Q(1)"));
    EXPECT_FALSE(matches_description("P(1)", "P(1) ||| Q"));
    EXPECT_FALSE(matches_description("P(_)", "P(1) ||| Q"));
    EXPECT_FALSE(matches_description("P(_)", "P("));
}

}  // namespace
}  // namespace robochart::cspm
