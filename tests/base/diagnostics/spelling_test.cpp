// SPDX-License-Identifier: Apache-2.0
// Tests which known word a misspelt word means. It means none if no known word is similar enough.
#include "base/diagnostics/spelling.hpp"

#include <gtest/gtest.h>

namespace robochart::diagnostics {
namespace {

TEST(Spelling, NearestName) {
    EXPECT_EQ(nearest_spelling("recieve", {"receive", "recv"}), "receive");
    EXPECT_EQ(nearest_spelling("limt", {"limit", "other"}), "limit");
    EXPECT_EQ(nearest_spelling("speed", {"limit", "other"}), "");
    EXPECT_EQ(nearest_spelling("x", {"completely"}), "");
    EXPECT_EQ(nearest_spelling("ab", {"cd"}), "");
}

TEST(Spelling, VeryLongNamesGetNoSuggestion) {
    EXPECT_EQ(nearest_spelling(std::string(1'000'000, 'x'), {"limit"}), "");
    EXPECT_EQ(nearest_spelling("limt", {std::string(1'000'000, 'x'), "limit"}), "limit");
}

}  // namespace
}  // namespace robochart::diagnostics
