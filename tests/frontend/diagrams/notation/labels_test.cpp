// SPDX-License-Identifier: Apache-2.0
// Tests the texts of diagrams, which have RoboTool's order and spelling.
#include "frontend/diagrams/notation/labels.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/frontend/diagrams/models.hpp"

namespace robochart::diagrams {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;

/// Returns the pieces of the label of the only transition of a machine.
std::vector<std::string> label_of_transition(const std::string& parts) {
    const auto loaded =
        random_models::load({{"m.rct",
                              "stm M {\n event e : nat\n event o : nat\n var x : nat\n clock C\n clock D\n"
                              " initial i\n state s { }\n transition t { from i to s " +
                                  parts + " }\n}\n"}});
    const auto& machine = dynamic_cast<const frontend::Machine&>(*loaded->model.files.front()->declarations.front());
    return label_of(*machine.transitions.front());
}

TEST(Labels, OfTransitionsAreInRoboToolsOrder) {
    EXPECT_THAT(label_of_transition(""), ElementsAre());
    EXPECT_THAT(label_of_transition("trigger e?x #C #D <{3} condition x > 1 action x = 0"),
                ElementsAre("e?x #C #D <{3}", "[x > 1]", "/x = 0"));
    EXPECT_THAT(label_of_transition("#C"), ElementsAre("#C"));
    EXPECT_THAT(label_of_transition("probability 0.5"), ElementsAre("p{0.5}"));
}

TEST(Labels, LeaveSendOut) {
    EXPECT_THAT(label_of_transition("action send o!x"), ElementsAre("/o!x"));
    EXPECT_THAT(label_of_transition("action if x > 1 then send o!x else skip end; (send o!1) <{2}"),
                ElementsAre("/if x > 1 then o!x else skip end; (o!1) <{2}"));
}

/// Returns all texts in the diagrams of a model.
std::vector<std::string> texts_of(const std::string& model) {
    std::vector<std::string> texts;
    draw_each({{"m.rct", model}}, [&](const DrawnModel& drawn) {
        for (const PictureBox& box : drawn.picture.boxes)
            for (const Text& text : box.texts) texts.push_back(text.text);
    });
    return texts;
}

TEST(Labels, OfComponentsSayWhatTheyDeclare) {
    const auto texts = texts_of(
        "package p\ninterface I { event e : nat event f }\ninterface J { op(a : nat, b : real) terminates var v : nat "
        "= 3 "
        "const c : real }\nenumeration E { one two(nat) }\nrecord R { f : nat }\nfunction g(x : nat) : nat { "
        "precondition x "
        "> 0 postcondition result > x }\noperation op(a : nat, b : real) { terminates precondition a > 0 }\n"
        "stm M { requires J uses I clock C initial i state s { during v = 1 } transition t { from i to s } }\n"
        "controller Ctrl { sref m = M opref o = op }\n");
    for (const char* text :
         {"op(a: nat, b: real) [terminates]", "v: nat = 3", "c: real", "one", "two(nat)", "f: nat", "g(x: nat): nat",
          "x > 0", "result > x", "e: nat", "a > 0", "during v = 1", "C", "J", "ref m = M", "package p"})
        EXPECT_THAT(texts, Contains(text));
}

TEST(Labels, OfRoboSimNameRegistersAndCycles) {
    std::vector<std::string> texts;
    draw_each(
        {{"m.rst",
          "interface I { event go } interface O { op(n : nat) }\nstm M { cycleDef cycle == 1 clock C input context { "
          "uses I event n : nat } output context { requires O } initial i state s { entry $op(1) } transition t { "
          "from i to s } transition u { from s to s exec #C condition $go /\\ $n?x action exec } var x : nat }\n"}},
        [&](const DrawnModel& drawn) {
            for (const PictureBox& box : drawn.picture.boxes)
                for (const Text& text : box.texts) texts.push_back(text.text);
            for (const PictureLine& line : drawn.picture.lines)
                for (const Text& text : line.texts) texts.push_back(text.text);
        });
    for (const char* text : {"cycleDef cycle == 1", "input: uses I, ", "event n: nat", "output: requires O",
                             "entry $op(1)", "exec #C[$go /\\ $n?x]/exec", "go"})
        EXPECT_THAT(texts, Contains(text)) << ::testing::PrintToString(texts);
}

/// Diagrams show unresolved names as they are written.
TEST(Labels, WhatMeansNothingIsDrawnByItsName) {
    const auto texts = texts_of(
        "stm M { initial i transition t { from i to Nowhere } }\n"
        "controller C { sref m = Unknown connection m on e to other on f }\n"
        "module X { rref r = Missing cref c = C connection r on e to c on g }\n");
    for (const char* text : {"Nowhere", "ref m = Unknown", "other", "ref Missing", "e", "f", "g"})
        EXPECT_THAT(texts, Contains(text));
}

}  // namespace
}  // namespace robochart::diagrams
