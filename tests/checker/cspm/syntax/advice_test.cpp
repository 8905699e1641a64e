// SPDX-License-Identifier: Apache-2.0
// Tests the advice on common mistakes in scripts, which is a note on the finding.
#include "checker/cspm/syntax/advice.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <utility>

#include "checker/cspm/syntax/reader.hpp"
#include "checker/cspm/types/type_check.hpp"

namespace robochart::cspm {
namespace {

using ::testing::HasSubstr;

/// Reads a script and stores its first finding.
struct FirstFinding {
    std::string code, message, note;
};

FirstFinding first_finding(const std::string& text) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    const auto source = sources.add("t.csp", text);
    const Script script = read(sources, source, diagnostics);
    if (diagnostics.ok()) check_types(script, diagnostics);
    if (diagnostics.sorted_findings().empty()) return {};
    const diagnostics::Diagnostic finding = diagnostics.sorted_findings().front();
    std::string arguments;
    for (const std::string& argument : finding.arguments) arguments += argument + ";";
    return {std::string(finding.rule->code), arguments, finding.notes.empty() ? "" : finding.notes.front().message};
}

struct Mistake {
    const char* text;
    const char* note;
};

const Mistake mistakes[] = {
    {"// hello\nchannel a\n", "a comment begins with `--`"},
    {"channel a\nP = a <- STOP\n", "a prefix is written `a -> P`"},
    {"channel a : {0..1}\nP = a!1 => STOP\n", "a prefix is written `a -> P`"},
    {"channel a : {0..1}\nP = a!1 = STOP\n", "a prefix is written `a -> P`"},
    {"S = {x | x -> {1,2}}\n", "`x <- S` draws a variable from a set"},
    {"P(x) = if x = 1 then STOP else SKIP\n", "`==` compares values"},
    {"P(x) = if (x = 1) then STOP else SKIP\n", "`==` compares values"},
    {"S = {x | x <- {1..3}, x = 2}\n", "`==` compares values"},
    {"S = <x | x <- <1..3>, x = 2>\n", "`==` compares values"},
    {"channel a : {-2..2}\nP = STOP\n", "written `{ -2..2}`"},
    {"datatype Food = rice | feij\xC3\xA3o\n", "write 'feijao'"},
    {"channel a\nP = a \xE2\x86\x92 STOP\n", "write `->`"},
    {"P(x) = if x <> 1 then STOP else SKIP\n", "`!=` tests whether two values differ"},
    {"P(x) = if x == 1 || x == 2 then STOP else SKIP\n", "`or` joins conditions"},
    {"P(x) = if x == 1 && x == 2 then STOP else SKIP\n", "`and` joins conditions"},
    {"P(x) = if !x then STOP else SKIP\n", "`not` negates a condition"},
    {"channel a\nP(x) = if x > 0 then a -> STOP\nQ = STOP\n", "`if C then A else B`"},
    {"channel a\nP = let x = 1\nQ = STOP\n", "this `let` has no `within`"},
    {"P = STOP within STOP\n", "needs a `let` before it"},
    {"P = STOP else SKIP\n", "`else` needs a complete `if C then A`"},
    {"channel a\nP a -> STOP\nQ = STOP\n", "`NAME = EXPRESSION`"},
    {"P = STOP\nassert P T= P\n", "`P [T= Q`"},
    {"P = STOP\nassert P deadlock free\n", "`P :[deadlock free]`"},
    {"P = STOP\nassert P [T P\n", "written `[T=`"},
    {"P = STOP\nassert P [FDR= P\n", "written `[T=`"},
    {"P = STOP || STOP\n", "`P ||| Q` runs processes in parallel"},
    {"channel a\nP = STOP [a] STOP\n", "`P [|A|] Q` runs processes in parallel"},
    {"channel a : {0..1}\nP = a!1; P\n", "`;` separates two processes"},
    {"channel a\nP = a -> P | STOP\n", "a choice is written `P [] Q`"},
    {"datatyp T = A | B\n", "did you mean 'datatype'?"},
    {"P = STOP\nasert P [T= P\n", "did you mean 'assert'?"},
    {"P(x) = if x == 1 then STOP esle SKIP\n", "did you mean 'else'?"},
    {"P = STOP\nassert P :[deadlock freee]\n", "did you mean 'deadlock free'?"},
    {"channel c : Int, d : Int\n", "each `channel` line"},
    {"channel a\nP = a -> STOP\n/* c */\n", "a comment begins with `--`"},
    {"# c\nchannel a\n", "`include"},
    {"chan a\n", "`channel NAME`"},
    {"event a\n", "`channel NAME`"},
    {"process P = STOP\n", "without a keyword"},
    {"enum T { A, B }\n", "`datatype T = A | B`"},
    {"datatype T = A, B\n", "`|` separates the constructors"},
    {"import x\n", "`include"},
    {"P = STOP\nP [T= STOP\n", "begins with `assert`"},
    {"P = STOP\nP [F= STOP\n", "begins with `assert`"},
    {"P = STOP\nP [FD= STOP\n", "begins with `assert`"},
    {"P n = STOP\n", "`P(x) = ...`"},
    {"P(n) = if n == 1 then STOP elseif n == 2 then SKIP else STOP\n", "did you mean 'else'?"},
    {"P(n) = if n == 1 then STOP elif n == 2 then SKIP else STOP\n", "`else if C then A else B`"},
    {"P(n) = (if n == 1 then STOP else SKIP endif)\n", "without another word"},
    {"P(n) = when n == 1 STOP\n", "`C & P`"},
    {"P(n) = (case n of 1 -> STOP)\n", "`P(0) = A`"},
    {"channel a\nP = a -> STOP [ ] a -> STOP\n", "without a space"},
    {"channel a : 0..2\n", "`{0..2}`"},
    {"channel a : {0,..,2}\n", "`{0..2}`"},
    {"P(n) = n =< 2 & STOP\n", "`<=`"},
    {"P(n) = n <> 2 & STOP\n", "`!=` tests whether two values differ"},
    {"P(n) = Q(n mod 2)\n", "`%` is the remainder"},
    {"P(n) = Q(n div 2)\n", "`/` divides integers"},
    {"N = 3;\nP(n) = STOP\n", "needs no `;` before it"},
    {"P(n : Int) = STOP\n", "parameters have no types"},
    {"channel a : {0..2}\nP = a?x in {1} -> STOP\n", "`a?x:S -> P`"},
    {"channel a, b\nP = STOP[[a -> b]]\n", "`P[[a <- b]]`"},
    {"channel c Int\n", "after a `:`"},
    {"channel c {0..2}\n", "after a `:`"},
    {"channel a\nP = a -> STOP()\n", "without parentheses"},
    // Misspelt names.
    {"channel a : Int\nP(count) = a.coutn -> STOP\n", "did you mean 'count'?"},
    {"module M\n Process = STOP\nexports\n Public = Process\nendmodule\nQ = M::Pubilc\n", "did you mean 'M::Public'?"},
    {"module M\n Process = STOP\nexports\n Public = Process\nendmodule\nQ = Public\n", "did you mean 'M::Public'?"},
    {"module M\nexports\n channel moveCall\nendmodule\nQ = M::move -> STOP\n", "did you mean 'M::moveCall'?"},
    {"module M\nexports\n module N\n exports\n  channel light\n endmodule\nendmodule\nQ = N::light -> STOP\n",
     "did you mean 'M::N::light'?"},
    {"module M\nexports\n module N\n exports\n  channel light\n endmodule\nendmodule\nQ = M::N::lihgt -> STOP\n",
     "did you mean 'M::N::light'?"},
    {"channel beep\nmodule M\nexports\n channel light\nendmodule\nQ = M::beep -> STOP\n", "did you mean 'beep'?"},
    {"channel c : Bool\nQ = c -> STOP\n", "followed by `.` and a value of Bool"},
    {"Q = STPO\n", "did you mean 'STOP'?"},
    {"Q = cadr({1})\n", "did you mean 'card'?"},
    {"channel a : int\n", "did you mean 'Int'?"},
    {"Q = Stop\n", "did you mean 'STOP'?"},
    {"Q = skip\n", "did you mean 'SKIP'?"},
};

TEST(ScriptAdvice, SaysWhatIsProbablyMeant) {
    for (const Mistake& mistake : mistakes) {
        const FirstFinding found = first_finding(mistake.text);
        EXPECT_THAT(found.note, HasSubstr(mistake.note)) << mistake.text << found.code << " " << found.message;
    }
}

TEST(ScriptAdvice, EveryRowIsGivenForSomeMistake) {
    std::set<std::string> given;
    for (const Mistake& mistake : mistakes) given.insert(first_finding(mistake.text).note);
    for (const diagnostics::Advice& row : all_advice()) {
        EXPECT_TRUE(given.contains(std::string(row.advice))) << row.expected << " " << row.words;
        EXPECT_FALSE(row.advice.ends_with('.')) << row.advice;
    }
}

TEST(ScriptAdvice, PointsAtABracketThatIsNotClosed) {
    for (const auto& [text, bracket] : {std::pair("A = { 1, {2}\n", "'{'"), std::pair("A = (1 + (2)\nB = 1\n", "'('"),
                                        std::pair("channel a\nA = {| a\n", "'{|'")})
        EXPECT_THAT(first_finding(text).note, HasSubstr(std::string("this ") + bracket + " is not closed")) << text;
}

TEST(ScriptAdvice, SaysNothingWhereNothingIsKnown) {
    EXPECT_EQ(first_finding("P = [\n").note, "");
    EXPECT_EQ(first_finding("Q = zzzzzz\n").note, "");
}

}  // namespace
}  // namespace robochart::cspm
