// SPDX-License-Identifier: Apache-2.0
// Tests the checks of function preconditions in generated code: which checks are generated, in which order, and which
// are omitted as unnecessary. tests/conformance/check/preconditions_test.cpp shows that the code agrees with the model.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/cpp_emit/harness.hpp"
#include "tests/cpp_emit/models.hpp"

namespace robochart::cpp_emit::preconditions_test {
namespace {

using testing::component_named;

std::string core_of(const std::string& body) {
    const ir::System system = testing::load_model(
        "package p import set_toolkit::* import sequence_toolkit::*\n"
        "function sure(n : nat) : nat { precondition true precondition true \\/ n > 0 }\n"
        "function some(n : nat) : nat { precondition n > 0 }\n"
        "function above(n : nat) : nat { precondition some(n) > 1 }\n"
        "stm M { event a : nat event x : nat var v : nat var s : Seq(nat) const two : nat = 2 initial i state A { }\n"
        "transition t0 { from i to A }\n" +
        body + "}");
    const Emission emission = testing::emit_ok(system, component_named(system, "M"));
    return std::ranges::find_if(emission.files, [](const OutputFile& file) { return file.path == "M_core.hpp"; })->text;
}

bool has_checks(const std::string& text) {
    return text.find("stuck") != std::string::npos || text.find("pre_") != std::string::npos ||
           text.find(".size() > 0") != std::string::npos;
}

TEST(PreconditionsOfFunctions, ThatAreSeenToHoldAddNoCode) {
    for (const std::string value :
         {"sure(v)", "some(2)", "some(two)", "max({1, 2})", "min({v, 1})", "head(<v>)", "size(tail(<v>))"})
        EXPECT_FALSE(has_checks(core_of("transition t1 { from A to A trigger a?v action x!(" + value + ") }")))
            << value;
}

TEST(PreconditionsOfFunctions, ThatCanBeFalseAreAsked) {
    for (const std::string value :
         {"some(v)", "some(0)", "above(v)", "head(s)", "head(tail(<v>))", "min({k : nat | k < v})", "max({})"})
        EXPECT_TRUE(has_checks(core_of("transition t1 { from A to A trigger a?v action x!(" + value + ") }"))) << value;
}

TEST(PreconditionsOfFunctions, OfInnerCallsComeFirst) {
    const std::string text = core_of("transition t1 { from A to A trigger a?v action x!(head(tail(s))) }");
    EXPECT_NE(text.find("if (!(state_.s.size() > 0 && robochart::toolkit::tail<"), std::string::npos) << text;
    const std::string model = core_of("transition t1 { from A to A trigger a?v action x!(above(v)) }");
    EXPECT_NE(model.find("return pre_some(bound_n) && platform_.some(bound_n) > Nat(1);"), std::string::npos) << model;
}

}  // namespace
}  // namespace robochart::cpp_emit::preconditions_test
