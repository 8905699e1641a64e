// SPDX-License-Identifier: Apache-2.0
// Tests texts that FDR's front end unexpectedly accepts or rejects (libcspm: Lexer.x, Parser.ppy).
#include <gtest/gtest.h>

#include "checker/cspm/types/type_check.hpp"
#include "tests/checker/cspm/support.hpp"

namespace robochart::cspm::test {
namespace {

/// Returns the codes of all findings, with their lines.
std::string codes(const std::string& text) {
    Reading reading(text);
    if (reading.ok()) (void)check_types(reading.script, reading.diagnostics);
    std::string result;
    for (const diagnostics::Diagnostic& finding : reading.diagnostics.sorted_findings()) {
        const auto line =
            finding.span.is_known() ? reading.sources.position(finding.span.source, finding.span.begin).line : 0;
        result += (result.empty() ? "" : " ") + std::string(finding.rule->code) + "@" + std::to_string(line);
    }
    return result;
}

// `]:` ends a property like `]`, independently of the text after it.
TEST(AsFdrReads, AColonBehindAnyProperty) {
    const Reading reading(
        "channel a\nP = a -> P\n"
        "assert P :[deadlock free]:\nassert P :[deterministic [FD]]:\n\nassert not P :[divergence free]:\n"
        "assert P :[has trace [T]]:\n <a, a>\nassert P :[deadlock free [F]]: :[tau priority]:\n {a}\nQ = P\n");
    ASSERT_TRUE(reading.ok()) << reading.report();
    const std::vector<DeclPtr>& decls = reading.script.decls;
    ASSERT_EQ(decls.size(), 8U);
    EXPECT_EQ(decls[2]->assertion.kind, AssertionKind::deadlock_free);
    EXPECT_EQ(decls[3]->assertion.model, Model::failures_divergences);
    EXPECT_TRUE(decls[4]->assertion.negated);
    EXPECT_NE(decls[5]->assertion.implementation, nullptr);
    EXPECT_NE(decls[6]->assertion.tau_priority, nullptr);
}

TEST(AsFdrReads, NothingIsAskedInModules) {
    const auto in_module = [](const std::string& text) {
        return codes("channel tock\nmodule M\n" + text + "exports\n Q = STOP\nendmodule\n");
    };
    EXPECT_EQ(in_module(" P = STOP\n"), "");
    EXPECT_EQ(in_module(" assert STOP [T= STOP\n"), "CSPM-P09@3");
    EXPECT_EQ(in_module(" Timed(\\ _ @ 1) {\n  assert STOP [T= STOP\n }\n"), "CSPM-P09@4");
    EXPECT_EQ(in_module(" Timed(\\ _ @ 1) {\n  Timed(\\ _ @ 1) {\n   assert STOP [T= STOP\n  }\n }\n"), "CSPM-P09@5");
    EXPECT_EQ(in_module(" Timed(\\ _ @ 1) {\n  print 1\n }\n"), "CSPM-P09@4");
    EXPECT_EQ(codes("channel tock\nTimed(\\ _ @ 1) {\n assert STOP [T= STOP\n}\n"), "");
    EXPECT_EQ(codes("channel tock\nTimed(\\ _ @ 1) {\n print 1\n}\n"), "CSPM-P09@3");
}

// The rule also applies to text from an included file, although the included file itself contains no module around it.
TEST(AsFdrReads, NothingIsAskedInFilesThatModulesInclude) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics found;
    const auto load = [&](const std::string& path, std::string&) -> std::optional<diagnostics::SourceId> {
        const bool inner = path.ends_with("inner.csp");
        return sources.add(path,
                           inner ? "channel tock\nassert STOP [T= STOP\nTimed(\\ _ @ 1) {\n assert STOP [T= STOP\n}\n"
                                 : "module M\n include \"inner.csp\"\nexports\n Q = STOP\nendmodule\n");
    };
    (void)read_file(sources, "outer.csp", found, load);
    std::string places;
    for (const diagnostics::Diagnostic& finding : found.sorted_findings())
        places += std::string(finding.rule->code) + " " + sources.path_and_line(finding.span) + "\n";
    EXPECT_EQ(places, "CSPM-P09 inner.csp:2\nCSPM-P09 inner.csp:4\n");
}

// Declarations above `exports` are private to their module, also if the module itself is exported.
TEST(AsFdrReads, PrivateNamesStayPrivate) {
    const std::string text =
        "module Outer(n)\n k = n\nexports\n module Inner(m)\n  secret = m\n exports\n  shown = secret + k\n endmodule\n"
        "endmodule\ninstance A = Outer(1)\ninstance B = A::Inner(2)\n";
    EXPECT_EQ(codes(text + "x = B::shown\n"), "");
    EXPECT_EQ(codes(text + "x = B::secret\n"), "CSPM-T01@12");
    const std::string plain =
        "module Outer\nexports\n module Inner\n  secret = 1\n exports\n  shown = 2\n endmodule\nendmodule\n";
    EXPECT_EQ(codes(plain + "x = Outer::Inner::shown\n"), "");
    EXPECT_EQ(codes(plain + "x = Outer::Inner::secret\n"), "CSPM-T01@9");
}

// One mistake causes one finding, at its line.
TEST(AsFdrReads, OneFindingForOneMistake) {
    EXPECT_EQ(codes("channel z : {-3..3}\nchannel y : Int\n"), "CSPM-P03@1");
    EXPECT_EQ(codes("channel a\n\n{- no end\nP = STOP\n"), "CSPM-P03@3");
    EXPECT_EQ(codes("datatype F = fruta | feij\xC3\xA3o\nx = feij\xC3\xA3o\n"), "CSPM-P17@1");
    EXPECT_EQ(codes("channel \xCE\xB1, \xCE\xB2\n"), "CSPM-P17@1 CSPM-P17@1");
    EXPECT_EQ(codes("channel a\nP = a \xE2\x86\x92 STOP\n"), "CSPM-P02@2");
    EXPECT_EQ(codes("P(x) = if (x = 1) then STOP else SKIP\n"), "CSPM-P01@1");
    EXPECT_EQ(codes("Q(x) = if x > 2 then STOP\n\n\nP = STOP\n"), "CSPM-P01@1");
    EXPECT_EQ(codes("Q(x) = if x > 2 then STOP\n\n"), "CSPM-P01@1");
}

// Editors on Windows write a byte order mark.
TEST(AsFdrReads, AByteOrderMarkIsNoPartOfTheText) {
    EXPECT_EQ(codes("\xEF\xBB\xBF"
                    "channel a\nP = a -> STOP\n"),
              "");
    EXPECT_EQ(codes("\xEF\xBB\xBF"
                    "channel a\nP = b -> STOP\n"),
              "CSPM-T01@2");
}

}  // namespace
}  // namespace robochart::cspm::test
