// SPDX-License-Identifier: Apache-2.0
// Tests that branches of a choice that differ only in their events are combined, and that the process keeps its
// meaning.
#include "csp_emit/passes/choice_factoring.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "checker/cspm/syntax/build.hpp"
#include "checker/cspm/syntax/reader.hpp"
#include "tests/csp_emit/fixture.hpp"

namespace robochart::csp_emit::alike_branches_test {
namespace {

namespace b = cspm::build;
using ::testing::ElementsAre;

cspm::ExprPtr parse_expression(const std::string& text) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    return cspm::read(sources, sources.add("t.csp", "X__ = " + text), diagnostics).decls.at(0)->body;
}

struct Gathered {
    std::string body;
    std::vector<NamedSet> sets;
};

Gathered gather_branches(const std::string& body) {
    std::vector<Function> functions{{"P", {"v"}, parse_expression(body)}};
    Gathered result{"", {{"others", parse_expression("{| a, b |}")}}};
    NameManager names;
    gather_alike_branches(functions, names, result.sets);
    result.body = cspm::print(functions[0].body);
    return result;
}

TEST(AlikeBranches, OfOneChoiceBecomeOneBranchOverASetOfEvents) {
    const Gathered result = gather_branches("c!v -> P(v + 1) [] a?x -> P(v) [] b?y -> P(v) [] tock -> P(v)");
    EXPECT_EQ(result.body, "c!v -> P(v + 1) [] ([] e__:alike__ @ e__ -> P(v))");
    ASSERT_EQ(result.sets.size(), 2U);
    EXPECT_EQ(cspm::print(result.sets[1].events), "{| a, b, tock |}");
}

TEST(AlikeBranches, UseTheNameThatASetHasAlready) {
    const Gathered result = gather_branches("a?x -> P(v) [] b?y -> P(v) [] c!v -> P(0)");
    EXPECT_EQ(result.body, "([] e__:others @ e__ -> P(v)) [] c!v -> P(0)");
    EXPECT_EQ(result.sets.size(), 1U);
}

TEST(AlikeBranches, AreThoseWithoutGuardOutputOrUseOfTheirValue) {
    for (const std::string body :
         {"a?x -> P(x) [] b?x -> P(x)", "v > 0 & a?x -> P(v) [] b?x -> P(v)", "c!v -> P(v) [] c!0 -> P(v)",
          "a?x:{0} -> P(v) [] b?x -> P(v)", "a?x -> P(v) [] b?x -> P(v + 1)"})
        EXPECT_EQ(gather_branches(body).body, body);
}

TEST(AlikeBranches, AreFoundAfterGuardsAndPrefixes) {
    EXPECT_EQ(gather_branches("go -> (if v > 0 then a?x -> P(v) [] b?x -> P(v) else STOP)").body,
              "go -> (if v > 0 then [] e__:others @ e__ -> P(v) else STOP)");
}

TEST(AlikeBranches, KeepTheMeaning) {
    const std::string channels = "channel a, b : {0..2}\nchannel c : {0..3}\nchannel tock\n";
    const std::string before =
        "P(v) = v < 3 & c!v -> P(v + 1) [] a?x -> P(v) [] b?y -> P(0) [] tock -> P(v) [] v == 2 & tock -> STOP\n";
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    cspm::Script script = cspm::read(sources, sources.add("t.csp", channels + before), diagnostics);
    std::vector<Function> functions{{"Q", {"v"}, script.decls.back()->body}};
    NameManager names;
    std::vector<NamedSet> sets;
    gather_alike_branches(functions, names, sets);
    ASSERT_EQ(sets.size(), 1U);
    script.decls.push_back(b::value(sets[0].name, sets[0].events));
    script.decls.push_back(b::function_decl("Q", b::variables({"v"}), functions[0].body));
    const auto p = b::call("P", {b::number(0)});
    const auto q = b::call("Q", {b::number(0)});
    script.decls.push_back(b::assert_refines(p, cspm::Model::failures_divergences, q));
    script.decls.push_back(b::assert_refines(q, cspm::Model::failures_divergences, p));
    EXPECT_THAT(testing::decide_script(script), ElementsAre("holds", "holds"));
}

}  // namespace
}  // namespace robochart::csp_emit::alike_branches_test
