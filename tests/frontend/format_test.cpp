// The house style: what it looks like, and its laws over every text at hand: no word or comment is lost, the model
// stays the same, formatting twice is formatting once, and blanks of the input do not matter.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <random>
#include <sstream>

#include "fixture.hpp"
#include "frontend/format.hpp"
#include "frontend/lexer.hpp"

namespace robochart::frontend {
namespace {

namespace fs = std::filesystem;

/// The formatted text; "" and a failure if there is none.
std::string formatted(const std::string& text, bool is_assertions = false) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics findings;
    const auto source = sources.add(is_assertions ? "t.assertions" : "t.rct", text);
    const auto result = format(sources, source, is_assertions, findings);
    EXPECT_TRUE(result.has_value()) << diagnostics::render_text(sources, findings) << text;
    return result.value_or("");
}

/// The model as read, without the titles of assertions, which are pieces of the text.
std::string meaning(const std::string& text, bool is_assertions) {
    std::istringstream dump(testing::read(text, is_assertions)->dumped());
    std::string out;
    for (std::string line; std::getline(dump, line);)
        if (!line.starts_with("  assertion")) out += line + "\n";
    return out;
}

void expect_laws(const std::string& text, bool is_assertions, const std::string& origin) {
    const std::string once = formatted(text, is_assertions);
    EXPECT_EQ(formatted(once, is_assertions), once) << origin << " is not stable:\n" << text;
    EXPECT_TRUE(same_words(text, once, is_assertions)) << origin;
}

void expect_format(const std::string& text, const std::string& wanted, bool is_assertions = false) {
    EXPECT_EQ(formatted(text, is_assertions), wanted);
    EXPECT_EQ(formatted(wanted, is_assertions), wanted) << "not stable";
}

struct Example {
    std::string origin;
    std::string text;
    bool is_assertions;
};

/// Every construct of the language, with its rarer forms.
const char* const every_construct = R"rct(package A::B::C
import set_toolkit::* import A::D
diagram Main
type Given
datatype P { x:nat y:Seq( real ) }
record Q { p:P } record Empty { }
enumeration E { One Two(nat, Set(E)) Three }
function f(a:nat, b:?X):(nat*nat)->nat <-> real { precondition a > 0 /\ b == b postcondition result == (lambda k:nat|k>1@k+1) }
function g(m:matrix(real,2,3), v:vector(nat,4)):boolean { }
interface I { op(a:nat,b:real) [ terminates ] op2() var v:nat=1,w:Set(nat)={1,2,3} const c:real=-1.5 clock T _broadcast event bc:nat event plain }
robotic platform R { uses I provides J requires A::B::C::K event e:nat*nat }
operation O(a:nat) { terminates precondition a>0 postcondition a<=v+1 requires I initial i final f transition t{from i to f} }
operation Bodiless(){}
stm S { uses I,J requires K
 var ^end:nat = 3
 var s : Seq(nat) = <1,-2,3+4> , r : P = P(|x=1,y=<>|), t : nat*nat = (|1, 2|), b:boolean = ^end==3
 const M : matrix(real,2,2) = [|1,2;3,4|] , N : vector(nat,2) = [|1 , 2|], sets:Set(Set(nat)) = {{ },{1},{2 to 5},{x:nat|x>0/\x<9@x*2},{x:nat}}
 initial i junction j probabilistic p final f
 state A { entry skip ; x.f=1;v[ i ]=2;m[1,2].f = 3;op(1,2);(e!3;e?x;e.(x+1)); wait(1);wait( [ 1 , 2 ] );#T;send e!f(1) <{ 3 }
  during if v>0 then v=v-1;skip else if w then skip end end exit bc[| x = from | x>1 |]!3 ; bc[| to==2 |]?v; bc[| |]; bc[|y=from|]?v
  state Inner { initial i state Deep {} transition t { from i to Deep } } initial i2 transition t2 { from i2 to Inner } }
 transition a { from i to A trigger e?x #T #U <{ 4 } condition x in {1,2} action skip }
 transition b { from A to p trigger bc[| q |]?y condition else }
 transition c { from p to A probability 1/2 action v=1 }
 transition d { from A to A #T condition since(T)>=5 /\ sinceEntry(A::Inner)<3 \/ not (v==1) => true iff false }
 transition e { from A to f condition (forall x:nat,y:nat|x<y@exists1 z:nat@z>x) /\ (exists q:E@q!=E::One) action v=let a==1,b==2@a+b; v = (the x:nat|x>0@x) as nat; b = v is real }
 transition g { from A to f action v = if b then 1 else - - 2 end ; s = s cat <1> ^ <2> ^s; s=inverse(s); s = transpose( M )[1,2]; v = s(1)+(f(1,2))(3) }
 transition h { from A to f condition v in [1,2) /\ v in (0, 3] /\ v in (1,2) /\ v in [0,1] action v = (f)(1) % 2 * 3 / 4 }
}
controller C { opref o = A::O sref s=S stm Own { initial i state z{} transition t{from i to z} } operation P2(){} connection C on e to s on e (_async)[mult] }
module M { robotic platform RP { event e } rref r=R cref c = C controller CC { sref s = S } connection r on e to c on e ( _async ) }
)rct";

const char* const every_assertion = R"txt(package P
import A::*
assertion A1:X is deadlock - free timed assertion A2 : X is not divergence-free.
untimed assertion A3 : X is deterministic in the failures divergences model assertion A4:X is timelock-free in the tick-tock model
assertion A5 : X terminates assertion A6 : X does not terminate assertion A7: X refines Y in the traces model
assertion A8 : X does not refine Y assertion A9 : X equals Y assertion A10 : X is not equal to Y
assertion A11: A::B::S is not reachable in X assertion A12 : clock C is not initialised assertion A13 : clock X::C is initialised
assertion A14: X is deadlock-free in the traces model with constant a of X set to 1+2, parameter p of X::op assigned f(1), and constant z of Q with value R.x.
assertion A15: X is deterministic with constant a of X set to 1 and constant b of X assigned 2 .
timed csp P csp-begin
  P = a -> (* odd *) P   -- text
csp-end csp Q associated to A::B , C csp-begin csp-end
label "l" = x   >  3;
  formula   f = 2;
prob property  P1 :  P=?  [ F  "l" ]
   with constants a   set to 2
rewards "r"   true : 1;
endrewards
assertion A16: X is deterministic
)txt";

void add_examples(std::vector<Example>& examples, const fs::path& folder) {
    if (!fs::is_directory(folder)) return;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        const bool is_assertions = entry.path().extension() == ".assertions";
        if (!entry.is_regular_file() || (!is_assertions && entry.path().extension() != ".rct")) continue;
        Example example{entry.path().string(), testing::slurp(entry.path()), is_assertions};
        if (!testing::read(example.text, is_assertions)->file().has_syntax_errors) examples.push_back(example);
    }
}

