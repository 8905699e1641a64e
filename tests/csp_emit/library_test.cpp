// SPDX-License-Identifier: Apache-2.0
// Tests definitions of RoboTool's library that CSP blocks may use although generated scripts do not need them, and the
// functions of records.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "checker/cspm/types/type_check.hpp"
#include "tests/csp_emit/fixture.hpp"

namespace robochart::csp_emit::library_test {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;

const char* const machine =
    "stm S { event a initial i state A { } transition t0 { from i to A } transition t1 { from A to A trigger a } }";

/// Returns the verdicts of the assertions in a block. The block must type check.
std::vector<std::string> check_block(const std::string& rct, Time time, const std::string& text) {
    const auto m = testing::load_model(
        rct, std::string(time == Time::timed ? "timed" : "untimed") + " csp Own csp-begin\n" + text + "\ncsp-end\n");
    const Emission emission = m->emit(time);
    cspm::check_types(emission.script, m->diagnostics);
    if (!m->diagnostics.ok()) return {m->messages()};
    return testing::decide_script(emission.script);
}

TEST(BlockLibrary, NumbersOfTypes) {
    EXPECT_THAT(
        check_block(
            machine, Time::untimed,
            "channel yes\nOk(b) = if b then yes -> STOP else STOP\n"
            "assert not STOP [T= Ok(calc_type_max({0..2}) == 2 and calc_type_min({1..3}) == 1)\n"
            "assert not STOP [T= Ok(calc_type_max({ -2..-1}) == 0 and calc_type_min({ -2..2}) == -2)\n"
            "assert not STOP [T= Ok(ILSeq({0,1},2) == {<>,<0>,<1>,<0,1>,<1,0>})\n"
            "assert not STOP [T= Ok(tuple2_1((1,2)) == 1 and tuple3_2((1,2,3)) == 2 and tuple5_5((1,2,3,4,5)) == 5)"),
        Each("holds"));
}

// The operators have defining laws: a process that ends after d time units, and a timeout that the first event
// prevents.
TEST(BlockLibrary, OperatorsOfTime) {
    EXPECT_THAT(
        check_block(machine, Time::timed,
                    "channel b, c\n"
                    "Idle = tock -> Idle\n"
                    "Ever = b -> Ever [] tock -> Ever\n"
                    "Timed(OneStep) {\n  Cut = TimedInterrupt(Again,1) ; c -> STOP\n  Again = b -> Again\n}\n"
                    "One = b -> One [] tock -> After\nAfter = c -> Idle [] tock -> After\n"
                    "assert One [T= prioritise(Cut,<{},{tock}>)\nassert prioritise(Cut,<{},{tock}>) [T= One\n"
                    "Timed(OneStep) {\n  Either = TimeOut(b -> STOP,1,c -> STOP)\n}\n"
                    "First = b -> Idle [] tock -> Second\nSecond = c -> Idle [] tock -> Second\n"
                    "assert First [T= prioritise(Either,<{},{tock}>)\n"
                    "assert prioritise(Either,<{},{tock}>) [T= First\n"
                    "Late = TimedInterruptSeq(b,2,c -> STOP)\n"
                    "assert not STOP [T= Late |\\ {b}\n"
                    "assert TCHAOS({b}) [FD= STOP\nassert TCHAOS({b}) [F= Ever\nassert not Ever [F= TCHAOS({b})\n"
                    "assert RT__(1) [T= b -> c -> tock -> SKIP\nassert not RT__(1) [T= tock -> b -> SKIP"),
        Each("holds"));
}

TEST(BlockLibrary, FieldsOfRecords) {
    const std::string rct =
        "datatype R { p : nat q : nat } datatype One { only : nat } stm S { event i : R event o : nat event w : One "
        "var v : R "
        "var u : One initial i0 state A { } transition t0 { from i0 to A } transition t1 { from A to A trigger i ? v "
        "action "
        "o ! (v.p) ; v.q = 2 ; o ! (v.q) } transition t2 { from A to A trigger w ? u } }";
    EXPECT_THAT(check_block(rct, Time::untimed,
                            "Q = S::i.in?x -> S::o.out!(R_p(x)) -> S::o.out!(R_q(update_R_q(x,2))) -> Q\n"
                            "  [] S::w.in?u -> Q [] S::terminate -> STOP\n"
                            "channel yes\n"
                            "assert not STOP [T= (if One_only(update_One_only(0,1)) == 1 then yes -> STOP else STOP)\n"
                            "assert Q [T= S::D__(0)\nassert S::D__(0) [T= Q \\ {S::terminate}"),
                Each("holds"));
    // A block may redefine these names.
    EXPECT_THAT(check_block(rct, Time::untimed,
                            "R_p(x) = 7\nchannel yes\n"
                            "assert not STOP [T= (if R_p((1,1)) == 7 then yes -> STOP else STOP)"),
                ElementsAre("holds"));
}

TEST(BlockLibrary, AnOperationWithoutBodyLetsTimePass) {
    const char* const operations = "operation done() { terminates } operation open() { }";
    EXPECT_THAT(check_block(operations, Time::timed,
                            "Idle = tock -> Idle\nAny = SKIP |~| tock -> Any\n"
                            "assert Any [FD= OP_done::D__(0)\nassert OP_done::D__(0) [FD= Any\n"
                            "assert OP_open::D__(0) [FD= Idle\nassert OP_open::D__(0) [FD= Any"),
                Each("holds"));
    EXPECT_THAT(check_block(operations, Time::untimed,
                            "assert SKIP [FD= OP_done::D__(0)\nassert OP_open::D__(0) [FD= STOP\n"
                            "assert OP_open::D__(0) [FD= SKIP"),
                Each("holds"));
}

TEST(BlockLibrary, ARecordWithoutAFieldHasItsDefault) {
    const auto m = testing::load_model(
        "enumeration E { one two } datatype Inner { b : boolean s : Set(nat) } datatype R { p : nat e : E x : real "
        "inner : "
        "Inner } stm S { event o : R initial i0 state A { } transition t0 { from i0 to A action o ! R (| p = 1 |) } }",
        "untimed csp Q csp-begin\nQ = S::o.out!(1,E_one,0,(true,{})) -> STOP\ncsp-end\n"
        "untimed assertion T : S equals Q\n");
    EXPECT_THAT(testing::decide_obligations(*m, Time::untimed), ElementsAre("holds")) << m->messages();
    EXPECT_THAT(m->codes(), ElementsAre("RC-T21"));
}

// RoboTool's scripts pass the constants of their parts to modules and controllers. A block may define only these
// constants. It may also define only the machine's constant, which then applies to the part too.
TEST(BlockLibrary, ConstantsOfPartsCountInClaims) {
    for (const char* const constant : {"const_C_r_k", "const_S_k"}) {
        const auto m = testing::load_model(
            "stm S { const k : nat event o : nat initial i state A { } transition t0 { from i to A action o ! k } } "
            "controller C { event o : nat sref r = S connection r on o to C on o }",
            std::string("csp Instantiations csp-begin\n") + constant +
                " = 2\ncsp-end\nuntimed csp Q csp-begin\nQ = C::o.out!2 -> STOP\ncsp-end\n"
                "untimed assertion T : C equals Q\n");
        EXPECT_THAT(testing::decide_obligations(*m, Time::untimed), ElementsAre("holds")) << constant << m->messages();
    }
}

// RoboTool does not check contracts, so an error in a contract only removes this contract.
TEST(BlockLibrary, AWrongContractIsNone) {
    const auto m = testing::load_model(
        "function f(x : int, y : int) : nat { precondition x > 0 postcondition result == {x, y} } "
        "stm S { event o : nat initial i0 state A { } transition t0 { from i0 to A action o ! f(0, 1) } }",
        "untimed csp Q csp-begin\nQ = S::o.out!0 -> STOP\ncsp-end\nuntimed assertion T : S equals Q\n");
    EXPECT_THAT(testing::decide_obligations(*m, Time::untimed), ElementsAre("holds")) << m->messages();
    EXPECT_THAT(m->codes(), ElementsAre("RC-S18", "RC-T36"));
}

}  // namespace
}  // namespace robochart::csp_emit::library_test
