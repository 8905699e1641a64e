// SPDX-License-Identifier: Apache-2.0
// Tests assertions in csp blocks, and blocks that replace the instantiation. The heading of the report shows the
// instantiation.
#include <gmock/gmock.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/app/command.hpp"
#include "tests/contents.hpp"

namespace robochart::app::testing::block_claims_test {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string model =
    "package p stm S { event e initial i state A { } transition t0 { from i to A } transition t1 { from A to A trigger "
    "e } }";

/// Returns a folder with a model, a claim that holds, and a block with these assert lines.
Folder claiming(const std::string& lines) {
    return Folder({{"m.rct", model},
                   {"m.assertions", "package q import p::* untimed csp X csp-begin\nX = STOP\n" + lines +
                                        "csp-end\nuntimed assertion A : p::S is deadlock-free"}});
}

// S takes e repeatedly: it does not refine STOP, but it refines RUN({e}).
TEST(BlockClaims, AssertLinesOfBlocksAreDecided) {
    const Folder folder = claiming(
        "assert STOP [T= p::S::O__(0)\nassert RUN({p::S::e.in}) [T= p::S::O__(0)\n"
        "assert not STOP [T= p::S::O__(0)\nassert p::S::O__(0) :[divergence free]\n");
    const Ran ran = run({"check", folder.path(), "--untimed", "--format", "json"});
    EXPECT_EQ(ran.exit, 1) << ran.out << ran.err;
    const auto rows = nlohmann::json::parse(ran.out)["assertions"];
    ASSERT_EQ(rows.size(), 5U) << ran.out;
    EXPECT_EQ(rows[1]["title"], "[untimed] assert STOP [T= p::S::O__(0)");
    EXPECT_EQ(rows[1]["answer"], "fails");
    EXPECT_THAT(rows[1]["place"].get<std::string>(), EndsWith("m.assertions:3"));
    EXPECT_THAT(rows[1]["counterexample"]["end"]["why"].get<std::string>(), HasSubstr("input e is not allowed"));
    EXPECT_EQ(rows[2]["answer"], "holds");
    EXPECT_EQ(rows[3]["answer"], "holds");
    EXPECT_EQ(rows[4]["answer"], "holds");
}

TEST(BlockClaims, ADenialThatDoesNotHoldFailsWithoutARun) {
    const Folder folder = claiming("assert not RUN({p::S::e.in}) [T= p::S::O__(0)\n");
    const Ran ran = run({"check", folder.path(), "--untimed", "-q"});
    EXPECT_EQ(ran.exit, 1) << ran.out << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("what it denies holds"));
}

// The generated script contains each assert line once.
TEST(BlockClaims, AreWrittenOnce) {
    const Folder folder = claiming("assert STOP [T= p::S::O__(0)\n");
    EXPECT_EQ(run({"emit", "csp", folder.path(), "--untimed", "--out", folder / "out"}).exit, 0);
    std::string all;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder / "out"))
        if (entry.is_regular_file()) all += tests::read_contents(entry.path());
    const std::string line = "assert STOP [T= p::S::O__(0)";
    EXPECT_NE(all.find(line), std::string::npos);
    EXPECT_EQ(all.find(line), all.rfind(line));
}

TEST(BlockClaims, ABlockOfInstantiationsIsSaidToReplaceThem) {
    const Folder folder({{"m.rct", model},
                         {"m.assertions",
                          "package q import p::* csp Instantiations csp-begin\nnametype core_nat = {0..1}\n"
                          "csp-end\nuntimed assertion A : p::S is deadlock-free"}});
    const Ran ran = run({"check", folder.path(), "--untimed"});
    EXPECT_EQ(ran.exit, 0) << ran.out << ran.err;
    EXPECT_THAT(ran.out, HasSubstr("the csp block Instantiations replaces that in the scripts"));
}

/// If a block sets constants, the claims and the verdict on the code use different constants, and a warning says so. It
/// is omitted if the command line sets the same constants.
TEST(BlockClaims, ConformSaysWhatItHasOtherValuesOf) {
    const std::string machine =
        "package p function f(x : nat) : nat { } stm S { event o : nat const k : nat const j : nat = 2 initial i "
        "state A { } transition t0 { from i to A action send o!(f(k) + j) } }";
    const Folder folder({{"m.rct", machine},
                         {"m.assertions",
                          "package q import p::* timed csp Instantiations csp-begin\n-- as built\n"
                          "const_p_S_k = 1 -- not 0\nconst_p_S_j = 2\np_f(x) = x\ncsp-end\n"}});
    const std::string warning = "the csp block Instantiations is not read here: ";
    const Ran ran = run({"conform", folder.path()});
    EXPECT_THAT(ran.out, HasSubstr("warning: " + warning + "k = 0 (there 1), f(...); --const sets constants\n"));
    EXPECT_EQ(run({"conform", folder.path(), "--const", "k=1"}).out.find("k = "), std::string::npos);
    EXPECT_THAT(run({"conform", folder.path(), "--format", "json"}).out, HasSubstr(warning + "k = 0 (there 1)"));
    const Folder without({{"m.rct", machine}, {"m.assertions", "package q import p::*"}});
    EXPECT_THAT(run({"conform", without.path()}).out, Not(HasSubstr(warning)));
}

TEST(BlockClaims, ABlockWithErrorsChangesNothingOfConform) {
    const Folder folder(
        {{"m.rct", model}, {"m.assertions", "package q import p::* csp Instantiations csp-begin\n) = (\ncsp-end\n"}});
    const Ran ran = run({"conform", folder.path()});
    EXPECT_EQ(ran.exit, 0) << ran.out << ran.err;
}

}  // namespace
}  // namespace robochart::app::testing::block_claims_test