/// Every text without syntax errors in the repository and, where it is at hand, beside it.
const std::vector<Example>& examples() {
    static const std::vector<Example> all = [] {
        std::vector<Example> found;
        found.push_back({"every construct", every_construct, false});
        found.push_back({"every assertion", every_assertion, true});
        const fs::path root = ROBOCHART_SOURCE_DIR;
        for (const char* folder : {"corpus", "tests", "frontend/library", "docs"}) add_examples(found, root / folder);
        if (const fs::path shared = testing::shared_folder(); !shared.empty()) {
            add_examples(found, shared / "suite");
            add_examples(found, shared / "bench");
        }
        std::sort(found.begin(), found.end(), [](const Example& a, const Example& b) { return a.origin < b.origin; });
        return found;
    }();
    return all;
}

TEST(Format, KeepsTheLawsOverAllTexts) {
    EXPECT_GT(examples().size(), 100U);
    for (const Example& example : examples()) {
        expect_laws(example.text, example.is_assertions, example.origin);
        EXPECT_EQ(meaning(formatted(example.text, example.is_assertions), example.is_assertions),
                  meaning(example.text, example.is_assertions))
            << example.origin;
    }
}

// ---------------------------------------------------------------- mutations

/// The text with other blanks between its words; `choose` gives what stands in a gap, from what stood there.
template <class Choose>
std::string respaced(const Example& example, Choose choose) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics findings;
    const auto source = sources.add("t", example.text);
    const TokenStream stream = tokenize(sources, source, example.is_assertions, findings);
    std::string out;
    std::size_t end = 0;
    for (const Token& token : stream.tokens) {
        const std::string gap = choose(example.text.substr(end, token.span.begin - end));
        // After a line end these are read differently: no call, no operator `^`.
        const bool one_line = token.is("(") || token.escaped;
        out += one_line && gap.find_first_of("\r\n") != std::string::npos ? " " : gap;
        out += example.text.substr(token.span.begin, token.span.end - token.span.begin);
        end = token.span.end;
    }
    return out;
}

