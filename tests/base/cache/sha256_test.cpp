// SPDX-License-Identifier: Apache-2.0
// Compares digests with those of FIPS 180-4's examples, as NIST publishes them.
#include <gtest/gtest.h>

#include "base/cache/sha256.hpp"

namespace robochart::diagnostics {
namespace {

TEST(Sha256, IsTheDigestOfTheStandard) {
    EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(Sha256, DoesNotDependOnThePieces) {
    Sha256 hash;
    hash.add("a");
    hash.add("");
    hash.add("bc");
    EXPECT_EQ(hash.finish(), sha256("abc"));
}

}  // namespace
}  // namespace robochart::diagnostics
