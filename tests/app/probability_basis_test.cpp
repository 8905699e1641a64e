// SPDX-License-Identifier: Apache-2.0
// Tests the basis of answers to probabilistic assertions: bounds of the finite instantiation for each set of constants,
// constants without a given value, and random paths.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/app/command.hpp"

namespace robochart::app::testing::probability_basis_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// From A, a toss either adds `step` to x or leads to B. nat is 0..2, so 2 + 2 is not in it.
constexpr const char* walk =
    "stm Walk { const step : nat event go var x : nat = 0 initial i state A { } state B { } probabilistic p\n"
    "transition t0 { from i to A } transition t1 { from A to p trigger go }\n"
    "transition t2 { from p to A probability 0.5 action x = x + step }\n"
    "transition t3 { from p to B probability 0.5 } }\n";

class ProbabilityBasis : public ::testing::Test {
protected:
    /// Returns the basis of each claim, in the order of the claims.
    static std::vector<nlohmann::json> basis(const std::string& claims, std::vector<std::string> options = {},
                                             const char* model = walk) {
        const Folder folder({{"m.rct", model}, {"m.assertions", "label done = Walk is in Walk::B\n" + claims}});
        options.insert(options.begin(), {"check", folder.path(), "--format", "json"});
        const Ran ran = run(options);
        const auto report = nlohmann::json::parse(ran.out, nullptr, false);
        std::vector<nlohmann::json> result;
        EXPECT_FALSE(report.is_discarded()) << ran.out << ran.err;
        if (report.is_discarded()) return result;
        for (const auto& claim : report["assertions"]) result.push_back(claim.value("basis", nlohmann::json::array()));
        return result;
    }
    static std::vector<std::string> texts(const nlohmann::json& basis, const std::string& kind) {
        std::vector<std::string> result;
        for (const auto& ground : basis)
            if (ground["kind"] == kind) result.push_back(ground["text"]);
        return result;
    }
};

// With step 0, x stays 0. With steps 1 and 2, the sum leaves 0..2 after two tosses.
TEST_F(ProbabilityBasis, NamesTheBoundsOfEachSetOfConstants) {
    const auto found = basis(
        "prob property P : Prob=? of [Finally <=3 #done] with constants Walk::step from set {0, 2}\n"
        "prob property Q : Prob=? of [Finally <=3 #done] with constants Walk::step set to 0\n"
        "prob property R : Prob=? of [Finally <=3 #done] with constants Walk::step set to 2\n");
    ASSERT_EQ(found.size(), 3U);
    EXPECT_THAT(texts(found[0], "bound"),
                ElementsAre("in x + step, 2 + 2 leaves its type and is taken as 2 (with Walk::step=2)"));
    EXPECT_THAT(texts(found[1], "bound"), IsEmpty());
    EXPECT_THAT(texts(found[2], "bound"), ElementsAre("in x + step, 2 + 2 leaves its type and is taken as 2"));
    EXPECT_EQ(found[0][0]["element"], "Walk::t2");
    for (const auto& basis : found) EXPECT_THAT(texts(basis, "constant"), IsEmpty()) << "the claim gives the value";
}

TEST_F(ProbabilityBasis, NamesConstantsThatNothingGivesAValue) {
    const char* const claim = "prob property P : Prob=? of [Finally <=3 #done]\n";
    EXPECT_THAT(texts(basis(claim).at(0), "constant"),
                ElementsAre(HasSubstr("nothing gives the constant Walk::step a value; the program has chosen ")));
    EXPECT_THAT(texts(basis(claim, {"--const", "Walk::step=1"}).at(0), "constant"), IsEmpty());
}

TEST_F(ProbabilityBasis, NamesRandomPaths) {
    const char* const game =
        "robotic platform Table { event throw } stm Walk { event throw initial i state A { } state B { } "
        "probabilistic p transition t0 { from i to A } transition t1 { from A to p trigger throw } "
        "transition t2 { from p to B probability 0.5 } transition t3 { from p to A probability 0.5 } "
        "transition t4 { from B to B trigger throw } } "
        "controller Hand { event throw sref walk = Walk connection Hand on throw to walk on throw } "
        "module Game { rref table = Table cref hand = Hand connection table on throw to hand on throw ( _async ) }";
    const auto found = basis(
        "label there = Game::hand::walk is in Walk::B\n"
        "prob property P : Prob=? of [Finally <=3 #there] using sim with CI at n=1000, alpha=0.01, and pathlen=100\n"
        "prob property Q : Prob=? of [Finally <=3 #there]\n",
        {"--encoding", "robotool", "--seed", "5", "--allow", "PJ3"}, game);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_THAT(texts(found[0], "sampling"), ElementsAre("random paths instead of all paths, with seed 5"));
    EXPECT_THAT(texts(found[1], "sampling"), IsEmpty());
}

// The command reads the file of preferences even if no claim needs it.
TEST_F(ProbabilityBasis, PreferencesThatCannotBeReadAreAnError) {
    const Folder folder{{{"m.rct", walk}}};
    const Ran ran = run({"check", folder.path(), "--prefs", folder / "missing.prefs"});
    EXPECT_EQ(ran.exit, 2);
    EXPECT_THAT(ran.err, HasSubstr("RC-E07"));
    EXPECT_THAT(ran.err, HasSubstr("missing.prefs"));
}

}  // namespace
}  // namespace robochart::app::testing::probability_basis_test