/// Rounds of random mutations: more on request, in search of faults.
int rounds() {
    const char* asked = std::getenv("FORMAT_ROUNDS");
    return asked == nullptr ? 3 : std::atoi(asked);
}

std::string any_gap(std::mt19937& random, const std::string& before) {
    static const std::vector<std::string> gaps = {" ",
                                                  "\n",
                                                  "\t \t",
                                                  "\n\n\n",
                                                  "\r\n",
                                                  " /* c */ ",
                                                  "/**/",
                                                  " // line \n",
                                                  "\n\n// own line\n",
                                                  "\n  /* a\n   * b\n   */\n",
                                                  " /* a\nb */ ",
                                                  "\n/* x */ /* y */",
                                                  "//a\n//b\n\n//c\n",
                                                  " /* p */\n\n",
                                                  "\n\n\t/* q\n\n\tr */ // s  \n"};
    const std::size_t pick = random() % (3 * gaps.size());
    return pick < gaps.size() ? gaps[pick] : pick < 2 * gaps.size() ? " " : before;
}

/// Is the mutant free of syntax errors?
bool expect_laws_if_correct(const Example& mutant) {
    if (testing::read(mutant.text, mutant.is_assertions)->file().has_syntax_errors) return false;
    expect_laws(mutant.text, mutant.is_assertions, mutant.origin);
    EXPECT_EQ(meaning(formatted(mutant.text, mutant.is_assertions), mutant.is_assertions),
              meaning(mutant.text, mutant.is_assertions))
        << mutant.origin;
    return true;
}

/// Names of `.rct` text made longer by up to `longest` letters.
std::string lengthened(const Example& example, std::mt19937& random, std::size_t longest) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics findings;
    const auto source = sources.add("t", example.text);
    std::string out;
    std::size_t end = 0;
    const TokenStream stream = tokenize(sources, source, example.is_assertions, findings);
    for (const Token& token : stream.tokens) {
        out += example.text.substr(end, token.span.end - end);
        end = token.span.end;
        if (token.kind == TokenKind::identifier && !example.is_assertions) out += std::string(random() % longest, 'w');
    }
    return out;
}

TEST(Format, KeepsTheLawsUnderRandomBlanksAndComments) {
    std::mt19937 random(7);
    std::size_t correct = 0;
    std::size_t tried = 0;
    for (const Example& example : examples())
        for (int round = 0; round < rounds() && !HasFailure(); ++round) {
            const auto choose = [&](const std::string& before) { return any_gap(random, before); };
            ++tried;
            if (expect_laws_if_correct({example.origin, respaced(example, choose), example.is_assertions})) ++correct;
        }
    EXPECT_GT(correct, tried / 2) << "most mutants are not models any more";
}

TEST(Format, KeepsTheLawsWithACommentInEveryGap) {
    for (const Example& example : examples())
        for (const char* comment :
             {" /* c */ ", " // c\n", "\n// c\n", "\n/* c */\n", "\n/* c */ ", " /* c */\n", "/* c\nd */"}) {
            const auto choose = [&](const std::string& before) { return before + comment; };
            expect_laws_if_correct({example.origin + comment, respaced(example, choose), example.is_assertions});
            if (HasFailure()) return;
        }
}

