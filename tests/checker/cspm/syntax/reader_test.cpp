// SPDX-License-Identifier: Apache-2.0
// Tests precedence, layout and limits of the parser. The expected trees follow from FDR's grammar (levels.hpp).
#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "checker/cspm/syntax/build.hpp"
#include "tests/checker/cspm/support.hpp"
#include "tests/temporary_folder.hpp"

namespace robochart::cspm::test {
namespace {

using namespace build;

ExprPtr body_of(const std::string& text) {
    Reading reading("x = " + text + "\n");
    EXPECT_TRUE(reading.ok()) << text << "\n" << reading.report();
    return reading.script.decls.empty() ? nullptr : reading.script.decls[0]->body;
}

void expect_tree(const std::string& text, const ExprPtr& expected) {
    const ExprPtr found = body_of(text);
    EXPECT_TRUE(equal(found, expected)) << text << " was read as " << (found ? print(found) : "nothing");
}

const ExprPtr a = name("a"), b = name("b"), c = name("c"), P = name("P"), Q = name("Q"), R = name("R");

TEST(ReaderTest, ValueOperatorsBindAsInFdr) {
    expect_tree("a + b * c", binary(ExprKind::plus, a, binary(ExprKind::times, b, c)));
    expect_tree("a - b - c", binary(ExprKind::minus, binary(ExprKind::minus, a, b), c));
    expect_tree("-a + b", binary(ExprKind::plus, negate(a), b));
    expect_tree("-a * b", negate(binary(ExprKind::times, a, b)));
    expect_tree("not a == b and c", binary(ExprKind::logical_and, logical_not(binary(ExprKind::equal, a, b)), c));
    expect_tree("a or b and c", binary(ExprKind::logical_or, a, binary(ExprKind::logical_and, b, c)));
    expect_tree("a.b + c", dot({a, binary(ExprKind::plus, b, c)}));
}

TEST(ReaderTest, ProcessOperatorsBindAsInFdr) {
    expect_tree("a -> P [] b -> Q", choice({prefix(a, P), prefix(b, Q)}));
    expect_tree("a -> P ; Q", sequential({prefix(a, P), Q}));
    expect_tree("P [] Q |~| R", internal_choice({choice({P, Q}), R}));
    expect_tree("P /\\ Q [] R", choice({interrupt(P, Q), R}));
    expect_tree("P ; Q /\\ R", interrupt(sequential({P, Q}), R));
    expect_tree("a & b -> P", guard(a, prefix(b, P)));
    expect_tree("P ||| Q \\ {a}", hide(interleave({P, Q}), set({a})));
    expect_tree("P \\ {a} ||| Q", interleave({hide(P, set({a})), Q}));
    expect_tree("a -> P \\ {a}", hide(prefix(a, P), set({a})));
    expect_tree("a -> P [[ a <- b ]]", prefix(a, rename(P, {{a, b}})));
    expect_tree("P [| {a} |] Q [] R", parallel(P, set({a}), choice({Q, R})));
    expect_tree("P [| {a} |> Q", exception(P, set({a}), Q));
    expect_tree("P [ a || b ] Q", alphabetised(P, a, b, Q));
}

TEST(ReaderTest, BackslashIsLambdaOrHiding) {
    expect_tree("\\ x @ x", lambda({variable("x")}, name("x")));
    expect_tree("P \\ a", hide(P, a));
    expect_tree("\\ x @ P \\ a", lambda({variable("x")}, hide(P, a)));
}

TEST(ReaderTest, GreaterThanClosesTheSequenceItStandsIn) {
    expect_tree("<a, b> > <c>", binary(ExprKind::greater, sequence({a, b}), sequence({c})));
    expect_tree(
        "<x | x <- a, (x > b)>",
        sequence_comprehension({name("x")}, {generator("x", a), condition(binary(ExprKind::greater, name("x"), b))}));
    expect_tree(
        "<x | x <- a, x<b>",
        sequence_comprehension({name("x")}, {generator("x", a), condition(binary(ExprKind::less, name("x"), b))}));
    EXPECT_FALSE(Reading("x = <y | y <- a, y > b>\n").ok());
}

TEST(ReaderTest, FieldsOfAPrefix) {
    expect_tree("a.b?x!c$y:P -> Q",
                prefix(dot({a, b}), {input("x"), output(c), nondeterministic(variable("y"), P)}, Q));
    expect_tree("a?x.y:P!b.c -> Q",
                prefix(a, {input(dot_pattern({variable("x"), variable("y")}), P), output(dot({b, c}))}, Q));
}

TEST(ReaderTest, ReplicatedFormsReachFarRight) {
    const std::vector<Clause> clauses{generator("i", a)};
    expect_tree("[] i:a @ P [] Q", replicated(ExprKind::replicated_external, clauses, choice({P, Q})));
    expect_tree("|| i:a @ [b] P ||| Q", interleave({replicated(ExprKind::replicated_alphabetised, clauses, P, b), Q}));
    expect_tree("[| b |] i:a @ P", replicated(ExprKind::replicated_parallel, clauses, P, b));
    expect_tree("; i:a @ P", replicated(ExprKind::replicated_sequential, clauses, P));
}

TEST(ReaderTest, BraceMinusOpensACommentUnlessSpaced) {
    expect_tree("{ -2..2}", set_range(negate(number(2)), number(2)));
    EXPECT_EQ(print(set_range(number(-2), number(2))), "{ -2..2}");
    EXPECT_EQ(Reading("x = {-2..2}\n").code(), "CSPM-P03");
}

TEST(ReaderTest, LineEndsVanishBesideOperatorsOnly) {
    expect_tree("P\n  [] Q", choice({P, Q}));
    expect_tree("P []\n  Q", choice({P, Q}));
    expect_tree("a ->\n-- comment\n  P", prefix(a, P));
    EXPECT_FALSE(Reading("x = f\n(a)\n").ok());
    EXPECT_FALSE(Reading("x = a\n  - b\n").ok());
}

TEST(ReaderTest, ErrorsAreLocalToTheirDeclaration) {
    const Reading reading("x = (\ny = 1\nz = ) 2\nw = 3\n");
    EXPECT_FALSE(reading.ok());
    ASSERT_FALSE(reading.script.decls.empty());
    EXPECT_TRUE(equal(reading.script.decls.back()->body, number(3)));
}

TEST(ReaderTest, DeepNestingIsRefusedNotFatal) {
    for (const char* part : {"(", "-", "<", "{", "\\ x @ ", "if ", "f(", "let x = ", "not ", "[] x:"}) {
        std::string text = "x = ";
        for (int i = 0; i < 10000; ++i) text += part;
        EXPECT_FALSE(Reading(text + "1\n").ok()) << part;
    }
    std::string chain = "x = 1";
    for (int i = 0; i < 100000; ++i) chain += " + 1";
    EXPECT_EQ(Reading(chain + "\n").code(), "CSPM-P07");
    std::string types = "f :: ";
    for (int i = 0; i < 100000; ++i) types += "{";
    EXPECT_FALSE(Reading(types + "\nf = 1\n").ok());
    std::string pattern = "f(";
    for (int i = 0; i < 100000; ++i) pattern += "(";
    EXPECT_FALSE(Reading(pattern + "\n").ok());
    std::string modules;
    for (int i = 0; i < 10000; ++i) modules += "module M\n";
    EXPECT_FALSE(Reading(modules).ok());
}

TEST(ReaderTest, BytesOfAnyKindAreRefusedWithAPlace) {
    std::string text;
    for (int i = 0; i < 4096; ++i) text.push_back(static_cast<char>((i * 7919 + i / 256) & 0xff));
    EXPECT_FALSE(Reading(text).ok());
    EXPECT_FALSE(Reading(std::string("x = \0 1\n", 8)).ok());
    EXPECT_TRUE(Reading("").ok());
    EXPECT_TRUE(Reading("\n\n-- only a comment").ok());
}

struct Broken {
    const char* text;
    const char* code;
};

TEST(ReaderTest, EveryRuleHasItsText) {
    for (const Broken& script :
         {Broken{"x = \n", "CSPM-P01"}, Broken{"x = ` 1\n", "CSPM-P02"}, Broken{"{- a", "CSPM-P03"},
          Broken{"x = \"a\n", "CSPM-P04"}, Broken{"x = 99999999999999999999\n", "CSPM-P05"},
          Broken{"assert P :[happy]\n", "CSPM-P06"}, Broken{"x = a == b == c\n", "CSPM-P08"},
          Broken{"x = P [|a|] Q [|b|] R\n", "CSPM-P08"}, Broken{"x = let channel c\nwithin 1\n", "CSPM-P09"},
          Broken{"f :: Int\n", "CSPM-P10"}, Broken{"f :: Int\nf :: Int\nf = 1\n", "CSPM-P11"},
          Broken{"f :: Int -> Int\nf(x) = 1\n", "CSPM-P12"},
          Broken{"assert P [T= Q :[tau priority]: {} :[tau priority]: {}\n", "CSPM-P13"},
          Broken{"include foo\n", "CSPM-P14"}}) {
        EXPECT_EQ(Reading(script.text).code(), script.code) << script.text;
    }
}

TEST(ReaderTest, IncludesAreReadOnceAPlaceAndCyclesRefused) {
    const tests::TemporaryFolder folder;
    folder.write("a.csp", "include \"b.csp\"\nx = y\n");
    folder.write("b.csp", "y = 1\n");
    folder.write("c.csp", "include \"d.csp\"\n");
    folder.write("d.csp", "include \"c.csp\"\n");
    const auto codes = [&](const char* file) {
        diagnostics::SourceManager sources;
        diagnostics::Diagnostics found;
        const Script script = read_file(sources, folder.in(file), found);
        const auto all = found.sorted_findings();
        return all.empty() ? std::to_string(script.decls.size()) : std::string(all[0].rule->code);
    };
    EXPECT_EQ(codes("a.csp"), "2");
    EXPECT_EQ(codes("c.csp"), "CSPM-P16");
    EXPECT_EQ(codes("missing.csp"), "CSPM-P15");
}

/// Returns the code of the finding in a chain of files, or the number of declarations. The caller provides the texts,
/// so no file is on disk. Files are numbered 0, 1, …, and each file includes the next one the given number of times.
std::string code_of_chain(std::size_t files, std::size_t times) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics found;
    const Script script = read_file(sources, "0", found,
                                    [&](const std::string& path, std::string&) -> std::optional<diagnostics::SourceId> {
                                        const std::size_t next = std::stoull(path) + 1;
                                        std::string text = next < files ? "" : "x = 1\n";
                                        for (std::size_t i = 0; i < times && next < files; ++i)
                                            text += "include \"" + std::to_string(next) + "\"\n";
                                        return sources.add(path, text);
                                    });
    const auto all = found.sorted_findings();
    EXPECT_LE(all.size(), 1U) << "it is said once";
    return all.empty() ? std::to_string(script.decls.size()) : std::string(all[0].rule->code);
}

TEST(ReaderTest, IncludesAreBoundedInDepthAndNumber) {
    EXPECT_EQ(code_of_chain(200, 1), "1");
    EXPECT_EQ(code_of_chain(201, 1), "CSPM-P15") << "deeper than 200";
    EXPECT_EQ(code_of_chain(13, 2), "4096") << "8,191 files";
    EXPECT_EQ(code_of_chain(60, 2), "CSPM-P15") << "2^60 files";
}

}  // namespace
}  // namespace robochart::cspm::test
