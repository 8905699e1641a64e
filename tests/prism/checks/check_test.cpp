// SPDX-License-Identifier: Apache-2.0
// Tests static checks that the pages of the rules do not show.
#include "prism/checks/check.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "prism/syntax/printer.hpp"
#include "tests/prism/support.hpp"

namespace robochart::prism {
namespace {

using ::testing::HasSubstr;
using testing::Read;

struct Checked {
    explicit Checked(const std::string& text) {
        const ModelFile file = read_model(read.sources, read.add(text), read.diagnostics);
        model = check_model(file, read.diagnostics);
    }
    Read read;
    std::optional<CheckedModel> model;
};

/// Returns the modules that synchronise on each action: "a:M+N b:M".
std::string together(const std::string& system) {
    const Checked checked(
        "mdp\n"
        "module M x:[0..1]; [a] true -> true; [b] true -> true; [] true -> true; endmodule\n"
        "module N y:[0..1]; [a] true -> true; [c] true -> true; endmodule\n"
        "module O z:[0..1]; [c] true -> true; endmodule\n" +
        system);
    EXPECT_TRUE(checked.model) << checked.read.report();
    if (!checked.model) return "";
    std::multiset<std::string> acts;
    for (const Synchronisation& synchronisation : checked.model->synchronisations) {
        std::string act = synchronisation.action + ":";
        for (const ActionOfModule& part : synchronisation.parts)
            act += checked.model->modules[part.module].name.text +
                   (part.action == synchronisation.action ? "" : "." + part.action);
        acts.insert(act);
    }
    std::string text;
    for (const std::string& act : acts) text += (text.empty() ? "" : " ") + act;
    return text;
}

/// Returns the findings of a model with actions `go` and `stop`, and additional text.
std::string actions(const std::string& more) {
    const Checked checked(
        "dtmc module M x:[0..1]; [go] x=0 -> (x'=1); [stop] x=1 -> true; [] true -> true; endmodule\n" + more);
    return checked.model ? "" : checked.read.report();
}

TEST(PrismActions, ThatNoCommandHasAreErrorsWithTheNearestName) {
    EXPECT_EQ(actions("rewards [go] true : 1; [] true : 1; true : 1; endrewards"), "");
    EXPECT_THAT(actions("rewards [og] true : 1; endrewards"), HasSubstr("did you mean 'go'?"));
    EXPECT_THAT(actions("rewards [quite_another] true : 1; endrewards"),
                HasSubstr("commands have the actions go, stop"));
    EXPECT_THAT(actions("system M / {stpo} endsystem"), HasSubstr("did you mean 'stop'?"));
    EXPECT_THAT(actions("system M {og<-b} endsystem"), HasSubstr("action 'og' is not declared"));
    EXPECT_THAT(actions("module N y:[0..1]; [go] true -> true; endmodule system M |[goo]| N endsystem"),
                HasSubstr("did you mean 'go'?"));
    // A renaming introduces a new action.
    EXPECT_EQ(actions("system M {go<-walk} / {walk} endsystem rewards [walk] true : 1; endrewards"), "");
}

TEST(PrismComposition, WithoutOneAllActTogetherOnCommonActions) {
    EXPECT_EQ(together(""), ":M a:MN b:M c:NO");
    EXPECT_EQ(together("system M || N || O endsystem"), ":M a:MN b:M c:NO");
}

TEST(PrismComposition, OperatorsOfTheGrammar) {
    EXPECT_EQ(together("system M ||| N ||| O endsystem"), ":M a:M a:N b:M c:N c:O");
    EXPECT_EQ(together("system (M |[a]| N) ||| O endsystem"), ":M a:MN b:M c:N c:O");
    // Both operands must take part in b, and N never offers it.
    EXPECT_EQ(together("system (M |[a,b]| N) || O endsystem"), ":M a:MN c:NO");
    // If a is hidden, the a of M occurs alone and is invisible.
    EXPECT_EQ(together("system (M / {a}) || N || O endsystem"), ":M :M.a a:N b:M c:NO");
    EXPECT_EQ(together("system M {b<-c} || N || O endsystem"), ":M a:MN c:M.bNO");
}

TEST(PrismChecks, FormulasAreExpandedBeforeModulesAreRenamed) {
    const Checked checked(
        "dtmc\nformula high = x>=2;\n"
        "module M x:[0..3]; [] high -> (x'=0); [] !high -> (x'=x+1); endmodule\n"
        "module N = M [ x=y ] endmodule\n");
    ASSERT_TRUE(checked.model) << checked.read.report();
    EXPECT_EQ(print(checked.model->modules[1].commands[0].guard), "y >= 2");
    EXPECT_EQ(checked.model->modules[1].commands[1].branches[0].assignments[0].variable.text, "y");
}

TEST(PrismChecks, FunctionsAndActionsAreRenamed) {
    const Checked checked(
        "dtmc\n"
        "module M x:[0..3]; [a] true -> (x'=min(x+1,3)); endmodule\n"
        "module N = M [ x=y, a=b, min=max ] endmodule\n");
    ASSERT_TRUE(checked.model) << checked.read.report();
    EXPECT_EQ(checked.model->modules[1].commands[0].action.text, "b");
    EXPECT_EQ(print(checked.model->modules[1].commands[0].branches[0].assignments[0].value), "max(y + 1, 3)");
}

/// A mistake in a base module is reported once, not for each renamed copy.
TEST(PrismChecks, MistakesInABaseAreNotRepeated) {
    const Checked checked(
        "dtmc\n"
        "module M x:[0..3]; [] z -> true; endmodule\n"
        "module N = M [ x=y ] endmodule\n");
    EXPECT_EQ(checked.read.findings(), "PRISM-T01:2");
}

TEST(PrismChecks, FormulasThatGrowWithoutEndAreRefused) {
    std::string text = "dtmc\nformula f0 = x+x;\n";
    for (int i = 1; i < 60; ++i)
        text += "formula f" + std::to_string(i) + " = f" + std::to_string(i - 1) + "+f" + std::to_string(i - 1) + ";\n";
    const Checked checked(text + "module M x:[0..1]; [] f59>0 -> true; endmodule\n");
    EXPECT_NE(checked.read.findings().find("PRISM-T18"), std::string::npos) << checked.read.findings();
}

TEST(PrismChecks, LongChainsOfDefinitionsAreInOrder) {
    std::string text = "dtmc\n";
    for (int i = 0; i < 20'000; ++i) text += "const int c" + std::to_string(i) + " = c" + std::to_string(i + 1) + ";\n";
    const Checked checked(text + "const int c20000 = 1;\nmodule M x:[0..c0]; [] true -> true; endmodule\n");
    EXPECT_TRUE(checked.model) << checked.read.report();
}

TEST(PrismChecks, CyclesOfPropertiesAreFound) {
    Checked checked("dtmc\nmodule M x:[0..1]; [] true -> true; endmodule\n");
    const PropertyFile file =
        read_properties(checked.read.sources, checked.read.add("\"a\": \"b\" | x=1;\n\"b\": \"a\";\n", "p.props"),
                        checked.read.diagnostics);
    (void)check_properties(*checked.model, file, checked.read.diagnostics);
    EXPECT_NE(checked.read.findings().find("PRISM-T05"), std::string::npos) << checked.read.findings();
}

TEST(PrismChecks, TypesOfProperties) {
    Checked checked("dtmc\nmodule M x:[0..1]; [] true -> true; endmodule\n");
    const auto findings = [&](const std::string& text) {
        Read read;
        const PropertyFile file = read_properties(read.sources, read.add(text, "p.props"), read.diagnostics);
        (void)check_properties(*checked.model, file, read.diagnostics);
        return read.findings();
    };
    EXPECT_EQ(findings("P=? [ F x=1 ] + 1"), "");
    EXPECT_EQ(findings("P>=0.5 [ F x=1 ] + 1"), "PRISM-T03:1");
    EXPECT_EQ(findings("P=? [ F x ]"), "PRISM-T03:1");
    EXPECT_EQ(findings("P=? [ F P=? [ X x=1 ] ]"), "PRISM-T03:1");
    EXPECT_EQ(findings("filter(sum, x=1)"), "PRISM-T03:1");
    EXPECT_EQ(findings("filter(count, x)"), "PRISM-T03:1");
    EXPECT_EQ(findings("filter(most, x)"), "PRISM-T04:1");
    EXPECT_EQ(findings("P=? [ F<=x x=1 ]"), "PRISM-T06:1");
    EXPECT_EQ(findings("(F x=1) | x=0"), "PRISM-T14:1");
    EXPECT_EQ(findings("\"nothing\""), "PRISM-T01:1");
}

}  // namespace
}  // namespace robochart::prism