/// Names of any length, so that lines break anywhere.
TEST(Format, KeepsTheLawsForLongNames) {
    std::mt19937 random(11);
    for (const Example& example : examples())
        for (const std::size_t longest : {2U, 8U, 30U, 130U}) {
            const Example mutant{example.origin, lengthened(example, random, longest), example.is_assertions};
            expect_laws_if_correct(mutant);
            if (HasFailure()) return;
            const auto choose = [&](const std::string& before) { return any_gap(random, before); };
            expect_laws_if_correct({mutant.origin, respaced(mutant, choose), mutant.is_assertions});
            if (HasFailure()) return;
        }
}

/// Without empty lines and comments the words alone decide.
TEST(Format, DoesNotDependOnBlanksOfTheText) {
    std::size_t compared = 0;
    for (const Example& example : examples()) {
        if (example.text.find("//") != std::string::npos || example.text.find("/*") != std::string::npos) continue;
        const Example joined{example.origin, respaced(example, [](const auto&) { return " "; }), example.is_assertions};
        const Example split{example.origin, respaced(example, [](const auto&) { return "\n"; }), example.is_assertions};
        const auto correct = [](const Example& e) {
            return !testing::read(e.text, e.is_assertions)->file().has_syntax_errors;
        };
        if (!correct(joined) || !correct(split)) continue;
        EXPECT_EQ(formatted(joined.text, joined.is_assertions), formatted(split.text, split.is_assertions))
            << example.origin;
        ++compared;
    }
    EXPECT_GT(compared, 50U);
}

// ---------------------------------------------------------------- what it looks like (docs/format.md)

TEST(Format, TheExampleOfTheDocumentationIsInTheStyle) {
    const std::string page = testing::slurp(fs::path(ROBOCHART_SOURCE_DIR) / "docs/format.md");
    const std::string fence = "```robochart\n";
    const std::size_t begin = page.find(fence) + fence.size();
    const std::string example = page.substr(begin, page.find("```", begin) - begin);
    EXPECT_GT(example.size(), 300U);
    EXPECT_EQ(formatted(example), example);
}

/// The body of a machine `stm S { … }`, without the indentation that it has there.
std::string in_machine(const std::string& body) {
    const std::string text = formatted("stm S {" + body + "}");
    std::istringstream lines(text.substr(0, text.size() - 2));
    std::string out;
    std::string line;
    std::getline(lines, line);
    EXPECT_EQ(line, "stm S {");
    while (std::getline(lines, line)) out += line.substr(std::min<std::size_t>(1, line.size())) + "\n";
    return out;
}

TEST(Format, ShortBodiesStandOnOneLine) {
    EXPECT_EQ(in_machine("state a{ }state b{entry x=1 }initial i transition t{from i to a\n trigger e ? x\n}"),
              "state a {}\nstate b { entry x = 1 }\ninitial i\ntransition t { from i to a trigger e?x }\n");
    EXPECT_EQ(formatted("enumeration E{A\nB(nat,int)}"), "enumeration E { A B(nat, int) }\n");
}

TEST(Format, StatesWithSeveralPartsHaveOneALine) {
    EXPECT_EQ(in_machine("state a{initial i state b{} }"), "state a {\n\tinitial i\n\tstate b {}\n}\n");
}

TEST(Format, LongTransitionsHaveAClauseALine) {
    EXPECT_EQ(in_machine("transition t { from Somewhere to SomewhereElse trigger e?value #T #U <{3} condition "
                         "value > 3 action x = 1; y = 2 }"),
              "transition t {\n\tfrom Somewhere to SomewhereElse\n\ttrigger e?value #T #U <{ 3 }\n"
              "\tcondition value > 3\n\taction x = 1; y = 2\n}\n");
}

TEST(Format, ColumnsDecide) {
    // A body that ends in column 80 (a tab counts 4) stands on one line, in column 81 not.
    const std::string fits = "\ttransition t { from i to a condition " + std::string(37, 'x') + " }\n";
    expect_format("stm S {\n" + fits + "}\n", "stm S {\n" + fits + "}\n");
    expect_format("stm S { transition t { from i to a condition " + std::string(38, 'x') + " } }",
                  "stm S {\n\ttransition t {\n\t\tfrom i to a\n\t\tcondition " + std::string(38, 'x') + "\n\t}\n}\n");
    // A line that ends in column 120 is not broken, in column 121 it is. An umlaut in a string is one column.
    const std::string line = "var v : nat = \"ä\" + " + std::string(92, 'y');
    EXPECT_EQ(in_machine(line + " + 1"), line + " + 1\n");
    EXPECT_EQ(in_machine(line + " + 12"), "var v : nat = \"ä\"\n\t+ " + std::string(92, 'y') + "\n\t+ 12\n");
}

