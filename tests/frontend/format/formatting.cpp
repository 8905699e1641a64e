// SPDX-License-Identifier: Apache-2.0
#include "formatting.hpp"

#include <algorithm>
#include <sstream>

#include "frontend/format/format.hpp"
#include "frontend/syntax/lexer.hpp"
#include "tests/frontend/fixture.hpp"
#include "tests/random_models/syntax/structure.hpp"
#include "tests/rounds.hpp"
#include "tests/source_folder.hpp"

namespace robochart::frontend::testing {

namespace fs = std::filesystem;

namespace {

/// Every construct of the language, including rare forms.
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
assertion A1:X is deadlock-free timed assertion A2 : X is not divergence-free.
untimed assertion A3 : X is deterministic in the failures divergences model assertion A4:X is timelock-free in the tick-tock model
assertion A5 : X terminates assertion A6 : X does not terminate assertion A7: X refines Y in the traces model
assertion A8 : X does not refine Y assertion A9 : X equals Y assertion A10 : X is not equal to Y
assertion A11: A::B::S is not reachable in X assertion A12 : clock C is not initialised assertion A13 : clock X::C is initialised assertion A14 : event e is not missed in X::S   for 3  time units
assertion A14: X is deadlock-free in the traces model with constant a of X set to 1+2, parameter p of X::op assigned f(1), and constant z of Q with value R.x.
assertion A15: X is deterministic with constant a of X set to 1 and constant b of X assigned 2 .
timed csp P csp-begin
  P = a -> (* odd *) P   -- text
csp-end csp Q associated to A::B , C csp-begin csp-end
label "l" = x   >  3;
  formula   f = 2
prob property  P1 : Prob  min  =? of [Finally <= 3 #l]  using sim with  CI at alpha = 0.1,n=3, and w=1
   with constants a   set to 2 , and b from set{1 to 3 by step 1} with cmdoptions "-x   y"
prob property P2:Reward{r}>=1 of[Cumul 3]\/ not a Until [1,2] M::s is  in M::s::S /\ Forall[Weak Until @m::n::v==$f]
prob generate  path Q:using simulation for deadlock with 3 repeats up to 9 steps
rewards "r"   true : 1;
endrewards
rewards r=[a::e . in]true:1;
[]x>1 :2 ; endrewards
defs D:pfunction f(x,y)={return $$x+&g(1)} poperation o()={(y=1)}
pmodules m : pmodule n{v:[-1 to 2]init 0;w:bool; // of m
 [a::e.out]@v==1->(0.5:@v=2)&(@m::n::v= - 1); [] w -> skip ; /* end */ }
assertion A16: X is deterministic
)txt";

void add_examples(std::vector<Example>& examples, const fs::path& folder) {
    if (!fs::is_directory(folder)) return;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        const bool is_assertions = entry.path().extension() == ".assertions";
        if (!entry.is_regular_file() || (!is_assertions && entry.path().extension() != ".rct")) continue;
        const Example example{entry.path().string(), read_contents(entry.path()), is_assertions};
        if (is_correct(example)) examples.push_back(example);
    }
}

/// Adds the examples on the pages of the rules, which are fenced blocks.
void add_pages(std::vector<Example>& examples, const fs::path& folder) {
    for (const auto& entry : fs::directory_iterator(folder)) {
        std::istringstream page(read_contents(entry.path()));
        std::string language;
        std::string text;
        std::size_t number = 0;
        for (std::string line; std::getline(page, line);) {
            if (!line.starts_with("```")) {
                text += line + "\n";
                continue;
            }
            const bool closes = !language.empty() && line == "```";
            const bool is_assertions = language.starts_with("assertions");
            const Example example{entry.path().string() + " " + std::to_string(++number), text, is_assertions};
            const bool model = language.starts_with("robochart") || is_assertions;
            if (closes && model && is_correct(example)) examples.push_back(example);
            language = closes ? "" : line.substr(3);
            text.clear();
        }
    }
}

/// The words of a text, and the objects to which they refer.
struct Words {
    explicit Words(const Example& example) {
        stream = tokenize(sources, sources.add("t", example.text), example.is_assertions, findings);
    }

