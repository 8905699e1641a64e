// SPDX-License-Identifier: Apache-2.0
// Tests that constructs without an encoding are rejected with a named rule. For each rule of prism/emit/rules.hpp there
// is one model that violates only this rule.
#include <gtest/gtest.h>

#include "tests/prism/emit/models.hpp"

namespace robochart::prism_emit {
namespace {

using testing::encode_model;

/// Returns the codes of the errors in a model with one machine.
std::string refusal_codes(const std::string& machine, const std::string& top = "", const std::string& outside = "",
                          const std::string& inside = "", const std::string& connections = "") {
    const auto model = encode_model(top + "\nrobotic platform R { " + outside + " }\nstm S { initial i\n" + machine +
                                    "\n}\ncontroller C { sref s = S " + inside +
                                    " }\nmodule M { rref r = R cref c = C " + connections + " }\n");
    EXPECT_FALSE(model->emission);
    return model->codes();
}

const std::string begin = "transition t0 { from i to A } ";

TEST(Refusals, Constructs) {
    EXPECT_EQ(refusal_codes(begin + "var x : nat state A { exit x = 1 }"), "RC-E02");
    EXPECT_EQ(refusal_codes(begin + "var x : nat state A { during x = 1 }"), "RC-E02");
    EXPECT_EQ(refusal_codes(begin + "state A { entry wait(1) }"), "RC-E02");
    EXPECT_EQ(refusal_codes(begin + "var x : nat state A { entry if x > 0 then x = 1 else x = 2 end }"), "RC-E02");
    EXPECT_EQ(refusal_codes(begin + "state A { } final f transition t1 { from A to f }"), "RC-E02");
}

TEST(Refusals, VariablesThatAControllerShares) {
    EXPECT_EQ(refusal_codes("requires I state A { entry x = 1 } " + begin, "interface I { var x : nat }", "", "uses I"),
              "RC-E02");
}

TEST(Refusals, ReceivedValuesThatLeaveACompositeState) {
    const std::string machine =
        "event e : nat var x : nat state A { initial i state B { } transition t0 { from i to B } } " + begin +
        "transition t1 { from A to A trigger e ? x }";
    EXPECT_EQ(refusal_codes(machine, "", "event e : nat", "event e : nat connection C on e to s on e",
                            "connection r on e to c on e (_async)"),
              "RC-E02");
}

TEST(Refusals, ConditionsAfterAnActionBehindATrigger) {
    const std::string machine = "event e var x : nat junction j state A { } " + begin +
                                "transition t1 { from A to j trigger e action x = 1 }\n"
                                "transition t2 { from j to A condition x == 1 }";
    EXPECT_EQ(refusal_codes(machine, "", "event e", "event e connection C on e to s on e",
                            "connection r on e to c on e (_async)"),
              "RC-E02");
}

TEST(Refusals, Types) {
    EXPECT_EQ(refusal_codes(begin + "var x : Seq(nat) state A { }"), "RC-E03");
    EXPECT_EQ(refusal_codes(begin + "var x : string state A { }"), "RC-E03");
    EXPECT_EQ(refusal_codes(begin + "var x : T state A { }", "type T"), "RC-E03");
}

TEST(Refusals, Expressions) {
    EXPECT_EQ(refusal_codes(begin + "var x : real state A { entry x = x / 2 }"), "RC-E04")
        << "a quotient need not be whole";
    EXPECT_EQ(refusal_codes(begin + "var x : real state A { entry x = 0.5 }"), "RC-E04") << "real variables are whole";
    EXPECT_EQ(refusal_codes(begin + "const p : real var x : real state A { entry x = p }"), "RC-E04");
    EXPECT_EQ(refusal_codes(begin + "var x : nat state A { entry x = f(1) }", "function f(a : nat) : nat { }"),
              "RC-E04");
    EXPECT_EQ(refusal_codes(begin + "clock T state A { } transition t1 { from A to A condition not (since(T) > 1) }"),
              "RC-E04")
        << "a clock under a negation";
}

TEST(Refusals, Events) {
    EXPECT_EQ(refusal_codes(begin + "event e state A { } transition t1 { from A to A trigger e }"), "RC-E05")
        << "connected to nothing";
}

std::string codes_of_two(const std::string& connections, const std::string& type) {
    const std::string event = "event e" + (type.empty() ? "" : " : " + type);
    const std::string value = type.empty() ? "" : " ! 1";
    const auto model = encode_model(
        "robotic platform R { }\n"
        "stm S { " +
        event + " initial i state A { entry e" + value +
        " } transition t0 { from i to A } }\n"
        "stm T { " +
        event +
        " var x : nat initial i state A { } transition t0 { from i to A }\n"
        "  transition t1 { from A to A trigger e" +
        (type.empty() ? "" : " ? x") +
        " } }\n"
        "controller C { sref s = S sref t = T " +
        connections + " }\nmodule M { rref r = R cref c = C }\n");
    return model->codes();
}

TEST(Refusals, ValuesOverSynchronousConnections) {
    EXPECT_EQ(codes_of_two("connection s on e to t on e", "nat"), "RC-E05");
}

TEST(Refusals, Operations) {
    EXPECT_EQ(
        refusal_codes("requires O state A { entry go() } " + begin, "interface O { go() }", "provides O", "requires O"),
        "RC-E06")
        << "the platform's";
    EXPECT_EQ(
        refusal_codes("requires O state A { entry go() } " + begin,
                      "interface O { go() } operation go() { initial i final f final g state B { }\n"
                      "transition t0 { from i to B } transition t1 { from B to f } transition t2 { from B to g } }",
                      "", "opref go_ref = go"),
        "RC-E06")
        << "two final states";
}

}  // namespace
}  // namespace robochart::prism_emit
