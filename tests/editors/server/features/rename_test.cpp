// SPDX-License-Identifier: Apache-2.0
// Tests that renaming changes every occurrence and nothing else, and preserves the meaning of the model.
#include <gtest/gtest.h>

#include "tests/editors/server/client.hpp"

namespace robochart::lsp {
namespace {

using testing::Answer;
using testing::Client;

class Rename : public ::testing::Test {
protected:
    void open(const std::string& text, const std::string& uri = "file:///p/a.rct") { client.open(uri, text); }
    Answer ask(const std::string& mark, const std::string& name, const std::string& uri = "file:///p/a.rct") {
        Json params = client.at(mark, uri);
        params["newName"] = name;
        return client.ask("textDocument/rename", params);
    }
    /// Returns the text of a document after renaming.
    std::string renamed(const std::string& mark, const std::string& name,
                        const std::string& shown = "file:///p/a.rct") {
        const Answer response = ask(mark, name);
        EXPECT_FALSE(response.has("error")) << response.write();
        return client.edited(response["result"], shown);
    }
    std::string refusal(const std::string& mark, const std::string& name) {
        const Answer response = ask(mark, name);
        EXPECT_EQ(response["error"]["code"].number(), -32803) << response.write();
        return response["error"]["message"].text();
    }

    Client client;
};

/// Replaces every whole word.
std::string replaced(std::string text, const std::string& word, const std::string& by) {
    const auto letter = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
    for (std::size_t at = 0; (at = text.find(word, at)) != std::string::npos; at += by.size()) {
        const bool whole =
            (at == 0 || !letter(text[at - 1])) && (at + word.size() >= text.size() || !letter(text[at + word.size()]));
        if (whole) text.replace(at, word.size(), by);
    }
    return text;
}

constexpr const char* renamed_text =
    "interface I { var /*^v*/speed : nat }\n"
    "stm S {\n  requires I\n  event e : nat\n  initial i\n"
    "  state A { entry speed = speed + 1 }\n"
    "  transition t { from i to A }\n"
    "  transition u { from A to A trigger e?speed condition speed > 3 }\n}\n";

TEST_F(Rename, EveryPlace) {
    open(renamed_text);
    EXPECT_EQ(renamed("v", "velocity"), replaced(renamed_text, "speed", "velocity"));
}

TEST_F(Rename, IsPreparedWithTheName) {
    open(renamed_text);
    const Answer found = client.request("textDocument/prepareRename", client.at("v"));
    EXPECT_EQ(found["placeholder"].text(), "speed");
    EXPECT_EQ(found["range"]["start"]["character"].number(), 24);
}

TEST_F(Rename, OverFilesAndAssertions) {
    open("package p\nstm S {\n  initial i\n  state /*^A*/A { }\n  transition t { from i to A }\n}\n");
    const std::string claims = "import p::*\nassertion A : p::S::A is reachable in p::S\n";
    open(claims, "file:///p/c.assertions");
    EXPECT_EQ(renamed("A", "Moving", "file:///p/c.assertions"),
              "import p::*\nassertion A : p::S::Moving is reachable in p::S\n")
        << "the assertion of the same name stays";
    EXPECT_EQ(renamed("A", "with", "file:///p/c.assertions"),
              "import p::*\nassertion A : p::S::^with is reachable in p::S\n")
        << "a word of assertions alone is escaped there";
    EXPECT_EQ(client.edited(ask("A", "with")["result"]).find('^', 60), std::string::npos);
}

TEST_F(Rename, FieldsLiteralsClocksEventsFunctions) {
    const std::string text =
        "enumeration E { /*^red*/red green }\n"
        "datatype R { /*^hue*/hue : E }\n"
        "function /*^f*/f(/*^a*/a : nat) : nat { postcondition result == a }\n"
        "stm S {\n  var r : R\n  event /*^e*/e\n  clock /*^C*/C\n  initial i\n"
        "  state A { entry r = R(| hue = E::red |); r.hue = red }\n"
        "  transition t { from i to A }\n"
        "  transition u { from A to A trigger e #C condition since(C) > f(1) }\n}\n"
        "controller K { event e sref s = S connection K on e to s on e }\n";
    open(text);
    ASSERT_EQ(client.codes(), "");
    EXPECT_EQ(renamed("red", "crimson"), replaced(text, "red", "crimson").replace(text.find("^red"), 8, "^red"));
    EXPECT_NE(renamed("hue", "colour").find("R(| colour = E::red |); r.colour"), std::string::npos);
    EXPECT_NE(renamed("f", "g").find("since(C) > g(1)"), std::string::npos);
    EXPECT_NE(renamed("a", "b").find("result == b"), std::string::npos);
    EXPECT_NE(renamed("C", "D").find("#D condition since(D)"), std::string::npos);
    const std::string events = renamed("e", "bump");
    EXPECT_NE(events.find("trigger bump"), std::string::npos);
    EXPECT_NE(events.find("connection K on e to s on bump"), std::string::npos) << "the controller's event is another";
}

// C4, language reference 2: an operation implements a signature with the same name.
TEST_F(Rename, AnOperationWithItsSignature) {
    const std::string text =
        "interface Ops { /*^sig*/move() }\n"
        "operation /*^def*/move() { initial i final g transition t { from i to g } }\n"
        "stm S { requires Ops initial i state A { entry move() } transition t { from i to A } }\n"
        "controller C { sref s = S opref o = move }\n";
    open(text);
    ASSERT_EQ(client.codes(), "");
    EXPECT_EQ(renamed("sig", "go"), replaced(text, "move", "go"));
    EXPECT_EQ(renamed("def", "go"), replaced(text, "move", "go"));
}

// C3, M2: a required variable is provided by a variable with the same name.
TEST_F(Rename, ARequiredVariableWithItsProvider) {
    const std::string text =
        "interface Needs { var /*^need*/x : nat }\n"
        "interface Gives { var /*^give*/x : nat }\n"
        "interface Apart { var q : nat }\n"
        "stm S { requires Needs initial i state A { entry x = 1 } transition t { from i to A } }\n"
        "controller C { requires Needs sref s = S }\n"
        "robotic platform R { provides Gives }\n"
        "module M { rref r = R cref c = C }\n";
    open(text);
    ASSERT_EQ(client.codes(), "");
    EXPECT_EQ(renamed("need", "y"), replaced(text, "x", "y"));
    EXPECT_EQ(renamed("give", "y"), replaced(text, "x", "y"));
}

TEST_F(Rename, ExistingEscapesAreReplacedWhole) {
    open(
        "enumeration E { /*^end*/^end other }\nstm S { var v : E initial i state A { entry v = E::^end } "
        "transition t { from i to A } }\n");
    const std::string text = renamed("end", "last");
    EXPECT_NE(text.find("/*^end*/last other"), std::string::npos) << text;
    EXPECT_NE(text.find("E::last"), std::string::npos) << text;
}

TEST_F(Rename, RefusesWhatIsNoName) {
    open(renamed_text);
    for (const char* name : {"", "1a", "a-b", "a b", "^", "ä", "a::b"})
        EXPECT_NE(refusal("v", name).find("no name"), std::string::npos) << name;
    EXPECT_NE(refusal("v", "end").find("reserved word"), std::string::npos);
    EXPECT_NE(renamed("v", "^end").find("var /*^v*/^end : nat"), std::string::npos) << "asked for with its escape";
}

TEST_F(Rename, RefusesNamesThatAreTaken) {
    open(
        "interface I { var /*^a*/a : nat var b : nat }\n"
        "stm S { requires I initial i state /*^A*/A { entry a = b } state B { }\n"
        "  transition t { from i to A } transition u { from A to B } }\n");
    ASSERT_EQ(client.codes(), "");
    refusal("a", "b");
    refusal("A", "B");
    refusal("A", "i");
}

TEST_F(Rename, RefusesToCaptureOtherNames) {
    open(
        "enumeration E { /*^lit*/on1 off1 }\n"
        "stm S { var light : E var x : E initial i state A { entry x = on1 } transition t { from i to A } }\n");
    ASSERT_EQ(client.codes(), "");
    EXPECT_NE(refusal("lit", "light"), "") << "the variable would hide the literal";
}

TEST_F(Rename, RefusesWhatIsNotTheProjects) {
    open(
        "import set_toolkit::*\n"
        "interface I { const c : boolean = /*^lib*/subset({1}, {2}) const d : /*^nat*/nat = 1 const e : /*^lost*/lost "
        "= 1 "
        "}\n"
        "function f(a : ?/*^var*/X) : nat { }\n");
    EXPECT_NE(refusal("lib", "x").find("comes with the tool"), std::string::npos);
    EXPECT_NE(refusal("nat", "x").find("language"), std::string::npos);
    refusal("lost", "x");
    refusal("var", "x");
    Json params = client.at("lib");
    EXPECT_EQ(client.ask("textDocument/prepareRename", params)["error"]["code"].number(), -32803);
}

TEST_F(Rename, SaysWhereCspTextSpeaksOfTheName) {
    open("package p\nstm S { initial i state /*^A*/Moving { } transition t { from i to Moving } }\n");
    open("import p::*\ncsp Spec csp-begin Spec = Moving -> STOP csp-end\n", "file:///p/c.assertions");
    renamed("A", "Going");
    bool reported = false;
    for (const Answer& message : client.messages)
        reported = reported || (message["method"].text() == "window/showMessage" &&
                                message["params"]["message"].text().find("`Moving`") != std::string::npos);
    EXPECT_TRUE(reported);
}

TEST_F(Rename, Packages) {
    open("package /*^p*/p\ninterface I { }\n");
    open("import p::*\nrobotic platform R { provides p::I }\n", "file:///p/b.rct");
    EXPECT_EQ(renamed("p", "q", "file:///p/b.rct"), "import q::*\nrobotic platform R { provides q::I }\n");
}

TEST_F(Rename, WorksInBrokenText) {
    open(std::string(renamed_text) + "stm Broken { initial\n");
    EXPECT_EQ(renamed("v", "velocity"),
              replaced(std::string(renamed_text) + "stm Broken { initial\n", "speed", "velocity"));
}

}  // namespace
}  // namespace robochart::lsp
