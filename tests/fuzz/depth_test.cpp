// SPDX-License-Identifier: Apache-2.0
// Tests that nesting and chains of any length are parsed or rejected with a finding, and never overflow the stack.
// Sanitizers make stack frames larger, so the test is most useful with them.
#include <gtest/gtest.h>

#include <array>

#include "tests/fuzz/targets/targets.hpp"

namespace robochart::fuzz {
namespace {

/// Text that consists of `before`, then `open` n times, `middle`, `close` n times, and `after`.
struct Shape {
    std::string_view before, open, middle, close, after;
};

std::string deep(const Shape& shape, std::size_t times) {
    std::string text(shape.before);
    for (std::size_t i = 0; i < times; ++i) text += shape.open;
    text += shape.middle;
    for (std::size_t i = 0; i < times; ++i) text += shape.close;
    return text += shape.after;
}

void expect_bounded(std::string (*run)(std::string_view), std::span<const Shape> shapes) {
    // The depths are close to the limits of the parsers (256, 800, 1000, 4000) and far beyond.
    for (const Shape& shape : shapes)
        for (const std::size_t times : {255U, 1000U, 4001U, 20000U}) {
            EXPECT_EQ(run(deep(shape, times)), "") << shape.before << shape.open << " … x " << times;
            // The same text, truncated in the middle.
            const Shape open{shape.before, shape.open, shape.middle, "", ""};
            EXPECT_EQ(run(deep(open, times)), "") << shape.before << shape.open << " … x " << times << ", open";
        }
}

constexpr std::string_view function = "function f(x: int): int { postcondition ";
constexpr std::string_view entry = "stm M { var x: int state S { entry ";

constexpr std::array expressions = {
    Shape{function, "(", "1", ")", " }"},
    Shape{function, "-", "1", "", " }"},
    Shape{function, "not ", "true", "", " }"},
    Shape{function, "{", "1", "}", " }"},
    Shape{function, "< ", "1", " >", " }"},
    Shape{function, "(|", "1,2", "|)", " }"},
    Shape{function, "[|", "1", "|]", " }"},
    Shape{function, "[", "1", ",2]", " }"},
    Shape{function, "f(", "1", ")", " }"},
    Shape{function, "R(|f=", "1", "|)", " }"},
    Shape{function, "if true then ", "1", " else 2 end", " }"},
    Shape{function, "if ", "true", " then 1 else 2 end", " }"},
    Shape{function, "forall v: int @ ", "true", "", " }"},
    Shape{function, "lambda v: int | ", "true", " @ v", " }"},
    Shape{function, "the v: int | ", "true", " @ v", " }"},
    Shape{function, "let v == ", "1", " @ v", " }"},
    Shape{function, "let v == 1 @ ", "v", "", " }"},
    Shape{function, "{v: int | ", "true", "}", " }"},
    Shape{function, "inverse(", "1", ")", " }"},
    Shape{function, "1 + ", "1", "", " }"},
    Shape{function, "true iff ", "true", "", " }"},
    Shape{function, "x ^ ", "x", "", " }"},
    Shape{function, "x == ", "x", "", " }"},
    Shape{function, "", "x", ".a", " }"},
    Shape{function, "", "x", "[1]", " }"},
    Shape{function, "", "x", "(1)", " }"},
    Shape{function, "", "x", " as int", " }"},
    Shape{function, "a::", "b", "", " }"},
};

constexpr std::array statements = {
    Shape{entry, "(", "skip", ")", " } }"},
    Shape{entry, "skip; ", "skip", "", " } }"},
    Shape{entry, "if true then ", "skip", " end", " } }"},
    Shape{entry, "if true then skip else ", "skip", " end", " } }"},
    Shape{entry, "(", "skip", ") <{1}", " } }"},
    Shape{entry, "wait(", "1", ")", " } }"},
    Shape{entry, "x[", "1", "] = 1", " } }"},
    Shape{entry, "e!(", "1", ")", " } }"},
    Shape{entry, "e[|", "true", "|]", " } }"},
    Shape{entry, "#C; ", "skip", "", " } }"},
};

constexpr std::array declarations = {
    Shape{"stm M { ", "state S { ", "initial i ", "} ", "}"},
    Shape{"stm M { ", "transition t { from a to b ", "", "} ", "}"},
    Shape{"interface I { var x: ", "Set(", "int", ")", " }"},
    Shape{"interface I { var x: ", "(", "int", ")", " }"},
    Shape{"interface I { var x: ", "int -> ", "int", "", " }"},
    Shape{"interface I { var x: ", "int <-> ", "int", "", " }"},
    Shape{"interface I { var x: ", "int * ", "int", "", " }"},
    Shape{"interface I { var x: ", "vector(", "int", ", 1)", " }"},
    Shape{"interface I { var x: int", ", y: int", "", "", " }"},
    Shape{"interface I { uses I", ", I", "", "", " }"},
    Shape{"", "module M { ", "", "} ", ""},
    Shape{"", "stm M { ", "", "} ", ""},
    Shape{"", "/* ", "", "*/ ", ""},
    Shape{"", "{", "", "}", ""},
    Shape{"", "package p ", "", "", ""},
    Shape{"import ", "a::", "*", "", ""},
    Shape{"package ", "a::", "a", "", " stm M { initial i }"},
};

TEST(Depth, Expressions) {
    expect_bounded(run_model, expressions);
}

TEST(Depth, Statements) {
    expect_bounded(run_model, statements);
}

TEST(Depth, Declarations) {
    expect_bounded(run_model, declarations);
}

TEST(Depth, Assertions) {
    constexpr std::array shapes = {
        Shape{"assertion A : ", "a::", "b", "", " is deadlock-free"},
        Shape{"package ", "a::", "b", "", " assertion A : M is deadlock-free"},
        Shape{"", "assertion A : M is deadlock-free ", "", "", ""},
        Shape{"assertion A : M is deterministic with constant c of M set to ", "(", "1", ")", ""},
        Shape{"assertion A : M is deterministic with constant c of M set to 1", " and constant c of M set to 1", "", "",
              ""},
        Shape{"", "csp X csp-begin ", "", "csp-end ", ""},
    };
    expect_bounded(run_assertions, shapes);
}

TEST(Depth, Scripts) {
    constexpr std::array shapes = {
        Shape{"P = ", "(", "1", ")", ""},
        Shape{"P = ", "-", "1", "", ""},
        Shape{"P = ", "not ", "true", "", ""},
        Shape{"P = ", "{", "1", "}", ""},
        Shape{"P = ", "{|", "a", "|}", ""},
        Shape{"P = ", "<", "1", ">", ""},
        Shape{"P = ", "f(", "1", ")", ""},
        Shape{"P = f", "(1)", "", "", ""},
        Shape{"P = ", "a -> ", "STOP", "", ""},
        Shape{"P = ", "a [] ", "a", "", ""},
        Shape{"P = ", "a ; ", "a", "", ""},
        Shape{"P = ", "a . ", "a", "", ""},
        Shape{"P = ", "#", "a", "", ""},
        Shape{"P = a", "[[a <- b]]", "", "", ""},
        Shape{"P = a", " \\ a", "", "", ""},
        Shape{"P = ", "[] x: s @ ", "STOP", "", ""},
        Shape{"P = ", "if a then ", "b", " else c", ""},
        Shape{"P = ", "let x = ", "1", " within x", ""},
        Shape{"P = ", "let x = 1 within ", "x", "", ""},
        Shape{"P = ", "\\ x @ ", "x", "", ""},
        Shape{"P = ", "a [|{", "a", "}|] b", ""},
        Shape{"P(", "(", "x", ")", ") = 1"},
        Shape{"P(", "<x>^", "y", "", ") = 1"},
        Shape{"P(", "x.", "y", "", ") = 1"},
        Shape{"P :: ", "(", "Int", ")", "\nP = 1"},
        Shape{"P :: ", "Int -> ", "Int", "", "\nP = 1"},
        Shape{"P :: ", "{", "Int", "}", "\nP = 1"},
        Shape{"", "module A\n", "", "endmodule\n", ""},
        Shape{"", "Timed(f) {\n", "", "}\n", ""},
        Shape{"", "{-", "", "-}", ""},
        Shape{"channel a : ", "{", "1", "}", ""},
        Shape{"datatype A = ", "B | ", "C", "", ""},
        Shape{"assert ", "(", "P", ")", " [T= P"},
    };
    expect_bounded(run_script, shapes);
}

}  // namespace
}  // namespace robochart::fuzz