    diagnostics::SourceManager sources;
    diagnostics::Diagnostics findings;
    TokenStream stream;
};

std::string any_gap(random_models::Random& random, std::string_view before) {
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
    if (random.chance(34)) return random.pick(gaps);
    return random.chance(50) ? " " : std::string(before);
}

}  // namespace

const std::vector<Example>& examples() {
    static const std::vector<Example> all = [] {
        std::vector<Example> found = {{"every construct", every_construct, false},
                                      {"every assertion", every_assertion, true}};
        const fs::path root = tests::source_folder();
        for (const char* folder : {"corpus", "tests", "frontend/toolkits/library", "docs"})
            add_examples(found, root / folder);
        add_pages(found, root / "docs/rules");
        if (const fs::path shared = shared_folder(); !shared.empty()) {
            add_examples(found, shared / "suite");
            add_examples(found, shared / "bench");
        }
        std::ranges::sort(found, [](const Example& a, const Example& b) { return a.origin < b.origin; });
        if (!tests::sanitized) return found;
        std::vector<Example> sample;  // the laws take ten times as long under AddressSanitizer
        for (std::size_t i = 0; i < found.size(); i += 8) sample.push_back(std::move(found[i]));
        return sample;
    }();
    return all;
}

std::string formatted(const std::string& text, bool is_assertions) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics findings;
    const auto source = sources.add(is_assertions ? "t.assertions" : "t.rct", text);
    const auto result = format(sources, source, is_assertions, findings);
    EXPECT_TRUE(result.has_value()) << diagnostics::render_text(sources, findings) << text;
    return result.value_or("");
}

bool is_correct(const Example& example) {
    return !read(example.text, example.is_assertions)->file().has_syntax_errors;
}

bool is_read_whole(const Example& example) {
    return read(example.text, example.is_assertions)->file().kept.empty();
}

void expect_laws(const Example& example) {
    const auto tree = [&](const std::string& text) {
        return random_models::structure_text(read(text, example.is_assertions)->file());
    };
    const std::string once = formatted(example.text, example.is_assertions);
    EXPECT_EQ(formatted(once, example.is_assertions), once) << example.origin << " is not stable:\n" << example.text;
    EXPECT_TRUE(same_words(example.text, once, example.is_assertions)) << example.origin;
    EXPECT_EQ(tree(once), tree(example.text)) << example.origin << ":\n" << example.text;
}

Example respaced(const Example& example, const std::function<std::string(std::string_view)>& choose) {
    const std::string_view text = example.text;
    std::string out;
    std::size_t end = 0;
    for (const Words words(example); const Token& token : words.stream.tokens) {
        const std::string gap = choose(text.substr(end, token.span.begin - end));
        const bool one_line =
            token.is_word("(") || token.escaped;  // a call or an operator `^` may not follow a line end
        out += one_line && gap.find_first_of("\r\n") != std::string::npos ? " " : gap;
        out += text.substr(token.span.begin, token.span.end - token.span.begin);
        end = token.span.end;
    }
    return {example.origin, out, example.is_assertions};
}

Example respaced(const Example& example, random_models::Random& random) {
    return respaced(example, [&](std::string_view before) { return any_gap(random, before); });
}

Example lengthened(const Example& example, random_models::Random& random, std::size_t most) {
    std::string out;
    std::size_t end = 0;
    for (const Words words(example); const Token& token : words.stream.tokens) {
        out += example.text.substr(end, token.span.end - end);
        end = token.span.end;
        if (token.kind == TokenKind::identifier && !example.is_assertions) out += std::string(random.below(most), 'w');
    }
    return {example.origin, out, example.is_assertions};
}

}  // namespace robochart::frontend::testing
