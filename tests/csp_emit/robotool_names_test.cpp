// SPDX-License-Identifier: Apache-2.0
// Tests names in CSP blocks that earlier versions of RoboTool's generators used. Each name is reported with its current
// form, and the fix preserves the meaning of the script.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/diagnostics/fixes.hpp"
#include "checker/cspm/types/type_check.hpp"
#include "tests/csp_emit/fixture.hpp"

namespace robochart::csp_emit::robotool_names_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const char* const lift = R"(
package Tower
interface Motor { pull(metres : nat) }
interface Buttons { event up event floor : nat }
stm Lift {
    requires Motor
    uses Buttons
    var at : nat
    initial i
    state Waiting { }
    state Going { entry pull(1) }
    transition t0 { from i to Waiting }
    transition t1 { from Waiting to Going trigger up }
    transition t2 { from Going to Waiting trigger floor ? at }
}
)";

std::string block_text(const std::string& text, const std::string& name = "Spec") {
    return "untimed csp " + name + " csp-begin\n" + text + "\ncsp-end\n";
}

std::string claim_text(const std::string& form) {
    return "untimed assertion A : Tower::Lift " + form + "\n";
}

/// Applies the fixes of the findings repeatedly until none is left. Returns the assertions.
std::string apply_all_fixes(std::string assertions) {
    for (int round = 0; round < 5; ++round) {
        const auto m = testing::load_model(lift, assertions);
        (void)m->emit(Time::untimed);
        std::vector<diagnostics::FixIt> fixes;
        for (const diagnostics::Diagnostic& finding : m->diagnostics.sorted_findings())
            fixes.insert(fixes.end(), finding.fixes.begin(), finding.fixes.end());
        if (fixes.empty()) break;
        assertions = diagnostics::apply_fixes(assertions, fixes);
    }
    return assertions;
}

TEST(OldNames, AreReportedWithTodays) {
    const auto m = testing::load_model(lift, block_text("Spec = Lift_up.in -> Lift_floor.in?x -> Spec") +
                                                 claim_text("refines Spec in the traces model"));
    (void)m->emit(Time::untimed);
    EXPECT_THAT(m->codes(), ElementsAre("RC-C15", "RC-C15")) << m->messages();
    EXPECT_THAT(m->messages(), HasSubstr("Lift_up is a name of RoboTool, but this script does not have it: it belongs "
                                         "to an older generator; its name is now Tower::Lift::up"));
}

// Tests every form in the table of docs/robotool.md. The fixes preserve the meaning of the block.
TEST(OldNames, AreReplacedByTheirFixes) {
    const std::string now = apply_all_fixes(
        block_text("Spec = Lift_up.in -> Tower_Lift_pullCall.1 -> Lift_pullRet -> Lift::floor.in?x -> Spec\n"
                   "Other = Lift_O(0)\nThird = Lift_D(0) [] Lift_VS_O(0)\n"
                   "Calls = {| Lift_pullCall |}") +
        claim_text("refines Spec in the traces model"));
    EXPECT_EQ(now,
              block_text("Spec = Tower::Lift::up.in -> Tower::Lift::pullCall.1 -> Tower::Lift::floor.in?x -> Spec\n"
                         "Other = Tower::Lift::O__(0)\nThird = Tower::Lift::D__(0) [] Tower::Lift::VS_O__(0)\n"
                         "Calls = {| Tower::Lift::pullCall |}") +
                  claim_text("refines Spec in the traces model"));
    const auto m = testing::load_model(lift, now);
    EXPECT_THAT(testing::decide_obligations(*m, Time::untimed), ElementsAre("holds")) << m->messages();
}

TEST(OldNames, OfReturnsAreLeftOut) {
    const std::string now = apply_all_fixes(block_text("Spec = Tower::Lift::up.in -> Tower::Lift::pullCall.1 -> "
                                                       "(Tower::Lift::pullRet -> Tower::Lift::floor.in?x -> Spec)") +
                                            claim_text("refines Spec in the traces model"));
    const auto m = testing::load_model(lift, now);
    EXPECT_THAT(testing::decide_obligations(*m, Time::untimed), ElementsAre("holds")) << now << m->messages();
}

TEST(OldNames, OfStatesHaveNoFix) {
    const auto m = testing::load_model(lift, block_text("Spec = Lift_enteredV?s -> Spec") + claim_text("equals Spec"));
    (void)m->emit(Time::untimed);
    ASSERT_THAT(m->codes(), ElementsAre("RC-C15")) << m->messages();
    EXPECT_THAT(m->messages(), HasSubstr("Tower::Lift::STATE::entered"));
    EXPECT_THAT(m->diagnostics.sorted_findings().front().fixes, IsEmpty());
}

// A name that a block declares or binds belongs to the block.
TEST(OldNames, ThatABlockDeclaresAreItsOwn) {
    const auto m = testing::load_model(
        lift,
        block_text("channel Lift_up\nSpec = let Lift_floor = Lift_up -> STOP within Lift_floor\n"
                   "Twice(Lift_O) = Lift_O [] Lift_O\nmodule Lift\nexports\n  up = STOP\nendmodule\nThird = Lift::up") +
            claim_text("is deadlock-free"));
    const Emission emission = m->emit(Time::untimed);
    cspm::check_types(emission.script, m->diagnostics);
    EXPECT_TRUE(m->diagnostics.ok()) << m->messages();
}

// `at` is private, and no version of the generator exported such a name.
TEST(OldNames, OfWhatIsNotThereAreUnknown) {
    const auto m = testing::load_model(lift, block_text("Spec = Lift_at -> Spec") + claim_text("is deadlock-free"));
    const Emission emission = m->emit(Time::untimed);
    EXPECT_THAT(m->codes(), IsEmpty()) << m->messages();
    cspm::check_types(emission.script, m->diagnostics);
    EXPECT_FALSE(m->diagnostics.ok());
}

// Two packages each have a machine with the same name, so the reference is ambiguous.
TEST(OldNames, ThatMayBeOfTwoComponentsAreUnknown) {
    const std::string stm =
        "stm S { event e initial i state A { } transition t { from i to A } transition u { from A "
        "to A trigger e } }";
    const auto m = testing::model_of(
        {{"p.rct", "package P " + stm},
         {"q.rct", "package Q " + stm},
         {"a.assertions", block_text("Spec = S_e.in -> Spec") + "untimed assertion A : P::S is deadlock-free\n"}});
    (void)m->emit(Time::untimed);
    EXPECT_THAT(m->codes(), IsEmpty()) << m->messages();
}

TEST(OldNames, OfCarriersAreReplacedInInstantiations) {
    const std::string now = apply_all_fixes("csp Instantiations csp-begin\n\tnametype nat = {0..7}\ncsp-end\n" +
                                            claim_text("is deadlock-free"));
    EXPECT_THAT(now, HasSubstr("nametype core_nat = {0..7}"));
    const auto m = testing::load_model(lift, now);
    const Emission emission = m->emit(Time::untimed);
    EXPECT_THAT(m->codes(), ElementsAre("RC-C07")) << m->messages();
}

}  // namespace
}  // namespace robochart::csp_emit::robotool_names_test
