// SPDX-License-Identifier: Apache-2.0
// The known word that a misspelt word means, or none if no known word is similar enough.
#include "base/diagnostics/spelling.hpp"

#include <gtest/gtest.h>

namespace robochart::diagnostics {
namespace {

TEST(Spelling, NearestName) {
    EXPECT_EQ(nearest("recieve", {"receive", "recv"}), "receive");
    EXPECT_EQ(nearest("limt", {"limit", "other"}), "limit");
    EXPECT_EQ(nearest("speed", {"limit", "other"}), "");
    EXPECT_EQ(nearest("x", {"completely"}), "");
    EXPECT_EQ(nearest("ab", {"cd"}), "");
}

TEST(Spelling, VeryLongNamesGetNoSuggestion) {
    EXPECT_EQ(nearest(std::string(1'000'000, 'x'), {"limit"}), "");
    EXPECT_EQ(nearest("limt", {std::string(1'000'000, 'x'), "limit"}), "limit");
}

}  // namespace
}  // namespace robochart::diagnostics
