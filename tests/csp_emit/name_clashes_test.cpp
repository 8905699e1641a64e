// SPDX-License-Identifier: Apache-2.0
// Tests name clashes. Compares the names that CSP blocks define, and the names of model elements, with every name that
// CSPM predefines and every name of the library. The generated part must keep its meaning, and definitions that a block
// makes for the model must take effect.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "checker/cspm/syntax/printer.hpp"
#include "checker/cspm/syntax/reader.hpp"
#include "checker/cspm/types/builtins.hpp"
#include "checker/cspm/types/type_check.hpp"
#include "csp_emit/base/library.hpp"
#include "frontend/syntax/lexer.hpp"
#include "tests/csp_emit/fixture.hpp"
#include "tests/random_models/tests/seeds.hpp"

namespace robochart::csp_emit::name_clashes_test {
namespace {

using random_models::is_long_run;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// Returns every predefined name of CSPM that a block can declare (without keywords), and every name of this program's
/// library.
std::set<std::string> taken_names() {
    std::set<std::string> result = library_names();
    for (const cspm::BuiltinName& builtin : cspm::builtin_names()) result.emplace(builtin.name);
    for (const char* keyword : {"true", "false"}) result.erase(keyword);
    return result;
}

std::string insert_name(std::string text, const std::string& name) {
    for (std::size_t at = text.find("NAME"); at != std::string::npos; at = text.find("NAME", at + name.size()))
        text.replace(at, 4, name);
    return text;
}

// A model that uses sequences, sets, relations, functions, clocks, waits, calls and arrays, so that it needs most of
// the library.
const char* const variety = R"(
    import sequence_toolkit::*
    import set_toolkit::*
    import relation_toolkit::*
    function least(s : Set(nat)) : nat { precondition size(s) > 0 postcondition result in s }
    stm S {
        event i : Seq(nat)
        event o : nat
        event bad
        var s : Seq(nat)
        var k : Set(nat)
        var r : nat <-> nat
        clock C
        initial i0
        state A { entry k = {0, 1} ; r = {(| 0, 1 |), (| 1, 2 |)} }
        state B { entry wait(1) ; o ! head(s) }
        state D { }
        transition t0 { from i0 to A }
        transition t1 { from A to B trigger i ? s condition size(s) > 1 action s = reverse(s) }
        transition t2 { from B to D condition since(C) >= 1 /\ 0 in dom(r) /\ union(k, {2}) == {0, 1, 2} }
        transition t3 { from D to D action bad }
        transition t4 { from A to D condition size(s) > 2 }
    })";
const char* const claims = R"(
    assertion Empty : S::D is not reachable in S
    assertion Reached : S::B is reachable in S
    untimed assertion Free : S is divergence-free
)";

