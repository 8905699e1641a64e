// SPDX-License-Identifier: Apache-2.0
// Tests the lowering of assertions and csp blocks (reference: assertion language 4).
#include <gtest/gtest.h>

#include "semantics/ir/dump.hpp"
#include "tests/semantics/lower/lowering_fixture.hpp"

namespace robochart::ir {
namespace {

using namespace samples;
using Codes = std::vector<std::string>;

const std::string model = R"(package P
interface I { const z : nat }
operation op(n:nat) { initial i final f transition t { from i to f } }
stm S {
    requires I
    const own : real
    clock K
    initial i
    state A { initial j state B { } final g transition u { from j to B } transition v { from B to g } }
    transition t { from i to A }
}
controller C { requires I sref s = S opref o = op }
module M {
    robotic platform R { provides I }
    cref c = C
}
)";

std::unique_ptr<Lowered> lowered_with(const std::string& assertions) {
    return lower_files({{"m/m.rct", model}, {"m/m.assertions", assertions}});
}

const Property& only(const Lowered& lowered) {
    EXPECT_TRUE(lowered.diagnostics.ok()) << lowered.messages();
    EXPECT_EQ(lowered.system.properties.size(), 1U);
    return lowered.system.properties.at(0);
}

TEST(LowerProperties, KindsModelsTimesAndWording) {
    const auto lowered = lowered_with("timed assertion A1 :\n\tP::S is not deadlock-free\n");
    const auto& property = only(*lowered);
    EXPECT_EQ(property.name, "A1");
    EXPECT_EQ(property.kind, PropertyKind::deadlock_free);
    EXPECT_TRUE(property.negated);
    EXPECT_TRUE(property.timed);
    EXPECT_FALSE(property.untimed);
    EXPECT_EQ(property.model, PropertyModel::failures_divergences);
    EXPECT_EQ(property.wording, "timed assertion A1 : P::S is not deadlock-free");
    EXPECT_EQ(property.file, "m/m.assertions");
}

TEST(LowerProperties, PathsThroughReferences) {
    const auto path = [](const std::string& subject) {
        const auto lowered =
            lowered_with("assertion A : " + subject + " is deterministic with constant z of P::S set to 0\n");
        const auto& ref = only(*lowered).subject;
        return ref.package + " " + ref.path + " " + std::to_string(static_cast<int>(ref.kind)) + " " +
               std::to_string(ref.definition);
    };
    EXPECT_EQ(path("P::M"), "P M 0 0");
    EXPECT_EQ(path("P::M::c"), "P M::c 1 0");
    EXPECT_EQ(path("P::M::c::s"), "P M::c::s 2 1");
    EXPECT_EQ(path("P::C"), "P C 1 0");
    EXPECT_EQ(path("P::C::s"), "P C::s 2 1");
    EXPECT_EQ(path("P::C::o"), "P C::OP_op 3 0");
    EXPECT_EQ(path("P::C::op"), "P C::OP_op 3 0");
    EXPECT_EQ(path("P::op"), "P OP_op 3 0");
    EXPECT_EQ(path("P::S"), "P S 2 1");
}

TEST(LowerProperties, ImportsOpenPackages) {
    const auto lowered = lowered_with("import P::*\nassertion A : M::c refines M::c in the traces model\n");
    const auto& property = only(*lowered);
    EXPECT_EQ(property.subject.path, "M::c");
    EXPECT_EQ(property.other.path, "M::c");
    EXPECT_EQ(property.model, PropertyModel::traces);
}

TEST(LowerProperties, UnknownComponentsAreReported) {
    const auto lowered = lowered_with("import P::*\nassertion A : M::d is deterministic\n");
    EXPECT_EQ(lowered->codes(), Codes{"RC-Q01"});
}

TEST(LowerProperties, CspBlocks) {
    const auto lowered = lowered_with(
        "timed csp Spec associated to P::M csp-begin\nSpec = STOP\ncsp-end\nassertion A : P::M refines Spec\n");
    const auto& property = only(*lowered);
    EXPECT_EQ(property.other.kind, ComponentKind::process);
    EXPECT_EQ(property.other.path, "Spec");
    EXPECT_EQ(property.other.definition, 0U);  // definition of the first block
    ASSERT_EQ(lowered->system.csp_blocks.size(), 1U);
    const auto& block = lowered->system.csp_blocks[0];
    EXPECT_EQ(block.name, "Spec");
    EXPECT_TRUE(block.timed);
    EXPECT_FALSE(block.untimed);
    EXPECT_EQ(block.file, "m/m.assertions");
    ASSERT_EQ(block.associated.size(), 1U);
    EXPECT_EQ(block.associated[0].path, "M");
    const auto text = lowered->sources.source_text(block.text_span.source);
    EXPECT_EQ(text.substr(block.text_span.begin, block.text_span.end - block.text_span.begin), block.text);
    EXPECT_NE(block.text.find("Spec = STOP"), std::string::npos);
}

TEST(LowerProperties, ReachableStates) {
    const auto state = [](const std::string& name, const std::string& subject) {
        const auto lowered = lowered_with("assertion A : " + name + " is reachable in " + subject + "\n");
        if (!lowered->diagnostics.ok()) return lowered->codes().at(0);
        return only(*lowered).state;
    };
    EXPECT_EQ(state("P::S::A", "P::S"), "A");
    EXPECT_EQ(state("P::S::A::B", "P::S"), "A::B");
    EXPECT_EQ(state("P::S::A::g", "P::S"), "A::g");
    EXPECT_EQ(state("A::B", "P::S"), "A::B");
    EXPECT_EQ(state("P::M::c::s::A", "P::M"), "c::s::A");
    EXPECT_EQ(state("P::M::c::s::A", "P::M::c::s"), "A");
    EXPECT_EQ(state("P::S::A", "P::M"), "c::s::A");
    EXPECT_EQ(state("P::S::A", "P::M::c::s"), "A");
    EXPECT_EQ(state("P::S::i", "P::S"), "RC-Q03");
    EXPECT_EQ(state("P::S::X", "P::S"), "RC-Q03");
}

TEST(LowerProperties, ConstantsAreNamedWhereTheirValueCounts) {
    const auto name = [](const std::string& parameter) {
        const auto lowered = lowered_with("assertion A : P::M is deterministic with " + parameter + "\n");
        if (!lowered->diagnostics.ok()) return lowered->codes().at(0);
        const auto& constants = only(*lowered).constants;
        return constants.size() == 1
                   ? constants[0].first + " = " + dump_text(lowered->system, nullptr, *constants[0].second)
                   : std::string("?");
    };
    EXPECT_EQ(name("constant z of P::M set to 1"), "const_P_M_z = 1");
    EXPECT_EQ(name("constant z of P::C set to 1"), "const_P_C_z = 1");
    EXPECT_EQ(name("constant z of P::M::c set to 1"), "const_P_M_z = 1");  // the platform provides it
    EXPECT_EQ(name("constant z of P::C::s set to 1"), "const_P_C_z = 1");  // the controller provides it
    EXPECT_EQ(name("constant z of P::S set to 1"), "const_P_S_z = 1");
    EXPECT_EQ(name("constant own of P::S set to 2"), "const_P_S_own = 2r");
    EXPECT_EQ(name("constant own of P::C::s set to -0.5"), "const_P_C_s_own = -0.5r");
    EXPECT_EQ(name("parameter n of P::op set to 1"), "param_P_op_n = 1");
    EXPECT_EQ(name("constant no of P::S set to 1"), "RC-Q05");
}

TEST(LowerProperties, ClockInitialised) {
    const auto lowered = lowered_with("assertion A : clock P::M::c::s::K is not initialised\n");
    const auto& property = only(*lowered);
    EXPECT_EQ(property.kind, PropertyKind::clock_initialised);
    EXPECT_TRUE(property.negated);
    EXPECT_EQ(property.subject.path, "M::c::s");
    EXPECT_EQ(property.state, "K");
}

}  // namespace
}  // namespace robochart::ir
