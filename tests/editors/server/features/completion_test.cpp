// SPDX-License-Identifier: Apache-2.0
// Tests completion: the words that are possible at a place in unfinished text.
#include <gtest/gtest.h>

#include <set>

#include "tests/editors/server/client.hpp"

namespace robochart::lsp {
namespace {

using testing::Answer;
using testing::Client;

constexpr const char* library =
    "package lib\n"
    "enumeration Colour { red green }\n"
    "datatype Point { px : nat py : Point2 }\n"
    "datatype Point2 { deep : nat }\n"
    "interface Ops { turn(by : nat) }\n"
    "interface Vars { var speed : nat var point : Point var many : Seq(Point) }\n"
    "interface Evs { event bump event left : nat }\n"
    "function norm(v : nat) : nat { }\n"
    "stm Other { initial i state A { } transition t { from i to A } }\n"
    "controller Ctl { sref s = Other }\n"
    "robotic platform Rob { event out }\n";

class Completion : public ::testing::Test {
protected:
    Completion() { client.open("file:///p/lib.rct", library); }

    /// Returns the labels that are offered at `$` in a text that imports the library.
    std::set<std::string> labels(std::string text, const std::string& uri = "file:///p/a.rct") {
        if (uri.ends_with(".rct")) text = "package own\nimport lib::*\n" + text;
        const std::size_t place = text.find('$');
        text.replace(place, 1, "/*^here*/");
        // The mark must not separate the cursor from the unfinished word before it.
        const std::size_t mark = text.find("/*^here*/");
        text.erase(mark, 9);
        client.open(uri, text);
        const Json params =
            Json::object({{"textDocument", Json::object({{"uri", uri}})}, {"position", client.position_of(mark, uri)}});
        items = client.request("textDocument/completion", params)["items"];
        std::set<std::string> result;
        for (const Answer& item : items.items()) result.insert(item["label"].text());
        return result;
    }
    /// Returns the labels that are offered in a machine with variables, events, clocks and operations.
    std::set<std::string> in_machine(const std::string& members) {
        return labels(
            "stm S {\n  requires Ops requires Vars uses Evs\n  var mine : nat clock C\n  initial i0 final f0\n"
            "  state A { state A1 { } }\n  state B { }\n" +
            members + "\n}\nstm Next { }\n");
    }
    static bool has(const std::set<std::string>& labels, std::initializer_list<const char*> all) {
        for (const char* label : all)
            if (!labels.contains(label)) return false;
        return true;
    }
    static bool none(const std::set<std::string>& labels, std::initializer_list<const char*> all) {
        for (const char* label : all)
            if (labels.contains(label)) return false;
        return true;
    }

