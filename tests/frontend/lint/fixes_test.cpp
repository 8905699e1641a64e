// SPDX-License-Identifier: Apache-2.0
// Tests certain fixes. If they are applied as `validate --fix` applies them, the text is accepted afterwards.
#include <gtest/gtest.h>

#include "base/diagnostics/fixes.hpp"
#include "tests/frontend/fixture.hpp"

namespace robochart::frontend {
namespace {

/// Returns the text after all certain fixes.
std::string fixed(const std::string& text) {
    const auto reading = testing::resolved(text);
    const diagnostics::SourceId source = reading->file().source;
    return diagnostics::apply_fixes(text, diagnostics::certain_fixes(reading->findings, source));
}

std::string codes(const std::string& text) {
    return testing::resolved(text)->codes();
}

std::string with_machine(const std::string& text) {
    return text +
           "\ncontroller C { event e event f sref s = S }\n"
           "stm S { event e initial i state s { } transition t { from i to s } }\n";
}

std::string module_with(const std::string& connection) {
    return with_machine("module M { robotic platform R { event e } cref c = C\n" + connection + " }");
}

/// The fix of Cn2 is correct for all texts after the event, and for a platform at either end.
TEST(LintFixes, MakeAConnectionWithThePlatformAsynchronous) {
    for (const char* end : {"", " [mult]", " // by wire"}) {
        for (const char* ends : {"connection R on e to c on e", "connection c on e to R on e"}) {
            const std::string text = module_with(std::string(ends) + end + "\n");
            // No connection inside the controller continues a bidirectional connection, so Cn5 and Cn7 are reported
            // before and after the fix.
            EXPECT_NE(codes(text).find("Cn2@2"), std::string::npos) << text;
            EXPECT_EQ(fixed(text), module_with(std::string(ends) + " (_async)" + end + "\n"));
            EXPECT_EQ(codes(fixed(text)).find("Cn2"), std::string::npos) << fixed(text);
        }
    }
    EXPECT_TRUE(testing::resolved(fixed(module_with("connection R on e to c on e")))->findings.ok());
}

/// A connection between controllers may be synchronous or asynchronous, so the fix does not change it.
TEST(LintFixes, LeaveOtherConnectionsAlone) {
    const std::string text = module_with("cref d = C connection R on e to c on e (_async) connection c on f to d on f");
    EXPECT_EQ(fixed(text), text);
}

TEST(LintFixes, CallAFunctionThatWasOnlyNamed) {
    const std::string text =
        "function f():nat { } function g():Seq(nat) { } interface I { const c:nat = f + 1 const d:";
    EXPECT_EQ(codes(text + "Seq(nat) = g cat <f> }"), "RC-T35@1 RC-T35@1 RC-T35@1");
    EXPECT_EQ(fixed(text + "Seq(nat) = g cat <f> }"),
              "function f():nat { } function g():Seq(nat) { } interface I { const c:nat = f() + 1 const d:Seq(nat) = "
              "g() cat <f()> }");
    EXPECT_EQ(codes(fixed(text + "Seq(nat) = g cat <f> }")), "");
}

TEST(LintFixes, CorrectAnImport) {
    const std::string text = "import sequence_tolkit::* interface I { const c:nat = size(<1>) }";
    EXPECT_NE(codes(text).find("RC-N04@1"), std::string::npos);
    EXPECT_EQ(codes(fixed(text)), "") << fixed(text);
    EXPECT_EQ(fixed("import set_toolkit::subsett type A"), "import set_toolkit::subset type A");
    // No toolkit has a similar name.
    EXPECT_EQ(fixed("import nowhere::* type A"), "import nowhere::* type A");
}

/// The fix for `in` with a sequence is likely to be right, but not certain.
TEST(LintFixes, SuggestTheElementsOfASequence) {
    const auto reading = testing::resolved("interface I { const s:Seq(nat) = <1> const b:boolean = 1 in s }");
    EXPECT_EQ(reading->codes(), "RC-T23@1");
    ASSERT_EQ(reading->findings.sorted_findings().front().fixes.size(), 1U);
    EXPECT_EQ(reading->findings.sorted_findings().front().fixes.front().replacement, "ran(s)");
    EXPECT_FALSE(diagnostics::is_certain(reading->findings.sorted_findings().front().fixes.front()));
    const std::string given = "import relation_toolkit::* interface I { const s:Seq(nat) = <1> const b:boolean = ";
    EXPECT_EQ(codes(given + "1 in ran(s) }"), "");
    EXPECT_EQ(codes(given + "(|1, 1|) in s }"), "");  // a sequence is the set of its pairs
    EXPECT_EQ(testing::resolved(given + "true in s }")->findings.sorted_findings().front().fixes.size(), 0U);
}

}  // namespace
}  // namespace robochart::frontend
