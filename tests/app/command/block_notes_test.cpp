// What `check` says of csp blocks that it does not decide, or that replace what the heading of the report shows.
#include <gmock/gmock.h>

#include "tests/app/command.hpp"

namespace robochart::app::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

const std::string model =
    "package p stm S { event e initial i state A { } transition t0 { from i to A } transition t1 { from A to A trigger "
    "e } }";

TEST(BlockNotes, AssertLinesOfBlocksAreSaidToBeUndecided) {
    const Folder folder({{"m.rct", model},
                         {"m.assertions",
                          "package q import p::* untimed csp X csp-begin\nX = STOP\n"
                          "assert STOP [T= p::S::O__(0)\ncsp-end\n"
                          "untimed assertion A : p::S is deadlock-free"}});
    const Ran ran = run({"check", folder.path(), "--untimed"});
    EXPECT_THAT(ran.out, HasSubstr("not decided here: 1 assert line in csp blocks [untimed]"));
    const Folder without(
        {{"m.rct", model}, {"m.assertions", "package q import p::* untimed assertion A : p::S is deadlock-free"}});
    EXPECT_THAT(run({"check", without.path(), "--untimed", "--core"}).out, Not(HasSubstr("not decided here")));
}

TEST(BlockNotes, ABlockOfInstantiationsIsSaidToReplaceThem) {
    const Folder folder({{"m.rct", model},
                         {"m.assertions",
                          "package q import p::* csp Instantiations csp-begin\nnametype core_nat = {0..1}\n"
                          "csp-end\nuntimed assertion A : p::S is deadlock-free"}});
    const Ran ran = run({"check", folder.path(), "--untimed"});
    EXPECT_EQ(ran.exit, 0) << ran.out << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("the csp block Instantiations replaces that in the scripts"));
}

}  // namespace
}  // namespace robochart::app::testing