/// Tries each name in a quarter of the forms. With ROBOCHART_SEEDS, tries all forms.
TEST(NameClashes, DeclarationsOfBlocksDoNotChangeTheLibrary) {
    const char* const forms[] = {
        "NAME(_) = error(\"captured\")",
        "NAME = 1",
        "channel NAME",
        "datatype NAME = Constructor",
        "datatype Data = NAME | Other",
        "nametype NAME = {0..1}",
        "module NAME\n  inside = 0\nexports\n  seen = inside\nendmodule\nvalue = NAME::seen",
        "module Mine\n  NAME(_) = 0\nexports\n  seen = NAME(1)\nendmodule\nvalue = Mine::seen",
        "f(NAME) = NAME",
        "f(x) = let NAME = x within NAME",
    };
    const char* const blocks[] = {"csp Instantiations csp-begin\nTEXT\ncsp-end\n", "csp Own csp-begin\nTEXT\ncsp-end\n",
                                  "timed csp Own csp-begin\nTimed(OneStep) {\nTEXT\n}\ncsp-end\n"};
    const std::set<std::string> declared_by_robotool{"InOut", "in", "out", "tock", "tock'"};
    const std::size_t share = is_long_run() ? 1 : 4;
    std::size_t number = 0;
    std::size_t turn = 0;
    for (const std::string& name : taken_names()) {
        ++turn;
        for (std::size_t i = 0; i < std::size(blocks); ++i)
            for (std::size_t f = i; f < std::size(forms); f += std::size(blocks)) {
                if ((turn + f) % share != 0) continue;
                const char* const block = blocks[(number + i) % std::size(blocks)];
                const char* const form = forms[f];
                const bool section = std::string(block).find("Timed") != std::string::npos;
                if (section && (name == "OneStep" || std::string(form).find("module") != std::string::npos)) continue;
                std::string text = block;
                text.replace(text.find("TEXT"), 4, insert_name(form, name));
                // All blocks are type checked, and every 97th block is also decided.
                const bool decide = ++number % 97 == 0;
                const auto m = testing::load_model(variety, text + claims);
                ASSERT_TRUE(m->diagnostics.ok()) << m->messages();
                const Emission emission = m->emit(Time::timed);
                ASSERT_TRUE(m->diagnostics.ok()) << text << m->messages();
                EXPECT_THAT(emission.captured, IsEmpty()) << text;
                cspm::check_types(emission.script, m->diagnostics);
                if (declared_by_robotool.contains(name) && !m->diagnostics.ok()) {
                    EXPECT_THAT(m->messages(), ::testing::HasSubstr("model.assertions:")) << text;
                    continue;
                }
                ASSERT_TRUE(m->diagnostics.ok()) << text << m->messages();
                if (!decide) continue;
                EXPECT_THAT(testing::decide_obligations(*m, Time::timed), ElementsAre("fails", "holds")) << text;
            }
    }
}

/// Decides the claims for every third name that an Instantiations block defines as a function. With ROBOCHART_SEEDS,
/// decides them for all names.
TEST(NameClashes, InstantiationsDoNotChangeVerdicts) {
    std::size_t turn = 0;
    for (const std::string& name : taken_names()) {
        if (!is_long_run() && ++turn % 3 != 0) continue;
        const std::string block = insert_name("csp Instantiations csp-begin\nNAME(x__y) = 0\ncsp-end\n", name);
        const auto m = testing::load_model(variety, block + claims);
        ASSERT_TRUE(m->diagnostics.ok()) << m->messages();
        if (name == "InOut" || name == "in" || name == "out" || name == "tock" || name == "tock'") continue;
        EXPECT_THAT(testing::decide_obligations(*m, Time::untimed), ElementsAre("fails", "holds", "holds")) << block;
    }
}

TEST(NameClashes, BlocksDefineFunctionsOfTheModel) {
    for (const std::string& name : taken_names()) {
        if (name.find('\'') != std::string::npos || name == "Seq" || name == "Set") continue;  // not a RoboChart name
        if (name == "InOut" || name == "in" || name == "out" || name == "tock") continue;      // declared twice in CSPM
        const std::string function = frontend::is_reserved(name) ? "^" + name : name;
        const auto m = testing::load_model(
            insert_name(
                "function NAME(a : Set(nat)) : nat { } stm S { event o : nat var s : Set(nat) initial i0 state A { } "
                "transition t0 { from i0 to A action s = {0, 1} ; o ! NAME(s) } }",
                function),
            insert_name("csp Instantiations csp-begin\nNAME(a) = 1\ncsp-end\n"
                        "csp Q csp-begin\nQ = S::o.out!1 -> Q\ncsp-end\n"
                        "untimed assertion T1 : S refines Q in the traces model\n",
                        name));
        ASSERT_TRUE(m->diagnostics.ok()) << name << m->messages();
        EXPECT_THAT(testing::decide_obligations(*m, Time::untimed), ElementsAre("holds")) << name;
    }
}

