// SPDX-License-Identifier: Apache-2.0
// Tests rules in SLEEC in an editor.
#include <gtest/gtest.h>

#include "tests/editors/server/client.hpp"
#include "tests/temporary_folder.hpp"

namespace robochart::lsp {
namespace {

using testing::Answer;
using testing::Client;

constexpr const char* uri = "file:///p/care.sleec";
constexpr const char* rules =
    "def_start\n"                                                     // 0
    "    event Go\n"                                                  // 1
    "    event Stop\n"                                                // 2
    "    measure load : scale(low, high)\n"                           // 3
    "    constant MAX = 5\n"                                          // 4
    "def_end\n"                                                       // 5
    "rule_start\n"                                                    // 6
    "    R1 when Go and load >= high then Stop within MAX seconds\n"  // 7
    "    R2 when Stop then not Go within 2 seconds\n"                 // 8
    "rule_end\n";                                                     // 9

Json place(std::int64_t line, std::int64_t character) {
    return Json::object({{"textDocument", Json::object({{"uri", uri}})},
                         {"position", Json::object({{"line", line}, {"character", character}})}});
}

std::string hovered(Client& client, std::int64_t line, std::int64_t character) {
    return client.request("textDocument/hover", place(line, character))["contents"]["value"].text();
}

/// Returns the labels that are offered at the end of a text.
std::string offered(const std::string& text, const std::string& at = uri) {
    Client client;
    client.open(at, text);
    Json params = place(0, 0);
    params["textDocument"]["uri"] = at;
    params["position"] = client.position_of(text.size(), at);
    const Answer answer = client.request("textDocument/completion", params);
    std::string labels;
    const Answer items = answer["items"];
    for (const Answer& item : items.items()) labels += (labels.empty() ? "" : " ") + item["label"].text();
    return labels;
}

TEST(RuleTexts, AreCheckedWhileTyping) {
    Client client;
    client.open(uri, rules);
    EXPECT_TRUE(client.diagnostics(uri).is_null()) << "nothing to say, nothing said";
    client.change(uri, "def_start event Go def_end rule_start\nR when Go then Halt rule_end\n");
    EXPECT_EQ(client.codes(uri), "SLEEC-T01@2");
    client.change(uri, "def_start event def_end rule_start rule_end\n");
    EXPECT_EQ(client.codes(uri), "SLEEC-P01@1");
    client.change(uri, rules);
    EXPECT_EQ(client.diagnostics(uri), Json::array());
    client.change(uri, "def_start event def_end rule_start rule_end\n");
    client.close(uri);
    EXPECT_EQ(client.diagnostics(uri), Json::array()) << "what is closed has no findings";
}

TEST(RuleTexts, HoverShowsWhatANameIs) {
    Client client;
    client.open(uri, rules);
    EXPECT_EQ(hovered(client, 7, 12), "```sleec\nevent Go\n```\nin R1, R2");
    EXPECT_EQ(hovered(client, 7, 20), "```sleec\nmeasure load : scale(low, high)\n```\nin R1");
    EXPECT_EQ(hovered(client, 7, 29), "a value of load : scale(low, high)");
    EXPECT_EQ(hovered(client, 7, 50), "```sleec\nconstant MAX = 5\n```\nin R1");
    EXPECT_EQ(hovered(client, 8, 5), "```sleec\nR2 when Stop then not Go within 2 seconds\n```");
    EXPECT_NE(hovered(client, 8, 30).find("does not come up to then"), std::string::npos);
    EXPECT_TRUE(client.request("textDocument/hover", place(0, 2)).is_null());
}

TEST(RuleTexts, DefinitionsAreInTheFile) {
    Client client;
    client.open(uri, rules);
    const Answer found = client.request("textDocument/definition", place(7, 50));
    EXPECT_EQ(found[0]["uri"].text(), uri);
    EXPECT_EQ(found[0]["range"]["start"]["line"].number(), 4);
    EXPECT_EQ(found[0]["range"]["start"]["character"].number(), 13);
    const Answer literal = client.request("textDocument/definition", place(7, 29));
    EXPECT_EQ(literal[0]["range"]["start"]["line"].number(), 3);
    EXPECT_TRUE(client.request("textDocument/definition", place(7, 10)).is_null()) << "a word of the language";
}

TEST(RuleTexts, HaveAnOutline) {
    Client client;
    client.open(uri, rules);
    const Answer symbols =
        client.request("textDocument/documentSymbol", Json::object({{"textDocument", Json::object({{"uri", uri}})}}));
    std::string names;
    for (const Answer& symbol : symbols.items()) names += symbol["name"].text() + " ";
    EXPECT_EQ(names, "Go Stop load MAX R1 R2 ");
    EXPECT_EQ(symbols[4]["range"]["start"]["line"].number(), 7);
}

TEST(RuleTexts, CompletionFitsThePlace) {
    const std::string begun =
        "def_start event Go event Stop measure load : scale(low, high) measure near : boolean constant MAX = 5 "
        "def_end\n"
        "rule_start R when ";
    EXPECT_EQ(offered(begun), "Go Stop");
    EXPECT_EQ(offered(begun + "Go and "), "load near MAX not true false in");
    EXPECT_EQ(offered(begun + "Go and load >= "), "low high");
    EXPECT_EQ(offered(begun + "Go then "), "Go Stop not");
    EXPECT_EQ(offered(begun + "Go then not "), "Go Stop");
    EXPECT_EQ(offered(begun + "Go then Stop within "), "MAX");
    EXPECT_EQ(offered(begun + "Go then Stop within 5 "), "seconds minutes hours days");
    EXPECT_EQ(offered(begun + "Go then Stop within MAX sec"), "seconds minutes hours days") << "the editor filters";
    EXPECT_EQ(offered("def_start measure m : "), "boolean numeric scale");
    EXPECT_EQ(offered("def_start event "), "") << "a new name";
    EXPECT_EQ(offered("def_start // ev"), "") << "a comment";
    EXPECT_EQ(offered(""), "def_start");
}

TEST(RuleTexts, AreFormatted) {
    Client client;
    client.open(uri, "def_start event Go def_end rule_start R when Go then Go rule_end");
    const Answer edits =
        client.request("textDocument/formatting", Json::object({{"textDocument", Json::object({{"uri", uri}})}}));
    EXPECT_EQ(client.applied(edits, uri),
              "def_start\n    event Go\ndef_end\nrule_start\n    R when Go then Go\nrule_end\n");
    client.change(uri, "def_start event");
    const Answer refused =
        client.ask("textDocument/formatting", Json::object({{"textDocument", Json::object({{"uri", uri}})}}));
    EXPECT_TRUE(refused.has("error"));
}

TEST(RuleTexts, WhatIsKnownOfModelsAloneIsNotAnswered) {
    Client client;
    client.open(uri, rules);
    EXPECT_TRUE(client.request("textDocument/references", place(7, 12)).is_null());
    EXPECT_TRUE(
        client.ask("textDocument/hover", Json::object({{"textDocument", Json::object({{"uri", "file:///p/b.sleec"}})}}))
            .has("error"));
}

/// Open files have the editor's text, other files the text on disk.
TEST(RuleTexts, RulesAreOfferedBehindConformsTo) {
    const tests::TemporaryFolder folder;
    folder.write("a.sleec", "def_start event Go def_end rule_start OnDisk when Go then Go rule_end");
    folder.write("b.sleec", "def_start event Go def_end rule_start Old when Go then Go rule_end");
    Client client;
    client.open(uri_of_path(folder.in("b.sleec")),
                "def_start event Go def_end rule_start New when Go then Go rule_end");
    const std::string claims = uri_of_path(folder.in("c.assertions"));
    const std::string text = "sleec assertion A : M conforms to ";
    client.open(claims, text);
    const Answer answer = client.request("textDocument/completion",
                                         Json::object({{"textDocument", Json::object({{"uri", claims}})},
                                                       {"position", client.position_of(text.size(), claims)}}));
    std::string labels;
    const Answer items = answer["items"];
    for (const Answer& item : items.items()) labels += item["label"].text() + " ";
    EXPECT_EQ(labels, "OnDisk New ");
}

TEST(RuleTexts, StatesOfTheModelAreOfferedBehindIn) {
    const tests::TemporaryFolder folder;
    folder.write("m.rct",
                 "stm Robot { initial i state Outer { initial k state Inner { } transition b { from k to Inner } } "
                 "transition t { from i to Outer } }");
    const std::string at = uri_of_path(folder.in("r.sleec"));
    const std::string begin = "def_start event Go def_end rule_start R when Go and in ";
    EXPECT_EQ(offered(begin, at), "Outer Outer::Inner");
    EXPECT_EQ(offered(begin + "Outer::I", at), "Inner");
    EXPECT_EQ(offered(begin), "");
}

TEST(RuleTexts, HostileTextsAreHarmless) {
    std::string deep = "def_start event Go def_end rule_start R when Go then ";
    for (int i = 0; i < 5000; ++i) deep += "Go within 1 seconds otherwise {";
    for (const std::string& text : {deep, std::string("\xff\xfe\x00{{{{", 7), std::string(100'000, '('),
                                    std::string("def_start measure m : scale(") + std::string(10'000, ',')}) {
        Client client;
        client.open(uri, text);
        EXPECT_FALSE(client.diagnostics(uri).is_null());
        (void)client.request("textDocument/completion", place(0, 20));
        (void)client.request("textDocument/hover", place(0, 20));
        (void)client.request("textDocument/documentSymbol",
                             Json::object({{"textDocument", Json::object({{"uri", uri}})}}));
    }
}

}  // namespace
}  // namespace robochart::lsp
