// SPDX-License-Identifier: Apache-2.0
// Tests rules R1 to R16 (docs/prism-encoding.md), each with a small model. The expected commands and counts were
// derived by hand from the statements of the rules.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/prism/emit/models.hpp"

namespace robochart::prism_emit {
namespace {

using testing::encode_model;
using testing::Encoded;
using ::testing::IsSupersetOf;
using testing::Size;
using Lines = std::vector<std::string>;

/// One machine S, as `s` of controller `c` of module M. `top` contains declarations next to it, `outside` those of the
/// platform R, `inside` those of the controller, and `connections` those of the module.
struct Parts {
    std::string machine, top, outside, inside, connections;
};

std::string model_text(const Parts& parts) {
    return parts.top + "\nrobotic platform R { " + parts.outside + " }\nstm S { initial i\n" + parts.machine +
           "\n}\ncontroller C { sref s = S " + parts.inside + " }\nmodule M { rref r = R cref c = C " +
           parts.connections + " }\n";
}

void expect_lines(const Parts& parts, const Lines& lines) {
    const auto model = encode_model(model_text(parts));
    ASSERT_TRUE(model->emission) << model->report();
    EXPECT_THAT(model->lines("M_c_s_"), IsSupersetOf(lines));
    (void)testing::size_of(*model);  // checks that it is a PRISM model
}

void expect_size(const Parts& parts, const Size& size) {
    const auto model = encode_model(model_text(parts));
    ASSERT_TRUE(model->emission) << model->report();
    const Size found = testing::size_of(*model);
    EXPECT_EQ(found.states, size.states);
    EXPECT_EQ(found.transitions, size.transitions);
}

const std::string two_states = "state A { } state B { } transition t0 { from i to A } ";

TEST(Rules, R1NamesAreQualifiedByReferences) {
    const auto model = encode_model(
        "enumeration Light { Red Green }\nrobotic platform R { }\n"
        "stm S { var l : Light = Light::Green initial i state A { } transition t0 { from i to A } }\n"
        "controller C { sref s1 = S sref s2 = S }\nmodule M { rref r = R cref c = C }\n");
    ASSERT_TRUE(model->emission) << model->report();
    EXPECT_THAT(model->lines(""),
                IsSupersetOf(Lines{"module M_c_s1", "module M_c_s2", "const int Light_Red = 0;",
                                   "const int Light_Green = 1;", "M_c_s1_l : [0..1] init Light_Green;"}));
    const std::string written = prism_emit::file_text(*model->emission);
    EXPECT_NE(written.find("// renames of the node [M::c::s2::A] to [M_c_s2_A]\n"), std::string::npos);
}

TEST(Rules, R1NamesThatPrismReservesGetAnUnderscore) {
    const auto model = encode_model(model_text({"requires I state A { entry label = 1 } transition t0 { from i to A }",
                                                "interface I { var label : nat }", "provides I", "requires I", ""}));
    ASSERT_TRUE(model->emission) << model->report();
    EXPECT_TRUE(model->lines("").contains("global label_ : [0..2];"));
}

TEST(Rules, R2OneModuleForEachMachineBufferAndPlatform) {
    const auto model = encode_model(
        "robotic platform R { event go }\n"
        "stm S { event go event e initial i state A { } transition t0 { from i to A }\n"
        "  transition t1 { from A to A trigger go action e } }\n"
        "stm T { event e initial i state A { } transition t0 { from i to A } transition t1 { from A to A trigger e } "
        "}\n"
        "controller C { event go sref s = S sref t = T connection C on go to s on go\n"
        "  connection s on e to t on e (_async) }\n"
        "module M { rref r = R cref c = C connection r on go to c on go (_async) }\n");
    ASSERT_TRUE(model->emission) << model->report();
    std::vector<std::string> names;
    for (const prism::Module& module : model->emission->model.modules) names.push_back(module.name.text);
    EXPECT_THAT(names, ::testing::UnorderedElementsAre("M_c_s", "M_c_t", ::testing::StartsWith("BUF_e_"), "M_R"));
}

TEST(Rules, R3VariablesHaveRangesAndConstantsStayOpen) {
    expect_lines({"requires I var n : nat var b : boolean = true var r : real = 2 const k : nat = 1 " + two_states,
                  "interface I { var g : int }", "provides I", "requires I", ""},
                 {"global g : [0..2];", "n : [0..2];", "b : bool init true;", "r : [0..2] init 2;", "const int k = 1;",
                  "scpc_8 : [0..3] init i;", "exit_9 : [0..6] init Exit_NONE;", "lock_7 : [0..1] init LOCK_FREE;"});
    const auto open = encode_model(model_text({"const p : real const n : nat " + two_states, "", "", "", ""}));
    EXPECT_THAT(open->lines("M_c_s_"), IsSupersetOf(Lines{"const double p;", "const int n;"}));
}

TEST(Rules, R4R5R6StatesAreTakenAndLeft) {
    const Parts parts{
        "var x : nat state A { } state B { entry x = 1 } transition t0 { from i to A }\n"
        "transition t1 { from A to B condition x == 0 } transition t2 { from B to A }",
        "", "", "", ""};
    expect_lines(parts, {"[] scpc_8 = i -> (scpc_8' = A) & (lock_7' = LOCK_FREE);",
                         "[] scpc_8 = A & lock_7 = LOCK_FREE & x = 0 -> (scpc_8' = B_entering) & (lock_7' = t1);",
                         "[] scpc_8 = B_entering -> (x' = 1) & (scpc_8' = B) & (lock_7' = LOCK_FREE);",
                         "[] scpc_8 = B & lock_7 = LOCK_FREE -> (scpc_8' = A) & (lock_7' = LOCK_FREE);"});
    // The states are i, A, entering B, B, and A again with x=1. There, no further step is possible, which PRISM writes
    // as a loop.
    expect_size(parts, {5, 5});
}

TEST(Rules, R7ATriggerWithAnActionIsSplit) {
    const Parts parts{
        "event e var x : nat state A { } transition t0 { from i to A }\n"
        "transition t1 { from A to A trigger e condition x < 2 action x = x + 1 }",
        "", "event e", "event e connection C on e to s on e", "connection r on e to c on e (_async)"};
    expect_lines(parts,
                 {"[RP__e_16] scpc_8 = A & lock_7 = LOCK_FREE & x < 2 -> (scpc_8' = sp_pj_1) & (lock_7' = sp1_2);",
                  "[] scpc_8 = sp_pj_1 -> (scpc_8' = Action_17);",
                  "[] scpc_8 = Action_17 -> (x' = x + 1) & (scpc_8' = A) & (lock_7' = LOCK_FREE);"});
    // The states are i, three points each for x=0 and x=1, and A with x=2, where the event is impossible.
    expect_size(parts, {8, 8});
}

TEST(Rules, R7ATriggerBeforeAJunctionGoesThroughIt) {
    const Parts parts{
        "event e var x : nat junction j state A { } state B { } transition t0 { from i to A }\n"
        "transition t1 { from A to j trigger e }\n"
        "transition t2 { from j to A condition x == 1 } transition t3 { from j to B condition x == 0 }\n"
        "transition t4 { from B to A }",
        "", "event e", "event e connection C on e to s on e", "connection r on e to c on e (_async)"};
    expect_lines(parts,
                 {"[RP__e_16] scpc_8 = A & lock_7 = LOCK_FREE & x = 1 -> (scpc_8' = A) & (lock_7' = LOCK_FREE);",
                  "[RP__e_16] scpc_8 = A & lock_7 = LOCK_FREE & x = 0 -> (scpc_8' = B) & (lock_7' = LOCK_FREE);"});
    expect_size(parts, {3, 3});  // states i, A, B
}

TEST(Rules, R8JunctionsAreStepsOfTheirOwn) {
    const Parts parts{
        "var x : nat probabilistic p junction j state A { entry x = 1 } state B { entry x = 2 }\n"
        "transition t0 { from i to A } transition t1 { from A to p } transition t2 { from B to j }\n"
        "transition t3 { from p to A probability 0.25 } transition t4 { from p to B probability 0.75 }\n"
        "transition t5 { from j to A condition x == 2 } transition t6 { from j to B condition x == 1 }",
        "", "", "", ""};
    expect_lines(parts, {"[] scpc_8 = A & lock_7 = LOCK_FREE -> (scpc_8' = p) & (lock_7' = t1);",
                         "[] scpc_8 = p -> 0.25 : (scpc_8' = A_entering) + 0.75 : (scpc_8' = B_entering);",
                         "[] scpc_8 = j & x = 2 -> (scpc_8' = A_entering);",
                         "[] scpc_8 = j & x = 1 -> (scpc_8' = B_entering);"});
    // The states are: i; A entering with x=0, without the lock; A; p (1); A entering and B entering with x=1 and t1; B;
    // j with x=2; A entering with x=2 and t2. There are two transitions from p, and one from each other state.
    expect_size(parts, {9, 10});
}

TEST(Rules, R9OneCommandForEachStatement) {
    expect_lines({"var x : nat var y : nat state A { entry x = 1 ; y = if x > 0 then 2 else 0 end ; skip }\n"
                  "transition t0 { from i to A }",
                  "", "", "", ""},
                 {"[] scpc_8 = A_entering -> (x' = 1) & (scpc_8' = Action_16);",
                  "[] scpc_8 = Action_16 -> (y' = x > 0 ? 2 : 0) & (scpc_8' = Action_17);",
                  "[] scpc_8 = Action_17 -> (scpc_8' = A) & (lock_7' = LOCK_FREE);"});
}

const Parts nested{
    "state P { initial i state Q { initial i state A { } transition t0 { from i to A }\n"
    "    transition t1 { from A to A } }\n"
    "  transition t0 { from i to Q } transition t1 { from Q to Q } }\n"
    "state B { } transition t0 { from i to P } transition t1 { from P to B } transition t2 { from B to B }",
    "", "", "", ""};

TEST(Rules, R6AncestorsAreActive) {
    expect_lines(nested,
                 {"[] scpc_8 = P & P_scpc_8 = P_Q & P_Q_scpc_8 = P_Q_A & lock_7 = LOCK_FREE -> (P_Q_scpc_8' = P_Q_A) & "
                  "(lock_7' = LOCK_FREE);",
                  "[] scpc_8 = P & P_scpc_8 = P_i -> (P_scpc_8' = P_Q) & (P_Q_scpc_8' = P_Q_i) & (lock_7' = P_t0);",
                  "P_scpc_8 : [0..2] init P_INACTIVE_10;", "P_Q_exit_9 : [0..6] init Exit_NONE;"});
}

TEST(Rules, R10ACompositeStateIsLeftFromInside) {
    expect_lines(
        nested,
        {"[] scpc_8 = P & lock_7 = LOCK_FREE -> (lock_7' = t1) & (P_exit_9' = Exit_ACT_Trans);",  // 1
         "[] scpc_8 = P & (P_exit_9 = Exit_ACT_Parent | P_exit_9 = Exit_ACT_Trans) -> (P_exit_9' = Exit_Sub_ACT);",
         "[] scpc_8 = P & P_scpc_8 = P_Q & P_exit_9 = Exit_Sub_ACT -> (P_exit_9' = Exit_Sub_ACT_Waiting) & "
         "(P_Q_exit_9' = Exit_ACT_Parent);",  // 3
         "[] scpc_8 = P & P_scpc_8 = P_Q & P_Q_scpc_8 = P_Q_A & P_Q_exit_9 = Exit_Sub_ACT -> (P_Q_exit_9' = "
         "Exit_Sub_EXITED);",  // 4/2
         "[] scpc_8 = P & P_exit_9 = Exit_Sub_EXITED -> (P_exit_9' = Exit_EXITED) & (P_scpc_8' = P_INACTIVE_10);",
         "[] scpc_8 = P & P_scpc_8 = P_Q & P_Q_exit_9 = Exit_EXITED & P_exit_9 = Exit_Sub_ACT_Waiting -> (P_Q_exit_9' "
         "= "
         "Exit_NONE) & (P_exit_9' = Exit_Sub_EXITED);",  // 6
         "[] scpc_8 = P & lock_7 = t1 & P_exit_9 = Exit_EXITED -> (P_exit_9' = Exit_NONE) & (scpc_8' = B) & (lock_7' = "
         "LOCK_FREE);"});  // 7
    // The numbers are the kinds of steps of an exit (R10). To reach A, there are four states: i, P at i, Q at i, A.
    // From A by t1 of Q's parent, there are 5 more states and then A again: locked, (2), 4/2, 5, 7: Q at i with another
    // lock. By t1 of P, there are 8 states and then B: locked, (2), 3, (2), 4/2, 5, 6, 5, 7. A and B loop. A has three
    // choices.
    expect_size(nested, {4 + 5 + 8 + 1, 3 + 3 + 5 + 8 + 1});
}

TEST(Rules, R11ASubstateThatIsNotLeftLoops) {
    expect_lines({"state P { initial i state A { } transition t0 { from i to A } } transition t0 { from i to P }", "",
                  "", "", ""},
                 {"[] scpc_8 = P & P_scpc_8 = P_A & lock_7 = LOCK_FREE -> (P_scpc_8' = P_loop_1) & (lock_7' = "
                  "LOCK_FREE);",
                  "[] scpc_8 = P & P_scpc_8 = P_loop_1 & lock_7 = LOCK_FREE -> (P_scpc_8' = P_loop_1) & (lock_7' = "
                  "LOCK_FREE);"});
}

/// Returns two machines: s sends e to t indefinitely. `type` is the type of e.
std::string two_machines(const std::string& connection, const std::string& type) {
    const std::string value = type.empty() ? "" : " ! 1";
    const std::string taken = type.empty() ? "" : " ? x";
    const std::string event = "event e" + (type.empty() ? "" : " : " + type);
    return "robotic platform R { }\n"
           "stm S { " +
           event +
           " initial i state A { } transition t0 { from i to A }\n"
           "  transition t1 { from A to A action e" +
           value +
           " } }\n"
           "stm T { " +
           event +
           " var x : nat initial i state A { } transition t0 { from i to A }\n"
           "  transition t1 { from A to A trigger e" +
           taken +
           " } }\n"
           "controller C { sref s = S sref t = T connection s on e to t on e" +
           connection +
           " }\n"
           "module M { rref r = R cref c = C }\n";
}

TEST(Rules, R12ABufferLosesWhatIsOverwritten) {
    const auto model = encode_model(two_machines(" (_async)", ""));
    ASSERT_TRUE(model->emission) << model->report();
    EXPECT_THAT(model->lines("M_c_"),
                IsSupersetOf(Lines{"BUF_e_17_f : bool init false;", "[OUT_BUF__e_17] true -> (BUF_e_17_f' = true);",
                                   "[IN_BUF__e_17] BUF_e_17_f = true -> (BUF_e_17_f' = false);",
                                   "[OUT_BUF__e_17] s_scpc_8 = Action_16 -> (s_scpc_8' = s_A) & (s_lock_7' = "
                                   "s_LOCK_FREE);"}));
    // s has the states i, A and sending, and t has i and A. The buffer is empty until s has sent once. With an empty
    // buffer there are (i,A,sending) x (i,A) = 6 states, with a full one (A,sending) x (i,A) = 4.
    EXPECT_EQ(testing::size_of(*model).states, 10U);
}

TEST(Rules, R12TheBufferIsOfTheConnectionNotOfThePlatform) {
    const Parts parts{
        "event e event f state A { } transition t0 { from i to A }\n"
        "transition t1 { from A to A trigger e } transition t2 { from A to A action f }",
        "", "event e event f", "event e event f connection C on e to s on e connection s on f to C on f",
        "connection r on e to c on e (_async) connection c on f to r on f (_async)"};
    expect_lines(parts, {"module M_R", "[RP__e_16] true -> true;", "[RP__f_18] true -> true;",
                         "[RP__e_16] scpc_8 = A & lock_7 = LOCK_FREE -> (scpc_8' = A) & (lock_7' = LOCK_FREE);"});
}

TEST(Rules, ASynchronousConnectionIsOneLabel) {
    const auto model = encode_model(two_machines("", ""));
    ASSERT_TRUE(model->emission) << model->report();
    EXPECT_THAT(
        model->lines("M_c_"),
        IsSupersetOf(Lines{"[SYNC__e_17] s_scpc_8 = Action_16 -> (s_scpc_8' = s_A) & (s_lock_7' = s_LOCK_FREE);",
                           "[SYNC__e_17] t_scpc_8 = t_A & t_lock_7 = t_LOCK_FREE -> (t_scpc_8' = t_A) & "
                           "(t_lock_7' = t_LOCK_FREE);"}));
    EXPECT_EQ(testing::size_of(*model).states, 6U);
}

TEST(Rules, ASynchronousConnectionThatOneMachineUsesBlocksIt) {
    const auto model = encode_model(
        "robotic platform R { }\n"
        "stm S { event e initial i state A { } transition t0 { from i to A } transition t1 { from A to A action e } }\n"
        "stm T { event e initial i state A { } transition t0 { from i to A } }\n"
        "controller C { sref s = S sref t = T connection s on e to t on e }\n"
        "module M { rref r = R cref c = C }\n");
    ASSERT_TRUE(model->emission) << model->report();
    EXPECT_TRUE(model->lines("M_c_").contains("[SYNC__e_17] false -> true;"));
    // s has the states i, A and waiting to send, and t has i and A. Both stop while they wait.
    EXPECT_EQ(testing::size_of(*model).states, 6U);
}

TEST(Rules, R13ABufferOfValuesTakesThreeSteps) {
    const auto model = encode_model(two_machines(" (_async)", "nat"));
    ASSERT_TRUE(model->emission) << model->report();
    EXPECT_THAT(
        model->lines("M_c_"),
        IsSupersetOf(Lines{
            "[OUT_BUF__e_17] s_scpc_8 = Action_16 -> (EVT__OUT_BUF__e_17' = 1) & (s_scpc_8' = e_18);",
            "[] s_scpc_8 = e_18 & FIN__OUT_BUF__e_17 = true -> (s_scpc_8' = s_A) & (s_lock_7' = s_LOCK_FREE);",
            "[OUT_BUF__e_17] FIN__IN_BUF__e_17 = true & FIN__OUT_BUF__e_17 = true -> (BUF_e_17_f' = false) & "
            "(FIN__OUT_BUF__e_17' = false);",
            "[] FIN__OUT_BUF__e_17 = false -> (EVT__IN_BUF__e_17' = EVT__OUT_BUF__e_17) & (FIN__OUT_BUF__e_17' = true) "
            "& (BUF_e_17_f' = true);",
            "[IN_BUF__e_17] BUF_e_17_f = true -> (BUF_e_17_f' = false);",
            "[IN_BUF__e_17] t_scpc_8 = t_A & t_lock_7 = t_LOCK_FREE & FIN__IN_BUF__e_17 = true -> (FIN__IN_BUF__e_17' "
            "= "
            "false) & (t_scpc_8' = e_19) & (t_lock_7' = t_t1);",
            "[] t_scpc_8 = e_19 -> (t_x' = EVT__IN_BUF__e_17) & (FIN__IN_BUF__e_17' = true) & (t_scpc_8' = t_A) & "
            "(t_lock_7' = t_LOCK_FREE);"}));
    (void)testing::size_of(*model);
}

TEST(Rules, R13ThePlatformOffersEachValue) {
    const Parts parts{
        "event e : nat event f : boolean var x : nat state A { } transition t0 { from i to A }\n"
        "transition t1 { from A to A trigger e ? x condition x > 0 action f ! (x == 2) }",
        "", "event e : nat event f : boolean",
        "event e : nat event f : boolean connection C on e to s on e connection s on f to C on f",
        "connection r on e to c on e (_async) connection c on f to r on f (_async)"};
    expect_lines(
        parts, {"[RP__e_16] true -> (EVT__RP__e_16' = 0);", "[RP__e_16] true -> (EVT__RP__e_16' = 1);",
                "[RP__e_16] true -> (EVT__RP__e_16' = 2);", "EVT__RP__e_16 : [0..2];", "EVT__RP__f_19 : bool;",
                "[RP__e_16] scpc_8 = A & lock_7 = LOCK_FREE & EVT__RP__e_16 > 0 & FIN__RP__e_16 = true -> "
                "(FIN__RP__e_16' = false) & (scpc_8' = e_17) & (lock_7' = sp1_2);",
                "[] scpc_8 = e_17 -> (x' = EVT__RP__e_16) & (FIN__RP__e_16' = true) & (scpc_8' = sp_pj_1);",
                "[RP__f_19] scpc_8 = Action_18 -> (EVT__RP__f_19' = x = 2) & (scpc_8' = A) & (lock_7' = LOCK_FREE);"});
}

TEST(Rules, R14AnOperationIsCalledAndWaitedFor) {
    const Parts parts{"requires O state A { entry add(2) } var x : nat transition t0 { from i to A }",
                      "interface O { add(n : nat) }\n"
                      "operation add(n : nat) { var y : nat initial i final f state B { }\n"
                      "  transition t0 { from i to B } transition t1 { from B to f action y = n } }",
                      "", "opref add_ref = add", ""};
    const auto model = encode_model(model_text(parts));
    ASSERT_TRUE(model->emission) << model->report();
    EXPECT_THAT(
        model->lines("M_c_s_"),
        IsSupersetOf(Lines{
            "[] scpc_8 = A_entering & add_scpc_8 = add_INACTIVE_10 -> (add_scpc_8' = add_i) & (add_n' = 2);",
            "[] scpc_8 = A_entering & add_scpc_8 = add_TERMINATED_11 -> (add_scpc_8' = add_INACTIVE_10) & (scpc_8' = "
            "A) & (lock_7' = LOCK_FREE);",
            "[] add_scpc_8 = add_i -> (add_scpc_8' = add_B) & (add_lock_7' = add_LOCK_FREE);",
            "[] add_scpc_8 = Action_16 -> (add_y' = add_n) & (add_scpc_8' = add_f) & (add_lock_7' = add_LOCK_FREE);",
            "const int add_TERMINATED_11 = add_f;", "add_n : [0..2];", "add_y : [0..2];",
            "add_scpc_8 : [0..4] init add_INACTIVE_10;"}));
    // The states are: i; entering A with the operation inactive, at i, at B, in the action, at f; and A. No further
    // step is possible in A, so it gets a loop.
    expect_size(parts, {7, 7});
}

TEST(Rules, R15ClocksAreTrue) {
    expect_lines(
        {"var b : boolean = false clock T state A { } state B { entry b = true <{ 0 } } transition t0 { from i to A }\n"
         "transition t1 { from A to B condition b == false /\\ since(T) > 1 }\n"
         "transition t2 { from B to A condition since(T) > 1 }",
         "", "", "", ""},
        {"[] scpc_8 = A & lock_7 = LOCK_FREE & (b = false & true) -> (scpc_8' = B_entering) & (lock_7' = t1);",
         "[] scpc_8 = B & lock_7 = LOCK_FREE -> (scpc_8' = A) & (lock_7' = LOCK_FREE);",
         "[] scpc_8 = B_entering -> (b' = true) & (scpc_8' = B) & (lock_7' = LOCK_FREE);"});
}

TEST(Rules, R16FunctionsAreReplacedByTheirResult) {
    expect_lines({"var x : nat state A { entry x = half(x + 1) } transition t0 { from i to A }",
                  "function half(a : nat) : nat { postcondition result == if a > 1 then 1 else 0 end }", "", "", ""},
                 {"[] scpc_8 = A_entering -> (x' = x + 1 > 1 ? 1 : 0) & (scpc_8' = A) & (lock_7' = LOCK_FREE);"});
}

}  // namespace
}  // namespace robochart::prism_emit