TEST(NameClashes, BlocksCallElementsByTheirNamesInTheModel) {
    const auto m = testing::load_model(
        R"(
        stm S { event union : nat event halt initial i state A { } state halt { initial i state entered_ { } transition t { from i to entered_ } }
                transition t0 { from i to A } transition t1 { from A to halt trigger halt action union ! 1 } }
        stm _T { event _e initial i state _a { } transition t0 { from i to _a action _e } }
        enumeration Char { x y }
        function card(c : Char) : nat { }
        stm U { event o : nat event c : Char initial i state A { } transition t0 { from i to A action o ! card(Char::y) ; c ! Char::y } }
    )",
        R"(
        csp Instantiations csp-begin
            card(c) = 2
        csp-end
        csp Specs csp-begin
            Specs = S::halt.in -> S::union.out.1 -> STOP
            TheirUnion = union({1},{2})
            Values = U::o.out.card(Char_y) -> U::c.out.Char_y -> STOP
            InHalt = S::halt::entered -> STOP
            Values__sem__events = {| U::o, U::c |}
        csp-end
        csp Values csp-begin
            Unused = STOP
        csp-end
        untimed assertion A : S equals Specs
        untimed assertion B : U equals Values
        untimed assertion C : _T is not deadlock-free
    )");
    ASSERT_TRUE(m->diagnostics.ok()) << m->messages();
    EXPECT_THAT(testing::decide_obligations(*m, Time::untimed), ElementsAre("holds", "holds", "holds"))
        << m->messages();
    const Emission emission = m->emit(Time::untimed);
    cspm::check_types(emission.script, m->diagnostics);
    EXPECT_TRUE(m->diagnostics.ok()) << m->messages();
}

TEST(NameClashes, EveryAssertionFileIsAScope) {
    const auto m = testing::model_of({{"m.rct",
                                       "stm S { event a initial i0 state A { } transition t0 { from i0 to A } "
                                       "transition t1 { from A to A trigger a } }"},
                                      {"one.assertions",
                                       "untimed csp Spec csp-begin\nSpec = S::a.in -> Spec\ncsp-end\n"
                                       "untimed assertion A1 : S equals Spec\n"},
                                      {"two.assertions",
                                       "untimed csp Spec csp-begin\nSpec = S::a.in -> STOP\ncsp-end\n"
                                       "untimed assertion A2 : S equals Spec\n"}});
    ASSERT_TRUE(m->diagnostics.ok()) << m->messages();
    EXPECT_THAT(m->codes(), IsEmpty());
    EXPECT_THAT(testing::decide_obligations(*m, Time::untimed), ElementsAre("holds", "fails"));
    const Emission emission = m->emit(Time::untimed);
    cspm::check_types(emission.script, m->diagnostics);
    EXPECT_TRUE(m->diagnostics.ok()) << m->messages();
}

