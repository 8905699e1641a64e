// SPDX-License-Identifier: Apache-2.0
// Tests that CSP blocks may use the carriers of records: `P_R` is the set of values of the record R of package P.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "checker/cspm/types/type_check.hpp"
#include "tests/csp_emit/fixture.hpp"

namespace robochart::csp_emit::record_carriers_test {
namespace {

using ::testing::ElementsAre;

std::string block(const std::string& text, const std::string& name = "Spec") {
    return "untimed csp " + name + " csp-begin\n" + text + "\ncsp-end\n";
}

const char* const copier = R"(
package Data
record Pair { left : nat right : boolean }
record Alone { value : nat }
stm Copier {
    event put : Pair
    event got : Pair
    event one : Alone
    var p : Pair
    initial i
    state Wait { }
    transition t0 { from i to Wait }
    transition t1 { from Wait to Wait trigger put ? p action got ! p }
}
)";

TEST(Records, AreCarriersInBlocks) {
    const std::string all =
        "Spec = |~| v : Data_Pair @ Data::Copier::put.in.v -> Data::Copier::got.out.v -> Spec\n"
        "Numbers = [] v : Data_Alone @ Data::Copier::one.in.v -> STOP";
    const std::string few =
        "Few = |~| v : {(0, true), (1, true)} @ Data::Copier::put.in.v -> Data::Copier::got.out.v -> Few";
    const auto m =
        testing::load_model(copier, block(all) + block(few, "Few") +
                                        "untimed assertion A : Data::Copier refines Spec in the traces model\n"
                                        "untimed assertion B : Data::Copier refines Few in the traces model\n");
    EXPECT_THAT(testing::decide_obligations(*m, Time::untimed), ElementsAre("holds", "fails")) << m->messages();
    const Emission emission = m->emit(Time::untimed);
    cspm::check_types(emission.script, m->diagnostics);
    EXPECT_TRUE(m->diagnostics.ok()) << m->messages();
}

// A block may define the name with fewer values. If a component, an enumeration or a constant has the same name, the
// name denotes that element in the block.
TEST(Records, GiveWayToOtherNames) {
    const auto narrowed = testing::load_model(
        copier, block("nametype Data_Pair = {(0, true)}\n"
                      "Spec = |~| v : Data_Pair @ Data::Copier::put.in.v -> Data::Copier::got.out.v -> Spec") +
                    "untimed assertion A : Data::Copier refines Spec in the traces model\n");
    EXPECT_THAT(testing::decide_obligations(*narrowed, Time::untimed), ElementsAre("fails")) << narrowed->messages();
    const auto component = testing::load_model(
        "record S { f : nat } stm S { event e initial i state A { } transition t0 { from i to A } transition t { from "
        "A to A trigger e } }",
        block("Spec = S::e.in -> Spec") + "untimed assertion A : S equals Spec\n");
    ASSERT_TRUE(component->diagnostics.ok()) << component->messages();
    EXPECT_THAT(testing::decide_obligations(*component, Time::untimed), ElementsAre("holds")) << component->messages();
}

}  // namespace
}  // namespace robochart::csp_emit::record_carriers_test
