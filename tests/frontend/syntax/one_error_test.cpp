// SPDX-License-Identifier: Apache-2.0
// Tests confused forms and missing braces. Each causes one error that states the correct form, with a fix that parses
// as intended.
#include <gtest/gtest.h>

#include "base/diagnostics/fixes.hpp"
#include "tests/frontend/fixture.hpp"

namespace robochart::frontend {
namespace {

using testing::read;

std::string machine(const std::string& transition) {
    return "stm S {\n  event e\n  event f : nat\n  var x : nat\n  initial i\n  state A { }\n  state B { }\n"
           "  transition t0 { from i to A }\n  transition t " +
           transition + "\n  transition t2 { from B to A }\n}\n";
}

/// Returns the text after the fix of its only error.
std::string fixed(const std::string& text, bool assertions = false) {
    const auto reading = read(text, assertions);
    const auto findings = reading->findings.sorted_findings();
    EXPECT_EQ(findings.size(), 1U) << reading->report();
    if (findings.size() != 1 || findings.front().fixes.size() != 1) {
        ADD_FAILURE() << reading->report();
        return {};
    }
    return diagnostics::apply_fixes(text, findings.front().fixes);
}

TEST(OneError, ATriggerIsForgotten) {
    EXPECT_EQ(fixed(machine("{ from A to B e }")), machine("{ from A to B trigger e }"));
    EXPECT_EQ(fixed(machine("{ from A to B e [x < 3] }")), machine("{ from A to B trigger e condition x < 3 }"));
    EXPECT_EQ(fixed(machine("{ from A to B e [x < 3] / x = 1 }")),
              machine("{ from A to B trigger e condition x < 3 action x = 1 }"));
    EXPECT_EQ(fixed(machine("{ from A to B f?x / skip }")), machine("{ from A to B trigger f?x action skip }"));
    EXPECT_EQ(fixed(machine("{ from A to B e condition x < 3 }")),
              machine("{ from A to B trigger e condition x < 3 }"));
}

TEST(OneError, BracesOfATransitionAreMissing) {
    EXPECT_EQ(fixed(machine("from A to B trigger e")), machine("{ from A to B trigger e }"));
    EXPECT_EQ(fixed(machine("from A to B }")), machine("{ from A to B }"));
}

/// Each brace of a well laid out text is omitted, one at a time.
TEST(OneError, ABraceIsMissing) {
    const std::string whole =
        "interface I {\n  event e\n}\nenumeration E {\n  a b\n}\ndatatype D {\n  f : nat\n}\nstm M {\n  uses I\n  var "
        "x : nat\n  initial i\n  state A {\n    entry x = 1\n    initial j\n    state C { }\n    transition t9 {\n     "
        " "
        "from j to C\n    }\n  }\n  state B { entry skip }\n  transition t0 { from i to A }\n  transition t1 { from A "
        "to "
        "B trigger e action x = 2 }\n  transition t2 { from B to A }\n}\ncontroller K {\n  uses I\n  sref m = M\n  "
        "connection K on e to m on e\n}\n";
    EXPECT_TRUE(read(whole)->findings.ok());
    for (std::size_t i = 0; i < whole.size(); ++i) {
        if (whole[i] != '{' && whole[i] != '}') continue;
        std::string cut = whole;
        cut[i] = ' ';
        const auto reading = read(cut);
        EXPECT_EQ(reading->findings.error_count(), 1U) << reading->report();
    }
}

TEST(OneError, AClaimIsInPrismsNotation) {
    const std::string head = "prob property P1 : ";
    EXPECT_EQ(fixed(head + "P=? [ F M::S is in M::S::A ]", true), head + "Prob=? of [ Finally M::S is in M::S::A ]");
    EXPECT_EQ(fixed(head + "Pmax=? [ F<=10 M::S is in M::S::A ]", true),
              head + "Prob max=? of [ Finally<=10 M::S is in M::S::A ]");
    EXPECT_EQ(fixed(head + "P>=0.9 [ M::S is in M::S::A U M::S is in M::S::B ]", true),
              head + "Prob>=0.9 of [ M::S is in M::S::A Until M::S is in M::S::B ]");
    const auto reward = read(head + "R{\"time\"}=? [ F M::S is in M::S::A ]", true);
    EXPECT_EQ(reward->findings.error_count(), 1U) << reward->report();
    EXPECT_NE(reward->report().find("Reward {r} =? of"), std::string::npos) << reward->report();
}

TEST(OneError, AnEqualsSignBeforeAQuestionMarkIsNotDoubled) {
    for (const diagnostics::Diagnostic& finding :
         read("prob property P1 : Q=? [ x ]", true)->findings.sorted_findings())
        EXPECT_TRUE(finding.fixes.empty()) << finding.message();
}

}  // namespace
}  // namespace robochart::frontend