// Models with NAME in every position in which a name can occur.
const char* const everywhere[] = {
    "package NAME stm S { event e initial i state A { } transition t0 { from i to A } transition t9 { from A to A"
    " trigger e } }",
    "type NAME stm S { event e : NAME var v : NAME initial i state A { } transition t0 { from i to A } transition t9 { "
    "from A "
    "to A trigger e ? v } }",
    "datatype NAME { f : nat } stm S { event e : NAME var v : NAME initial i state A { } transition t0 { from i to A } "
    "transition t9 { from A to A trigger e ? v } }",
    "datatype R { NAME : nat } stm S { event e : R var v : R initial i state A { } transition t0 { from i to A } "
    "transition t9 { from A to A trigger e ? v action v.NAME = 1 } }",
    "enumeration NAME { a b } stm S { event e : NAME var v : NAME initial i state A { } transition t0 { from i to"
    " A } transition t9 { from A to A trigger e ? v condition v == NAME::b } }",
    "enumeration E { a NAME } stm S { event e : E var v : E initial i state A { } transition t0 { from i to A } "
    "transition t9 { from A to A trigger e ? v condition v == E::NAME } }",
    "enumeration E { a NAME(nat) } stm S { event e : E var v : E initial i state A { } transition t0 { from i to A } "
    "transition t9 { from A to A trigger e ? v } }",
    "interface NAME { event e } stm S { uses NAME initial i state A { } transition t0 { from i to A } "
    "transition t9 { from A to A trigger e } }",
    "stm S { event NAME : nat var v : nat initial i state A { } transition t0 { from i to A } transition t9 { "
    "from A to A trigger NAME ? v action NAME ! v } }",
    "stm S { event e : nat var NAME : nat initial i state A { entry NAME = 1 } transition t0 { from i to A } "
    "transition t9 { from A to A trigger e ? NAME condition NAME > 0 } }",
    "interface I { var NAME : nat } stm S { requires I event e : nat initial i state A { entry NAME = 1 } "
    "transition t0 { from i to A } transition t9 { from A to A trigger e ? NAME condition NAME > 0 } } robotic "
    "platform P { provides I event e : nat } controller C { requires I event e : nat sref s = S connection C on e"
    " to s on e } module M { rref p = P cref c = C connection p on e to c on e ( _async ) }",
    "stm S { event e : nat const NAME : nat = 1 initial i state A { entry e ! NAME } transition t0 { from i to A "
    "} }",
    "stm S { event e clock NAME initial i state A { } transition t0 { from i to A } transition t9 { from A "
    "to A trigger e #NAME condition since(NAME) < 1 } }",
    "interface I { NAME(n : nat) } stm S { requires I initial i state A { entry NAME(1) } transition t0 { from i "
    "to A } } robotic platform P { provides I } controller C { requires I sref s = S } module M { rref p = P cref"
    " c = C }",
    "interface I { NAME(n : nat) } operation NAME(n : nat) { initial i final f transition t { from i to f } } stm"
    " S { requires I initial i state A { entry NAME(1) } transition t0 { from i to A } } controller C { requires "
    "I opref o = NAME sref s = S }",
    "interface I { o(NAME : nat) } operation o(NAME : nat) { event e : nat initial i final f transition t { from "
    "i to f action e ! NAME } } stm S { event e : nat requires I initial i state A { entry o(1) } transition t0 {"
    " from i to A } } controller C { event e : nat requires I opref o = o sref s = S connection s on e to C on e "
    "}",
    "function NAME(n : nat) : nat { precondition n > 0 postcondition result == n } stm S { event e : nat initial "
    "i state A { entry e ! NAME(1) } transition t0 { from i to A } }",
    "function f(NAME : nat) : nat { precondition NAME > 0 postcondition result == NAME } stm S { event e : nat "
    "initial i state A { entry e ! f(1) } transition t0 { from i to A } }",
    "stm NAME { event e initial i state A { } transition t0 { from i to A } transition t9 { from A to A trigger e"
    " } }",
    "package P stm NAME { event e initial i state A { } transition t0 { from i to A } transition t9 { from A to A"
    " trigger e } }",
    "stm S { event e initial i state NAME { initial j state B { } transition t { from j to B } } transition t0 { "
    "from i to NAME } transition t9 { from NAME to NAME trigger e } }",
    "stm S { event e initial i state A { initial j state NAME { } transition t { from j to NAME } } transition t0"
    " { from i to A } transition t9 { from A to A trigger e } }",
    "stm S { event e initial NAME state A { } transition t0 { from NAME to A } transition t9 { from A to A "
    "trigger e } }",
    "stm S { event e initial i junction NAME state A { } transition t0 { from i to NAME } transition t1 { from "
    "NAME to A } }",
    "stm S { event e initial i state A { } final NAME transition t0 { from i to A } transition t1 { from A to "
    "NAME trigger e } }",
    "stm S { event e initial i state A { } transition NAME { from i to A } transition t9 { from A to A trigger e "
    "} }",
    "controller NAME { event e stm S { event e initial i state A { } transition t0 { from i to A } transition t9 "
    "{ from A to A trigger e } } connection NAME on e to S on e }",
    "controller C { event e stm NAME { event e initial i state A { } transition t0 { from i to A } transition t9 "
    "{ from A to A trigger e } } connection C on e to NAME on e }",
    "stm S { event e initial i state A { } transition t0 { from i to A } transition t9 { from A to A trigger e } "
    "} controller C { event e sref NAME = S connection C on e to NAME on e }",
    "stm S { event e initial i state A { } transition t0 { from i to A } transition t9 { from A to A trigger e } "
    "} controller C { event e sref s = S connection C on e to s on e } robotic platform NAME { event e } module M"
    " { rref r = NAME cref c = C connection r on e to c on e ( _async ) }",
    "stm S { event e initial i state A { } transition t0 { from i to A } transition t9 { from A to A trigger e } "
    "} controller C { event e sref s = S connection C on e to s on e } robotic platform P { event e } module NAME"
    " { rref r = P cref c = C connection r on e to c on e ( _async ) }",
    "stm S { event e initial i state A { } transition t0 { from i to A } transition t9 { from A to A trigger e } "
    "} controller C { event e sref s = S connection C on e to s on e } robotic platform P { event e } module M { "
    "rref NAME = P cref c = C connection NAME on e to c on e ( _async ) }",
    "stm S { event e initial i state A { } transition t0 { from i to A } transition t9 { from A to A trigger e } "
    "} controller C { event e sref s = S connection C on e to s on e } robotic platform P { event e } module M { "
    "rref r = P cref NAME = C connection r on e to NAME on e ( _async ) }",
    "stm S { event e : boolean initial i state A { entry e ! (forall NAME : nat | NAME > 1 @ NAME > 0) } "
    "transition t0 { from i to A } }",
    "stm S { event e : nat initial i state A { entry e ! (let NAME == 1 @ NAME + 1) } transition t0 { from i to A"
    " } }",
    // the name is that of an event, its machine, a part, a state and a function
    "function NAME(n : nat) : nat { } controller K { event NAME : nat stm NAME { event NAME : nat initial i state"
    " NAME { entry NAME ! NAME(1) } transition t0 { from i to NAME } } connection NAME on NAME to K on NAME }",
};

