// SPDX-License-Identifier: Apache-2.0
// Tests that fingerprints agree with equality. Different spellings of the same tree have equal fingerprints, and every
// part of the tree affects the fingerprint.
#include "checker/cspm/syntax/fingerprint.hpp"

#include <gtest/gtest.h>

#include <set>

#include "tests/checker/cspm/support.hpp"

namespace robochart::cspm::test {
namespace {

std::uint64_t hash_of(const std::string& declaration) {
    Reading reading("module M\nexports\n" + declaration + "\nendmodule\n");
    EXPECT_TRUE(reading.ok()) << declaration << "\n" << reading.report();
    return Fingerprints().of_exports(reading.script.decls.at(0)).hash;
}

// Like equality (syntax.cpp), fingerprints ignore parentheses and comments.
TEST(Fingerprints, OfEqualTreesAreEqual) {
    EXPECT_EQ(hash_of("P(x) = c!x -> (STOP)"), hash_of("-- said\nP(x) =\n    c!x -> STOP"));
    EXPECT_EQ(hash_of("x = 1 + (2 * 3)"), hash_of("x = 1 + 2 * 3"));
}

TEST(Fingerprints, TellTreesApart) {
    const std::vector<std::string> different{
        "x = 1",
        "y = 1",
        "x = 2",
        "x(z) = 1",
        "x(_) = 1",
        "x = (1,2)",
        "x = <1,2>",
        "x = {1,2}",
        "x = {1..2}",
        "x = {z | z <- {1}}",
        "x = {z | z <- {1}, z > 0}",
        "x = \"1\"",
        "channel x",
        "channel x : {1}",
        "datatype x = y",
        "datatype x = y.{1}",
        "x = c?y -> STOP",
        "x = c?y:{1} -> STOP",
        "x = c!y -> STOP",
        "x = c$y -> STOP",
        "x = P [[ a <- b ]]",
        "x = P [[ b <- a ]]",
        "x = let y = 1 within y",
        "x = let y = 2 within y",
        "x = \\ y @ y",
        "x = \\ z @ y",
        "module N\nexports\nx = 1\nendmodule",
        "module N\nexports\nx = 2\nendmodule",
        "module N(u)\nexports\nx = 2\nendmodule",
        "module N\nx = 1\nexports\ny = 1\nendmodule",
        "instance N = L(1)",
        "instance N = K(1)",
    };
    std::set<std::uint64_t> hashes;
    for (const std::string& script : different) EXPECT_TRUE(hashes.insert(hash_of(script)).second) << script;
}

TEST(Fingerprints, GrowWithTheText) {
    const auto size = [](const std::string& text) {
        Reading reading("module M\nexports\n" + text + "\nendmodule\n");
        return Fingerprints().of_exports(reading.script.decls.at(0)).size;
    };
    EXPECT_LT(size("x = a"), size("x = aaaa"));
    EXPECT_LT(size("x = a"), size("x = a\ny = a"));
    EXPECT_LT(size("x = a"), size("module N\nexports\nx = a\nendmodule"));
}

}  // namespace
}  // namespace robochart::cspm::test
