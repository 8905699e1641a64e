// SPDX-License-Identifier: Apache-2.0
// Tests diagnostics while the user types, and their fixes.
#include <gtest/gtest.h>

#include "tests/editors/server/client.hpp"

namespace robochart::lsp {
namespace {

using testing::Answer;
using testing::Client;

constexpr const char* uri = "file:///p/a.rct";

TEST(Published, WhileTyping) {
    Client client;
    client.open(uri, "interface I { var x : nat }\n");
    EXPECT_TRUE(client.diagnostics().is_null()) << "nothing to say, nothing said";
    client.change(uri, "interface I { var x : nta }\n");
    EXPECT_EQ(client.codes(), "RC-N01@1");
    client.change(uri, "interface I { var x : nat }\n");
    EXPECT_EQ(client.diagnostics(), Json::array());
    client.change(uri, "interface I { var x nat }\n");
    EXPECT_EQ(client.codes(), "RC-P01@1");
}

TEST(Published, WithEverythingThatIsKnown) {
    Client client;
    client.open(uri,
                "stm S {\n  initial i\n  state A { initial j state B { } transition k { from j to B } }\n"
                "  transition t { from i to A }\n  transition u { from A to B }\n}\n");
    const Answer found = client.diagnostics();
    ASSERT_EQ(client.codes(), "T1@5");
    EXPECT_EQ(found[0]["severity"].number(), 1);
    EXPECT_EQ(found[0]["source"].text(), "robochart");
    EXPECT_EQ(found[0]["range"].write(), R"({"start":{"line":4,"character":27},"end":{"line":4,"character":28}})");
    EXPECT_EQ(found[0]["relatedInformation"][0]["location"]["range"]["start"].write(), R"({"line":2,"character":28})");
    EXPECT_NE(found[0]["relatedInformation"][0]["message"].text(), "");
}

/// LSP 3.17, DiagnosticTag.Unnecessary: editors fade such text.
TEST(Published, WithATagForWhatCouldBeLeftOut) {
    Client client;
    client.open(uri,
                "stm S {\n  initial i\n  state A { }\n  state B { }\n  transition t { from i to A }\n"
                "  transition u { from A to A }\n}\n");
    bool tagged = false;
    const Answer found = client.diagnostics();
    for (const Answer& finding : found.items())
        if (finding["code"].text() == "RC-W03") tagged = finding["tags"] == Json::array({1});
    EXPECT_TRUE(tagged) << found.write();
}

TEST(Published, WithTheVersionOfTheText) {
    Client client;
    client.open(uri, "interface I { var x : nta }\n");
    EXPECT_EQ(client.messages.back()["params"]["version"].number(), 1);
    client.change(uri, "interface I { var x : nta }\n\n");
    client.change(uri, "\ninterface I { var x : nta }\n");
    EXPECT_EQ(client.messages.back()["params"]["version"].number(), 3);
}

TEST(Published, OnlyWhereSomethingChanged) {
    Client client;
    client.open("file:///p/a.rct", "interface I { var x : lost }\n");
    client.open("file:///p/b.rct", "interface J { var x : gone }\n");
    const std::size_t before = client.messages.size();
    client.change("file:///p/b.rct", "interface J { var x : away }\n");
    ASSERT_EQ(client.messages.size(), before + 1);
    EXPECT_EQ(client.messages.back()["params"]["uri"].text(), "file:///p/b.rct");
}

TEST(Published, ForOtherFilesThatTheChangeTouches) {
    Client client;
    client.open("file:///p/a.rct", "interface I { var x : nat }\n");
    client.open("file:///p/b.rct", "robotic platform R { provides I }\n");
    EXPECT_EQ(client.codes("file:///p/b.rct"), "");
    client.change("file:///p/a.rct", "interface K { var x : nat }\n");
    EXPECT_EQ(client.codes("file:///p/b.rct"), "RC-N01@1");
    client.change("file:///p/a.rct", "interface I { var x : nat }\n");
    EXPECT_EQ(client.codes("file:///p/b.rct"), "");
}

TEST(Published, AreTakenBackWhenATextIsClosed) {
    Client client;
    client.open("untitled:Untitled-1", "interface I { var x : lost }\n");
    EXPECT_EQ(client.codes("untitled:Untitled-1"), "RC-N01@1");
    client.close("untitled:Untitled-1");
    EXPECT_EQ(client.diagnostics("untitled:Untitled-1"), Json::array());
}

TEST(Published, WaitUntilTheEditorIsSilent) {
    Client client;
    client.open(uri, "interface I { }\n");
    const std::size_t before = client.messages.size();
    for (int i = 0; i < 20; ++i) {
        const Json params = Json::object(
            {{"textDocument", Json::object({{"uri", uri}, {"version", i + 2}})},
             {"contentChanges",
              Json::array({Json::object({{"text", "interface I { var x : lost" + std::to_string(i) + " }\n"}})})}});
        client.server().receive_message(
            json_text(Json::object({{"jsonrpc", "2.0"}, {"method", "textDocument/didChange"}, {"params", params}})));
    }
    client.work();
    EXPECT_EQ(client.messages.size(), before + 1);
    EXPECT_NE(client.diagnostics()[0]["message"].text().find("lost19"), std::string::npos);
}

TEST(QuickFixes, CorrectTheText) {
    Client client;
    client.open(uri,
                "stm S {\n  var speed : nat\n  initial i\n  state A { entry /*^slip*/spede = 1 }\n"
                "  transition t { from i to A }\n}\n");
    ASSERT_EQ(client.codes(), "RC-N01@4");
    Json params = client.at("slip");
    params["range"] = Json::object({{"start", params["position"]}, {"end", params["position"]}});
    params["context"] = Json::object({{"diagnostics", client.diagnostics().json()}});
    const Answer actions = client.request("textDocument/codeAction", params);
    ASSERT_EQ(actions.items().size(), 1U);
    EXPECT_EQ(actions[0]["kind"].text(), "quickfix");
    EXPECT_EQ(actions[0]["title"].text(), "Change `spede` to `speed`");
    EXPECT_TRUE(actions[0]["isPreferred"].truth()) << "nothing else is as near";
    EXPECT_EQ(actions[0]["diagnostics"][0]["code"].text(), "RC-N01");
    client.change(uri, client.edited(actions[0]["edit"]));
    EXPECT_EQ(client.codes(), "");
}

/// `speed1` and `speed2` are equally similar, so the fix is offered as a guess and not marked as preferred.
TEST(QuickFixes, GuessesAreNotPreferred) {
    Client client;
    client.open(uri,
                "stm S {\n  var speed1 : nat var speed2 : nat\n  initial i\n  state A { entry /*^slip*/speed = speed1 "
                "+ speed2 }\n"
                "  transition t { from i to A }\n}\n");
    Json params = client.at("slip");
    params["range"] = Json::object({{"start", params["position"]}, {"end", params["position"]}});
    const Answer actions = client.request("textDocument/codeAction", params);
    ASSERT_EQ(actions.items().size(), 1U);
    EXPECT_FALSE(actions[0]["isPreferred"].truth());
}

TEST(QuickFixes, AreThoseAskedFor) {
    Client client;
    client.open(uri,
                "stm S {\n  var speed : nat\n  initial i\n  state A { entry /*^slip*/spede = 1 }\n"
                "  transition t { from i to A }\n}\n");
    const auto count = [&](const char* only, std::int64_t line) {
        const Json place = Json::object({{"line", line}, {"character", 30}});
        const Json params =
            Json::object({{"textDocument", Json::object({{"uri", uri}})},
                          {"range", Json::object({{"start", place}, {"end", place}})},
                          {"context", Json::object({{"diagnostics", Json::array()}, {"only", Json::array({only})}})}});
        return client.request("textDocument/codeAction", params).items().size();
    };
    EXPECT_EQ(count("quickfix", 3), 1U);
    EXPECT_EQ(count("quickfix", 1), 0U);
    EXPECT_EQ(count("refactor", 3), 0U);
}

/// The claims and their imports are moved to the end of the claims file beside the assertions. This file may not exist
/// yet.
TEST(QuickFixes, MoveClaims) {
    Json capabilities = testing::usual_capabilities();
    capabilities["workspace"] = Json::object(
        {{"workspaceEdit",
          Json::object({{"documentChanges", true}, {"resourceOperations", Json::array({"create", "rename"})}})}});
    Client client(std::move(capabilities));
    const std::string assertions = "file:///p/a.assertions";
    client.open(uri, "package p\nstm S { event e initial i state A { } transition t { from i to A } }\n");
    client.open(assertions,
                "import p::*\nunit 0.1 s\nassertion D : S is deadlock-free\nclaim A of S : never e\n"
                "claim B of S :\n    at most 3 e in any 1 s\n");
    const auto place = [](std::int64_t line) { return Json::object({{"line", line}, {"character", 2}}); };
    const Json params = Json::object({{"textDocument", Json::object({{"uri", assertions}})},
                                      {"range", Json::object({{"start", place(3)}, {"end", place(3)}})},
                                      {"context", Json::object({{"diagnostics", Json::array()}})}});
    const Answer actions = client.request("textDocument/codeAction", params);
    ASSERT_EQ(actions.items().size(), 1U);
    EXPECT_EQ(actions[0]["title"].text(), "Move the claims to a.claims");
    const Answer changes = actions[0]["edit"]["documentChanges"];
    ASSERT_EQ(changes.items().size(), 3U);
    EXPECT_EQ(changes[0]["kind"].text(), "create");
    EXPECT_EQ(changes[0]["uri"].text(), "file:///p/a.claims");
    EXPECT_TRUE(changes[0]["options"]["ignoreIfExists"].truth());
    EXPECT_EQ(changes[1]["edits"][0]["newText"].text(),
              "import p::*\n\nunit 0.1 s\nclaim A of S : never e\nclaim B of S :\n    at most 3 e in any 1 s\n");
    EXPECT_EQ(changes[2]["textDocument"]["uri"].text(), assertions);
    client.change(assertions, client.applied(changes[2]["edits"], assertions));
    EXPECT_EQ(client.codes(assertions), "");
    Client plain;  // an editor that cannot create files
    plain.open(assertions, "claim A of S : never e\n");
    EXPECT_EQ(plain.request("textDocument/codeAction", params).items().size(), 0U);
}

TEST(Formatting, IsOneEditToTheStandardLayout) {
    Client client;
    client.open(uri, "// ä\ninterface   I {\nvar x:nat }\n");
    const Json params = Json::object({{"textDocument", Json::object({{"uri", uri}})},
                                      {"options", Json::object({{"tabSize", 4}, {"insertSpaces", true}})}});
    const Answer edits = client.request("textDocument/formatting", params);
    ASSERT_EQ(edits.items().size(), 1U);
    EXPECT_GE(edits[0]["range"]["start"]["line"].number(), 1) << "what is right already stays untouched";
    client.change(uri, "interface   I {\nvar x:nat }\n");
    const std::string formatted = client.applied(client.request("textDocument/formatting", params));
    EXPECT_NE(formatted.find("interface I {\n"), std::string::npos) << formatted;
    client.change(uri, formatted);
    EXPECT_EQ(client.request("textDocument/formatting", params), Json::array());
    client.change(uri, "interface I {{\n");
    EXPECT_EQ(client.ask("textDocument/formatting", params)["error"]["code"].number(), -32803);
}

}  // namespace
}  // namespace robochart::lsp