TEST(Format, LongExpressionsBreakWhereTheyBindWeakest) {
    const std::string a(30, 'a');
    EXPECT_EQ(in_machine("var v : boolean = " + a + "+1 == " + a + " /\\ " + a + " > 2*" + a + "/\\ b"),
              "var v : boolean = " + a + " + 1 == " + a + "\n\t/\\ " + a + " > 2 * " + a + "\n\t/\\ b\n");
    EXPECT_EQ(in_machine("var v : nat = f(" + a + "," + a + "," + a + "," + a + ")"),
              "var v : nat = f(\n\t" + a + ",\n\t" + a + ",\n\t" + a + ",\n\t" + a + "\n)\n");
}

TEST(Format, LongActionsHaveAStatementALine) {
    const std::string a(50, 'a');
    EXPECT_EQ(in_machine("state s { entry " + a + "(1); " + a + "(2); x = 1 }"),
              "state s {\n\tentry\n\t\t" + a + "(1);\n\t\t" + a + "(2);\n\t\tx = 1\n}\n");
    EXPECT_EQ(in_machine("state s { entry if b then " + a + "(1) else " + a + "(2) end }"),
              "state s {\n\tentry\n\t\tif b then\n\t\t\t" + a + "(1)\n\t\telse\n\t\t\t" + a + "(2)\n\t\tend\n}\n");
}

TEST(Format, EmptyLinesAreKeptOnceAndSetComponentsOff) {
    expect_format("\n\npackage p\n\n\n\nimport q::*\ninterface I {\n\n event e\n\n\n event f\n\n}\ntype T\ntype U\n",
                  "package p\n\nimport q::*\n\ninterface I {\n\tevent e\n\n\tevent f\n}\n\ntype T\ntype U\n");
}

TEST(Format, SpellingIsKept) {
    EXPECT_EQ(in_machine("var ^end : Seq(nat) = ((<007,1.50>))cat<>  var s : Seq(nat) = a ^ b ^c\n var t : nat = - -1"),
              "var ^end : Seq(nat) = ((<007, 1.50>)) cat <>\nvar s : Seq(nat) = a ^ b ^c\nvar t : nat = --1\n");
    expect_format("record R { } datatype D { }", "record R {}\ndatatype D {}\n");
}

TEST(Format, WordsThatWouldMergeStayApart) {
    EXPECT_EQ(
        in_machine("var a : boolean = Set (x) var b : Seq(Set(nat)) = < {1} > var c : Seq(Set(nat)) = <{1},{2 to 3}>"),
        "var a : boolean = Set (x)\nvar b : Seq(Set(nat)) = < {1}>\nvar c : Seq(Set(nat)) = <{1}, {2 to 3}>\n");
}

TEST(Format, CommentsStayAtTheirPlaces) {
    expect_format(
        "// head\nstm S{// opens\n//first\n\n\n/* of\n   two */ initial i //behind\n"
        "transition t{from i/* a */to/* b */x//c\n// own\ncondition f(/* d */1)}\n// last\n}//closes\n// end",
        "// head\nstm S { // opens\n\t//first\n\n\t/* of\n\t   two */ initial i //behind\n"
        "\ttransition t {\n\t\tfrom i /* a */ to /* b */ x //c\n\t\t// own\n\t\tcondition f(/* d */ 1)\n\t}\n\t// "
        "last\n"
        "} //closes\n// end\n");
    expect_format("// alone", "// alone\n");
}

TEST(Format, BlockCommentsMoveAsAWhole) {
    expect_format("stm S {\n      /* a\n         b\n      c */\n      initial i\n}\n",
                  "stm S {\n\t/* a\n\t   b\n\tc */\n\tinitial i\n}\n");
    expect_format("stm S {\n      /* a\n  b */\n      initial i\n}\n", "stm S {\n\t/* a\n  b */\n\tinitial i\n}\n");
}

