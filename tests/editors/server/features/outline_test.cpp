// SPDX-License-Identifier: Apache-2.0
// Tests outlines, the search for names, folding and colours.
#include <gtest/gtest.h>

#include "tests/editors/server/client.hpp"

namespace robochart::lsp {
namespace {

using testing::Answer;
using testing::Client;

constexpr const char* outlined_uri = "file:///p/a.rct";
const Json document = Json::object({{"textDocument", Json::object({{"uri", outlined_uri}})}});

/// Returns the symbols as "name(child child(…))".
std::string shape(const Answer& symbols) {
    std::string out;
    for (const Answer& symbol : symbols.items()) {
        const std::string inner = shape(symbol["children"]);
        out += (out.empty() ? "" : " ") + symbol["name"].text() + (inner.empty() ? "" : "(" + inner + ")");
    }
    return out;
}

bool holds(const Answer& outer, const Answer& inner) {
    const auto key = [](const Answer& place) { return place["line"].number() * 100000 + place["character"].number(); };
    return key(outer["start"]) <= key(inner["start"]) && key(inner["end"]) <= key(outer["end"]);
}

void expect_nested(const Answer& symbols) {
    for (const Answer& symbol : symbols.items()) {
        EXPECT_TRUE(holds(symbol["range"], symbol["selectionRange"])) << symbol["name"].text();
        for (const Answer& child : symbol["children"].items())
            EXPECT_TRUE(holds(symbol["range"], child["range"])) << child["name"].text();
        expect_nested(symbol["children"]);
    }
}

constexpr const char* outlined =
    "package p\n"
    "enumeration E { red green }\n"
    "datatype R { hue : E }\n"
    "interface I { var x : nat op(a : nat) event e }\n"
    "controller C {\n"
    "  clock K\n"
    "  stm S {\n"
    "    initial i\n"
    "    state A { state B { } transition inner { from B to B } }\n"
    "    transition t { from i to A }\n"
    "  }\n"
    "  sref s = T\n"
    "}\n";

TEST(Outline, HasProbabilisticAssertionsAndWhatServesThem) {
    Client client;
    client.open("file:///p/a.assertions",
                "label l = true\nrewards r = true : 1; endrewards\nprob property P : Exists [Finally #l]\n"
                "prob generate path Q : using simulation for 10 steps\n");
    const Answer symbols =
        client.request("textDocument/documentSymbol",
                       Json::object({{"textDocument", Json::object({{"uri", "file:///p/a.assertions"}})}}));
    EXPECT_EQ(shape(symbols), "l r P Q");
    EXPECT_EQ(symbols[0]["detail"].text(), "label");
    EXPECT_EQ(symbols[2]["detail"].text(), "prob property");
    EXPECT_EQ(symbols[3]["detail"].text(), "prob generate path");
    expect_nested(symbols);
}

TEST(Outline, HasEverythingWithAName) {
    Client client;
    client.open(outlined_uri, outlined);
    const Answer symbols = client.request("textDocument/documentSymbol", document);
    EXPECT_EQ(shape(symbols), "E(red green) R(hue) I(x op e) C(K S(i A(B inner) t) s)");
    expect_nested(symbols);
    EXPECT_EQ(symbols[2]["children"][0]["detail"].text(), "nat");
    EXPECT_EQ(symbols[2]["children"][1]["detail"].text(), "op(a : nat)");
}

TEST(Outline, OfBrokenTextIsStillThere) {
    Client client;
    std::string text = outlined;
    text.replace(text.find("from i to A"), 11, "from i to");
    text += "stm Last { initial i state Z {\n";
    client.open(outlined_uri, text);
    EXPECT_NE(client.codes(), "");
    const Answer symbols = client.request("textDocument/documentSymbol", document);
    EXPECT_EQ(shape(symbols), "E(red green) R(hue) I(x op e) C(K S(i A(B inner) t) s) Last(i Z)");
    expect_nested(symbols);
}

TEST(Outline, OfAnyPrefixIsWellNested) {
    Client client;
    const std::string text = outlined;
    client.open(outlined_uri, "");
    for (std::size_t length = 0; length <= text.size(); ++length) {
        client.change(outlined_uri, text.substr(0, length));
        const Answer symbols = client.request("textDocument/documentSymbol", document);
        expect_nested(symbols);
        for (const Answer& symbol : symbols.items()) EXPECT_NE(symbol["name"].text(), "");
    }
}

TEST(Outline, IsFlatForEditorsThatWantItSo) {
    Client client(Json::object({}));
    client.open(outlined_uri, outlined);
    const Answer symbols = client.request("textDocument/documentSymbol", document);
    EXPECT_EQ(symbols.items().size(), 18U);
    EXPECT_EQ(symbols[1]["name"].text(), "red");
    EXPECT_EQ(symbols[1]["containerName"].text(), "E");
}

TEST(Outline, OfAssertions) {
    Client client;
    client.open("file:///p/a.assertions",
                "assertion A1 : p::M is deadlock-free\ncsp Spec csp-begin Spec = STOP csp-end\n");
    const Answer symbols =
        client.request("textDocument/documentSymbol",
                       Json::object({{"textDocument", Json::object({{"uri", "file:///p/a.assertions"}})}}));
    EXPECT_EQ(shape(symbols), "A1 Spec");
}

TEST(Search, FindsNamesOverFiles) {
    Client client;
    client.open("file:///p/a.rct", "import set_toolkit::*\ninterface SpeedLimits { const maximum : nat }\n");
    client.open("file:///q/b.rct", "stm Speeding { initial i state A { } transition t { from i to A } }\n");
    const auto found = [&](const std::string& query) {
        return shape(client.request("workspace/symbol", Json::object({{"query", query}})));
    };
    EXPECT_EQ(found("speed"), "SpeedLimits Speeding");
    EXPECT_EQ(found("SLim"), "SpeedLimits");
    EXPECT_EQ(found("maximum"), "maximum");
    EXPECT_EQ(found("union"), "") << "toolkits are inside the program";
    EXPECT_EQ(found("nowhere"), "");
}

TEST(Folds, AreBodiesCommentsAndImports) {
    Client client;
    client.open(outlined_uri,
                "import a::*\nimport b::*\n"  // 0, 1
                "// one\n// two\n"            // 2, 3
                "stm S {\n"                   // 4
                "  state A {\n"               // 5
                "  }\n"                       // 6
                "  state B { }\n"             // 7
                "}\n"                         // 8
                "/* three\n */\n"             // 9, 10
                "interface I {\n");           // 11
    std::string found;
    const Answer folds = client.request("textDocument/foldingRange", document);
    for (const Answer& fold : folds.items())
        found += std::to_string(fold["startLine"].number()) + "-" + std::to_string(fold["endLine"].number()) +
                 fold["kind"].text() + " ";
    EXPECT_EQ(found, "4-7 2-3comment 9-10comment 0-1imports ");
}

TEST(Colours, FollowWhatNamesStandFor) {
    Client client;
    client.open(outlined_uri, "interface I {\n  const k : nat = 1\n}\nstm S { requires I }\n");
    const Answer legend = client.initialized()["capabilities"]["semanticTokensProvider"]["legend"];
    const Answer data = client.request("textDocument/semanticTokens/full", document)["data"];
    std::string found;
    std::int64_t line = 0;
    std::int64_t column = 0;
    for (std::size_t i = 0; i < data.items().size(); i += 5) {
        column = data[i].number() > 0 ? data[i + 1].number() : column + data[i + 1].number();
        line += data[i].number();
        found += std::to_string(line) + ":" + std::to_string(column) + "+" + std::to_string(data[i + 2].number()) +
                 " " + legend["tokenTypes"][static_cast<std::size_t>(data[i + 3].number())].text() + " " +
                 std::to_string(data[i + 4].number()) + "\n";
    }
    EXPECT_EQ(found,
              "0:10+1 interface 1\n"    // I, declared
              "1:8+1 variable 3\n"      // k, declared, readonly
              "1:12+3 type 8\n"         // nat, of the language
              "3:4+1 class 1\n"         // S, declared
              "3:17+1 interface 0\n");  // I
}

}  // namespace
}  // namespace robochart::lsp
