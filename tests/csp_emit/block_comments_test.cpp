// SPDX-License-Identifier: Apache-2.0
// Tests that declarations keep their comments when they are printed again, and that the comments do not change the
// declarations.
#include "csp_emit/base/block_comments.hpp"

#include <gtest/gtest.h>

#include "checker/cspm/syntax/reader.hpp"

namespace robochart::csp_emit::block_comments_test {
namespace {

std::string print_with_comments(const std::string& text) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    const cspm::Script script = cspm::read(sources, sources.add("block.csp", text), diagnostics);
    EXPECT_TRUE(diagnostics.ok()) << text;
    const cspm::Script commented{with_comments(script.decls, text)};
    EXPECT_TRUE(cspm::equal(script, commented));
    return cspm::print(commented);
}

TEST(BlockComments, StandAboveTheDeclarationThatTheyBelongTo) {
    EXPECT_EQ(
        print_with_comments("-- first\n--second\nP = STOP -- beside\n-- of Q\nQ = -- within\n  P\n\n-- behind all\n"),
        "-- first\n-- second\n-- beside\nP = STOP\n\n-- of Q\n-- within\n-- behind all\nQ = P\n");
}

TEST(BlockComments, OfBlocksNestAndHaveLines) {
    EXPECT_EQ(print_with_comments("{- one {- two -}\n   three -}\nP = STOP\n"),
              "-- one {- two -}\n-- three\nP = STOP\n");
    EXPECT_EQ(print_with_comments("P = STOP\n{--}\n{- -}\n--\nQ = P\n"), "P = STOP\nQ = P\n");
}

TEST(BlockComments, InStringsAreNone) {
    EXPECT_EQ(print_with_comments("s = \"-- no {- comment\"\nt = 1 -- yes\n"),
              "s = \"-- no {- comment\"\n\n-- yes\nt = 1\n");
}

TEST(BlockComments, OfSectionsStayInside) {
    EXPECT_EQ(print_with_comments("-- outside\nTimed(OneStep) {\n  -- inside\n  P = STOP\n}\n-- of Q\nQ = STOP\n"),
              "-- outside\nTimed(OneStep) {\n    -- inside\n    P = STOP\n}\n\n-- of Q\nQ = STOP\n");
    EXPECT_EQ(print_with_comments("module M\n-- own\nx = 1\nexports\n-- shown\ny = x\nendmodule -- end\n"),
              "-- end\nmodule M\n    -- own\n    x = 1\nexports\n    -- shown\n    y = x\nendmodule\n");
}

/// Characters that other programs treat as line ends are removed from comments.
TEST(BlockComments, HoldNoControlCharacters) {
    EXPECT_EQ(print_with_comments("-- a\rassert STOP\x1b[2J\r\nP = STOP\n"), "-- a\\rassert STOP\\x1b[2J\nP = STOP\n");
}

TEST(BlockComments, AreNothingToTextWithoutDeclarations) {
    EXPECT_EQ(with_comments({}, "-- alone\n").size(), 0U);
}

}  // namespace
}  // namespace robochart::csp_emit::block_comments_test