TEST(Format, AssertionFiles) {
    expect_format("assertion  A:X is deadlock - free .timed assertion B : X refines Y in the tick-tock model",
                  "assertion A : X is deadlock-free.\ntimed assertion B : X refines Y in the tick-tock model\n", true);
}

TEST(Format, VerbatimPartsStayToTheByte) {
    expect_format(
        "csp   P  csp-begin\r\n  P =  a ->  P  \n\n\n csp-end\n  label   \"l\" =  x \n  >  3;\nassertion A:X "
        "terminates",
        "csp P csp-begin\r\n  P =  a ->  P  \n\n\n csp-end\nlabel   \"l\" =  x \n  >  3;\nassertion A : X terminates\n",
        true);
}

TEST(Format, LineEndsAndByteOrderMarks) {
    expect_format("type A\r\n\r\n/* x\r\n y */\r\ntype B", "type A\r\n\r\n/* x\r\n y */\r\ntype B\r\n");
    expect_format("type A\r\ntype B\n", "type A\ntype B\n");
    expect_format("type A\rtype B\r", "type A\ntype B\n");
    expect_format("\xEF\xBB\xBFtype A", "\xEF\xBB\xBFtype A\n");
    expect_format("", "");
    expect_format(" \n\n", "");
}

TEST(Format, TextsWithSyntaxErrorsAreLeftAlone) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics findings;
    const auto source = sources.add("t.rct", "stm S { state }");
    EXPECT_FALSE(format(sources, source, false, findings).has_value());
    EXPECT_EQ(findings.errors(), 1U);
}

TEST(Format, SameWordsSeesEveryDifference) {
    const std::string text = "type A // c\ntype B";
    EXPECT_TRUE(same_words(text, "type A   // c  \n\n type\nB", false));
    for (const char* other :
         {"type A // c", "type A // d\ntype B", "type A type B", "type A type ^B // c", "// c\ntype A type BB"})
        EXPECT_FALSE(same_words(text, other, false)) << other;
    EXPECT_TRUE(same_words("/* a\n  b */", "/* a\n\t b */", false));
    EXPECT_FALSE(same_words("/* a b */", "/* a\n b */", false));
    EXPECT_FALSE(same_words("// a  b", "// a b", false));
}

std::string machines(std::size_t count) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i) {
        const std::string n = std::to_string(i);
        text += "stm S" + n +
                "{ var x : nat = 1 // c\n initial i state a { entry x=x+1 ; e!(x) }\ntransition t { from i to a }\n" +
                "transition u {from a to a trigger f?x condition x>1 /\\ x<(2+3)*4 \\/ g(x, x, 2) action x = x*2 ; e!x "
                "}\n}\n";
    }
    return text;
}

TEST(Format, TakesLinearTime) {
    const auto seconds = [](const std::string& text) {
        const auto start = std::chrono::steady_clock::now();
        EXPECT_FALSE(formatted(text).empty());
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    const double small = seconds(machines(1'000));  // 5,000 lines
    const double large = seconds(machines(10'000));
    EXPECT_LT(large, 25 * small + 0.5);
    EXPECT_LT(large, 10);
}

TEST(Format, DeepNestingIsFine) {
    const auto wrapped = [](std::size_t depth, const std::string& open, const std::string& close) {
        std::string text = "const c : nat = ";
        for (std::size_t i = 0; i < depth; ++i) text += open;
        text += "1";
        for (std::size_t i = 0; i < depth; ++i) text += close;
        return "interface I { " + text + " }";
    };
    expect_laws(wrapped(200, "(", ")"), false, "parentheses");
    expect_laws(wrapped(200, "f(1, ", ")"), false, "calls");
    expect_laws(wrapped(900, "1 + ", ""), false, "sum");
    expect_laws(wrapped(200, "if b then 2 else ", " end"), false, "if");
    expect_laws(wrapped(200, "- ", ""), false, "minus");
}

}  // namespace
}  // namespace robochart::frontend