/// Checks that no name in the model's scripts is captured, if the name rules accept the model. The models differ only
/// in one name, so only some of them are type checked and parsed again.
void expect_apart(const std::string& text, bool and_read_again) {
    const auto m = testing::load_model(text);
    if (!m->diagnostics.ok()) return;  // rejected by the name rules: no script is generated
    for (const Time time : {Time::untimed, Time::timed}) {
        const Emission emission = m->emit(time, time == Time::timed);
        if (!m->diagnostics.ok()) return;  // rejected because of a name
        EXPECT_THAT(emission.captured, IsEmpty()) << text;
        if (!and_read_again) continue;
        cspm::check_types(emission.script, m->diagnostics);
        EXPECT_TRUE(m->diagnostics.ok()) << text << "\n" << m->messages();
        const auto reread = m->sources.add("again.csp", cspm::print(emission.script));
        diagnostics::Diagnostics findings;
        EXPECT_TRUE(cspm::equal(cspm::read(m->sources, reread, findings), emission.script)) << text;
    }
}

/// Tries each name in a sixth of the positions, which rotate from name to name. With ROBOCHART_SEEDS, tries all
/// positions.
TEST(NameClashes, EveryNameIsValidInEveryPosition) {
    const std::size_t share = is_long_run() ? 1 : 6;
    std::size_t number = 0;
    for (const char* text : everywhere) {
        const auto m = testing::load_model(insert_name(text, "plain"));
        (void)m->emit(Time::timed, true);
        ASSERT_TRUE(m->diagnostics.ok()) << text << m->messages();
    }
    std::set<std::string> names = taken_names();
    for (const char* more : {"and",
                             "or",
                             "not",
                             "if",
                             "then",
                             "else",
                             "let",
                             "within",
                             "channel",
                             "datatype",
                             "subtype",
                             "nametype",
                             "module",
                             "exports",
                             "endmodule",
                             "instance",
                             "assert",
                             "print",
                             "include",
                             "transparent",
                             "external",
                             "Timed",
                             "true",
                             "false",
                             "_",
                             "__",
                             "_a",
                             "_1",
                             "a_",
                             "a__",
                             "x__q",
                             "TIDS",
                             "D__",
                             "O__",
                             "VS__",
                             "FVS__",
                             "HUP__",
                             "AS_O__",
                             "STM__",
                             "id__",
                             "terminate",
                             "entered",
                             "internal__",
                             "sem__events",
                             "clockReset",
                             "core_nat",
                             "core_int",
                             "core_real",
                             "core_boolean",
                             "core_string",
                             "core_clock_type",
                             "Plus",
                             "Minus",
                             "real_scale",
                             "const_S_e",
                             "set_e",
                             "set_EXT_e",
                             "get_e",
                             "eCall",
                             "OP_o",
                             "pre_f",
                             "e1__",
                             "result",
                             "result__q",
                             "elem__",
                             "S",
                             "C",
                             "M",
                             "Memory",
                             "get",
                             "set_",
                             "share__",
                             "TimeOut",
                             "SID",
                             "CLID",
                             "NIDS",
                             "in_e",
                             "tock_",
                             "step__",
                             "r___1"})
        names.insert(more);
    std::size_t turn = 0;
    for (const std::string& plain : names) {
        if (plain.find('\'') != std::string::npos) continue;
        const std::string name = frontend::is_reserved(plain) ? "^" + plain : plain;
        ++turn;
        const bool literal = plain == "True" || plain == "False";  // the only names whose plain form is also a literal
        for (std::size_t i = literal ? 0 : turn % share; i < std::size(everywhere); i += literal ? 1 : share)
            expect_apart(insert_name(everywhere[i], name), ++number % 7 == 0);
    }
}

