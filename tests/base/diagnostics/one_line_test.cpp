// SPDX-License-Identifier: Apache-2.0
// Tests that runs of blanks become one blank, and that leading and trailing blanks are removed.
#include "base/diagnostics/text.hpp"

#include <gtest/gtest.h>

namespace robochart::diagnostics {
namespace {

TEST(OneLine, FoldsBlanksAndCutsThemAtTheEnds) {
    EXPECT_EQ(on_one_line("x  in\r\n\t y"), "x in y");
    EXPECT_EQ(on_one_line("\n x \n"), "x");
    EXPECT_EQ(on_one_line(" \t\n"), "");
    EXPECT_EQ(on_one_line(""), "");
}

}  // namespace
}  // namespace robochart::diagnostics