    Client client;
    Answer items;
};

using Labels = std::set<std::string>;

TEST_F(Completion, NodesOfTheContainer) {
    EXPECT_EQ(in_machine("  transition t { from $ }"), (Labels{"i0", "A", "B"}));
    EXPECT_EQ(in_machine("  transition t { from A to $ }"), (Labels{"f0", "A", "B"}));
    EXPECT_EQ(in_machine("  transition t { from A to B$"), (Labels{"f0", "A", "B"})) << "the brace is missing";
    EXPECT_EQ(in_machine("  state D { state D1 { } initial d transition x { from $"), (Labels{"D1", "d"}));
}

TEST_F(Completion, EventsAfterTrigger) {
    EXPECT_EQ(in_machine("  transition t { from A to B trigger $ }"), (Labels{"bump", "left"}));
    EXPECT_EQ(in_machine("  transition t { from A to B trigger le$"), (Labels{"bump", "left"}));
    EXPECT_EQ(in_machine("  state D { entry send $ }"), (Labels{"bump", "left"}));
    EXPECT_EQ(in_machine("  transition t { from A to B trigger left?$ }"), (Labels{"speed", "point", "many", "mine"}));
}

TEST_F(Completion, InterfacesAfterTheirClauses) {
    EXPECT_EQ(labels("stm S { uses $ }"), (Labels{"Ops", "Vars", "Evs", "lib", "own"}));
    EXPECT_EQ(labels("stm S { requires Ops, $ }"), (Labels{"Ops", "Vars", "Evs", "lib", "own"}));
    EXPECT_EQ(labels("stm S { requires lib::$ }"), (Labels{"Ops", "Vars", "Evs"}));
}

TEST_F(Completion, TypesAfterAColon) {
    const Labels found = labels("interface I { var x : $ }");
    EXPECT_TRUE(has(found, {"nat", "real", "Seq(", "Colour", "Point", "lib"}));
    EXPECT_TRUE(none(found, {"Ops", "norm", "red", "var"}));
    EXPECT_TRUE(has(labels("interface I { var x : Seq(Po$ }"), {"Point", "nat"}));
    EXPECT_TRUE(has(labels("interface I { var x : nat * $"), {"Point", "nat"}));
    EXPECT_EQ(labels("interface I { var x : lib::$ }"), (Labels{"Colour", "Point", "Point2"}));
    EXPECT_EQ(labels("interface I { var $ }"), Labels()) << "a new name";
}

TEST_F(Completion, WhatReferencesReferTo) {
    EXPECT_EQ(labels("controller C { sref s = $ }"), (Labels{"Other", "lib", "own"}));
    EXPECT_EQ(labels("module M { cref c = $ }"), (Labels{"Ctl", "lib", "own"}));
    EXPECT_EQ(labels("module M { rref c = lib::$ }"), (Labels{"Other", "Ctl", "Rob", "Colour", "red", "green", "Ops",
                                                              "Point", "Point2", "Vars", "Evs", "norm"}));
}

TEST_F(Completion, ValuesInExpressions) {
    for (const char* text : {"  transition t { from A to B condition $ }", "  state D { entry mine = $ }",
                             "  state D { entry mine = mine + sp$", "  state D { entry turn($",
                             "  state D { entry left!$", "  transition t { from A to B condition mine == 1 /\\ $"}) {
        const Labels found = in_machine(text);
        EXPECT_TRUE(has(found, {"mine", "speed", "norm", "red", "Colour", "true", "since"})) << text;
        EXPECT_TRUE(none(found, {"bump", "turn", "Ops", "entry", "A", "C"})) << text;
    }
}

TEST_F(Completion, VariablesOfBinders) {
    EXPECT_TRUE(in_machine("  transition t { from A to B condition forall k : nat @ $ }").contains("k"));
    EXPECT_FALSE(in_machine("  transition t { from A to B condition $ }").contains("k"));
}

TEST_F(Completion, ParametersInsideAFunction) {
    EXPECT_TRUE(has(labels("function f(arg : nat) : nat { postcondition result == $ }"), {"arg", "result", "norm"}));
}

TEST_F(Completion, LiteralsOfAnEnumeration) {
    EXPECT_EQ(in_machine("  transition t { from A to B condition Colour::$ }"), (Labels{"red", "green"}));
    EXPECT_EQ(in_machine("  state D { entry mine = lib::Colour::gr$"), (Labels{"red", "green"}));
    EXPECT_EQ(items[0]["detail"].text(), "Colour");
}

TEST_F(Completion, FieldsOfRecords) {
    EXPECT_EQ(in_machine("  transition t { from A to B condition point.$ }"), (Labels{"px", "py"}));
    EXPECT_EQ(in_machine("  state D { entry point.py.$"), (Labels{"deep"}));
    EXPECT_EQ(in_machine("  state D { entry mine = many[1].p$"), (Labels{"px", "py"}));
    EXPECT_EQ(in_machine("  state D { entry mine.$"), Labels()) << "a number has no fields";
}

TEST_F(Completion, ClocksAndStates) {
    EXPECT_EQ(in_machine("  transition t { from A to B #$ }"), (Labels{"C"}));
    EXPECT_EQ(in_machine("  transition t { from A to B condition since($ }"), (Labels{"C"}));
    EXPECT_EQ(in_machine("  transition t { from A to B condition sinceEntry($ }"), (Labels{"A", "A1", "B"}));
}

TEST_F(Completion, StatementsInActions) {
    for (const char* text : {"  state D { entry $ }", "  transition t { from A to B action $ }",
                             "  state D { entry mine = 1; $", "  state D { during if true then $"}) {
        const Labels found = in_machine(text);
        EXPECT_TRUE(has(found, {"turn", "bump", "mine", "skip", "wait"})) << text;
        EXPECT_TRUE(none(found, {"A", "Ops", "transition"})) << text;
    }
}

TEST_F(Completion, WordsThatBeginMembers) {
    EXPECT_TRUE(has(labels("$"), {"stm", "interface", "module", "stm … {}"}));
    EXPECT_TRUE(has(in_machine("  $"), {"state", "transition", "var", "state … {}", "transition … {}"}));
    EXPECT_TRUE(none(in_machine("  $"), {"stm", "entry", "sref"}));
    EXPECT_TRUE(has(in_machine("  state D { $ }"), {"entry", "during", "exit", "state"}));
    EXPECT_TRUE(has(labels("controller C { $ }"), {"sref", "stm", "operation", "connection", "uses"}));
    EXPECT_TRUE(has(labels("module M { $ }"), {"cref", "rref", "connection"}));
    EXPECT_EQ(in_machine("  transition t { $ }"), (Labels{"from"}));
    EXPECT_TRUE(none(in_machine("  transition t { from A to B $ }"), {"from", "to", "state"}));
    EXPECT_TRUE(has(in_machine("  transition t { from A to B $ }"), {"trigger", "condition", "action"}));
    EXPECT_TRUE(none(in_machine("  transition t { from A to B condition true $ }"), {"trigger", "condition"}));
    EXPECT_TRUE(has(in_machine("  transition t { from A to B condition true $ }"), {"action"}));
}

TEST_F(Completion, ConnectionsStepByStep) {
    const std::string before =
        "robotic platform R { event out1 }\n"
        "controller C { event in1 stm S { event deep } ";
    EXPECT_EQ(labels(before + "connection $ }"), (Labels{"C", "S"}));
    EXPECT_EQ(labels(before + "connection C on $ }"), (Labels{"in1"}));
    EXPECT_EQ(labels(before + "connection C on in1 to S on $"), (Labels{"deep"}));
    EXPECT_EQ(labels(before + "connection C on in1 to $"), (Labels{"C", "S"}));
    EXPECT_EQ(labels(before + "} module M { rref r = R cref c = C connection r on $"), (Labels{"out1"}));
}

TEST_F(Completion, Imports) {
    EXPECT_TRUE(has(labels("import $"), {"lib", "set_toolkit", "sequence_toolkit"}));
    EXPECT_TRUE(has(labels("import lib::$"), {"*", "Colour", "norm"}));
}

TEST_F(Completion, NothingInCommentsStringsAndNewNames) {
    EXPECT_EQ(labels("// says $"), Labels());
    EXPECT_EQ(labels("/* says $ */"), Labels());
    EXPECT_EQ(labels("interface I { const c : string = \"a $ b\" }"), Labels());
    EXPECT_EQ(labels("stm $"), Labels());
    EXPECT_EQ(in_machine("  state $"), Labels());
}

TEST_F(Completion, OfAssertions) {
    const std::string a = "file:///p/a.assertions";
    const Labels subjects = labels("import lib::*\nassertion A1 : $", a);
    EXPECT_TRUE(has(subjects, {"Other", "Ctl", "lib"}));
    EXPECT_TRUE(none(subjects, {"Ops", "red"}));
    EXPECT_EQ(labels("import lib::*\nassertion A1 : Ctl::$", a), (Labels{"s"}));
    EXPECT_EQ(labels("import lib::*\nassertion A1 : lib::Ctl::s::$", a), (Labels{"i", "A"}));
    EXPECT_TRUE(has(labels("import lib::*\nassertion A1 : Ctl is $", a), {"deadlock-free", "deterministic", "not"}));
    EXPECT_TRUE(has(labels("$", a), {"assertion", "timed assertion", "csp"}));
    const Labels in_block = labels("csp P csp-begin P = $ csp-end", a);
    EXPECT_TRUE(has(in_block, {"core_nat", "WAIT_INTERVAL"})) << "names of the script";
    EXPECT_TRUE(none(in_block, {"assertion", "csp"})) << "words of assertions";
}

TEST_F(Completion, ReplacesTheLettersAlreadyWritten) {
    in_machine("  transition t { from A to B trigger le$ }");
    const Answer range = items[0]["textEdit"]["range"];
    EXPECT_EQ(range["end"]["character"].number() - range["start"]["character"].number(), 2);
}

TEST_F(Completion, EscapesNamesThatAreWords) {
    const Labels found =
        labels("enumeration Odd { ^end }\nstm S { var v : Odd initial i state A { entry v = Odd::$ } }");
    EXPECT_EQ(found, (Labels{"end"}));
    EXPECT_EQ(items[0]["textEdit"]["newText"].text(), "^end");
}

TEST_F(Completion, SnippetsOnlyForEditorsThatKnowThem) {
    Client plain(Json::object({}));
    plain.open("file:///p/a.rct", "");
    const Answer found =
        plain.request("textDocument/completion",
                      Json::object({{"textDocument", Json::object({{"uri", "file:///p/a.rct"}})},
                                    {"position", Json::object({{"line", 0}, {"character", 0}})}}))["items"];
    EXPECT_FALSE(found.items().empty());
    for (const Answer& item : found.items()) EXPECT_FALSE(item.has("insertTextFormat"));
}

/// For every prefix of the text, completion answers and offers names and keywords.
TEST_F(Completion, AnywhereInAnyPrefix) {
    const std::string text =
        "package q\nimport lib::*\nstm S {\n  requires lib::Vars uses Evs\n  var a : Seq(nat * Colour) = <>\n  clock "
        "K\n"
        "  initial i\n  state A { entry if speed > 1 then point.px = 2; left!(speed) else skip end }\n"
        "  transition t { from i to A trigger left?speed #K <{ 3 } condition since(K) < 2 /\\ not (Colour::red == "
        "Colour::green) action wait([1, 2]) }\n}\n"
        "controller C { sref s = S connection C on x to s on bump }\n";
    for (std::size_t length = 0; length <= text.size(); ++length) {
        client.open("file:///p/a.rct", text.substr(0, length));
        const Json params = Json::object({{"textDocument", Json::object({{"uri", "file:///p/a.rct"}})},
                                          {"position", client.position_of(length, "file:///p/a.rct")}});
        const Answer found = client.request("textDocument/completion", params);
        for (const Answer& item : found["items"].items()) EXPECT_NE(item["label"].text(), "");
        client.request("textDocument/signatureHelp", params);
        client.request("textDocument/hover", params);
        client.request("textDocument/prepareCallHierarchy", params);
        client.request("textDocument/inlayHint", params);
        Json several = params;
        several["positions"] = Json::array({params["position"]});
        EXPECT_EQ(client.request("textDocument/selectionRange", several).items().size(), 1U);
    }
}

}  // namespace
}  // namespace robochart::lsp