// A reference to S denotes the first of two machines, but the script contains both.
TEST(NameClashes, ScriptContainsBothMachinesOfTheSameName) {
    const auto m = testing::model_of(
        {{"a.rct", "stm S { event a initial i state A { entry a } transition t { from i to A } }"},
         {"b.rct", "stm S { event b initial i state A { entry b } transition t { from i to A } }"},
         {"c.assertions",
          "untimed csp Q csp-begin\nQ = S::a.out -> STOP\ncsp-end\nuntimed assertion A : S equals Q\n"}});
    EXPECT_THAT(testing::decide_obligations(*m, Time::untimed), ElementsAre("holds")) << m->messages();
    Emission emission = m->emit(Time::untimed, true);
    cspm::check_types(emission.script, m->diagnostics);
    EXPECT_TRUE(m->diagnostics.ok()) << m->messages();
    EXPECT_THAT(cspm::print(emission.script), ::testing::HasSubstr("module S_1"));
}

// If a component cannot be renamed, the model is rejected before any output.
TEST(NameClashes, ComponentsWithTheSameNameAreRejected) {
    const char* const machine = "stm S { event a initial i state A { } transition t { from i to A } }";
    const auto twice = testing::model_of({{"a.rct", std::string("operation o() ") + (machine + 6)},
                                          {"b.rct", std::string("operation o() ") + (machine + 6)}});
    (void)twice->emit(Time::untimed);
    EXPECT_THAT(twice->messages(), ::testing::HasSubstr("RC-C10"));
    const std::string constant =
        " const k : nat = 1 event a : nat initial i state A { entry a ! k } transition t { from "
        "i to A } }";
    const auto constants =
        testing::model_of({{"a.rct", "package P stm S {" + constant}, {"b.rct", "stm P_S {" + constant}});
    (void)constants->emit(Time::untimed);
    EXPECT_THAT(constants->messages(), ::testing::HasSubstr("RC-C10"));
    const auto packages = testing::model_of(
        {{"a.rct", std::string("package P::Q ") + machine}, {"b.rct", std::string("package P_Q ") + machine}});
    (void)packages->emit(Time::untimed);
    EXPECT_THAT(packages->messages(), ::testing::HasSubstr("RC-C10"));
}

}  // namespace
}  // namespace robochart::csp_emit::name_clashes_test
