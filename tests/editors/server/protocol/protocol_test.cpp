// SPDX-License-Identifier: Apache-2.0
// Tests the life cycle of a server (LSP 3.17, lifecycle messages; JSON-RPC 2.0).
#include <gtest/gtest.h>

#include "tests/editors/server/client.hpp"

namespace robochart::lsp {
namespace {

using testing::Answer;
using testing::Client;

std::int64_t code_of(const Answer& response) {
    return response["error"]["code"].number();
}

/// A server without a client, before any message.
struct Bare {
    std::vector<Answer> messages;
    Server server{[this](const std::string& text) {
        std::string error;
        messages.push_back(read_json(text, error));
    }};

    Answer say(const std::string& text) {
        server.receive_message(text);
        while (server.has_work()) server.handle_next();
        return messages.empty() ? Json() : messages.back();
    }
};

TEST(Life, BeginsWithInitialize) {
    Bare bare;
    EXPECT_EQ(code_of(bare.say(R"({"jsonrpc":"2.0","id":1,"method":"textDocument/hover","params":{}})")), -32002);
    bare.messages.clear();
    bare.say(R"({"jsonrpc":"2.0","method":"textDocument/didOpen","params":{}})");
    EXPECT_TRUE(bare.messages.empty()) << "notifications before initialize are dropped";
    EXPECT_TRUE(bare.say(R"({"jsonrpc":"2.0","id":"x","method":"initialize","params":{}})")["result"].is_object());
    EXPECT_EQ(bare.messages.back()["id"].text(), "x");
    EXPECT_EQ(code_of(bare.say(R"({"jsonrpc":"2.0","id":2,"method":"initialize","params":{}})")), -32600);
}

TEST(Life, EndsWithShutdownAndExit) {
    Client client;
    EXPECT_TRUE(client.request("shutdown", nullptr).is_null());
    EXPECT_EQ(code_of(client.ask("textDocument/hover", Json::object({}))), -32600);
    EXPECT_FALSE(client.server().exit_code());
    client.notify("exit", nullptr);
    EXPECT_EQ(client.server().exit_code(), 0);
}

TEST(Life, ExitWithoutShutdownIsAnError) {
    Client client;
    client.notify("exit", nullptr);
    EXPECT_EQ(client.server().exit_code(), 1);
}

TEST(Messages, OfUnknownMethods) {
    Client client;
    EXPECT_EQ(code_of(client.ask("textDocument/fly", Json::object({}))), -32601);
    const std::size_t before = client.messages.size();
    client.notify("$/whatever", Json::object({}));
    client.notify("workspace/unheard", Json::object({}));
    EXPECT_EQ(client.messages.size(), before) << "unknown notifications are ignored";
}

TEST(Messages, OfWrongShape) {
    Bare bare;
    EXPECT_EQ(code_of(bare.say("[]")), -32600);
    EXPECT_EQ(code_of(bare.say("{\"jsonrpc\":\"2.0\"}")), -32600);
    EXPECT_EQ(code_of(bare.say("{\"jsonrpc\":\"2.0\",\"id\":{},\"method\":\"x\"}")), -32600);
    EXPECT_EQ(code_of(bare.say("{\"jsonrpc\":\"2.0\",\"method\":5}")), -32600);
    EXPECT_EQ(code_of(bare.say("not json")), -32700);
    EXPECT_TRUE(bare.messages.back()["id"].is_null());
    const std::size_t count = bare.messages.size();
    bare.say("{\"jsonrpc\":\"2.0\",\"id\":3,\"result\":null}");
    EXPECT_EQ(bare.messages.size(), count) << "responses are no requests";
}

TEST(Messages, WithWrongParametersAreRefused) {
    Client client;
    for (const std::string method :
         {"textDocument/hover", "textDocument/definition", "textDocument/references", "textDocument/completion",
          "textDocument/rename", "textDocument/formatting", "textDocument/codeAction", "textDocument/documentSymbol",
          "textDocument/foldingRange", "textDocument/semanticTokens/full", "textDocument/selectionRange",
          "textDocument/inlayHint", "textDocument/diagnostic", "textDocument/codeLens",
          "textDocument/prepareCallHierarchy", "callHierarchy/incomingCalls", "callHierarchy/outgoingCalls"}) {
        EXPECT_EQ(code_of(client.ask(method, nullptr)), -32602) << method;
        EXPECT_EQ(code_of(client.ask(method, Json::array({1}))), -32602) << method;
        EXPECT_EQ(code_of(client.ask(method, Json::object({{"textDocument", Json::object({{"uri", "file:///no"}})}}))),
                  -32602)
            << method;
    }
    client.notify("textDocument/didOpen", nullptr);
    client.notify("textDocument/didChange", Json::object({{"textDocument", Json::object({{"uri", "file:///no"}})}}));
    client.notify("textDocument/didClose", Json::array());
    EXPECT_TRUE(client.request("workspace/symbol", Json::object({{"query", ""}})).is_array());
}

// LSP 3.17, $/cancelRequest: a cancelled request still gets an answer, the error RequestCancelled.
TEST(Messages, ThatAreCancelledInTime) {
    Client client;
    client.server().receive_message(R"({"jsonrpc":"2.0","id":71,"method":"workspace/symbol","params":{"query":""}})");
    client.server().receive_message(R"({"jsonrpc":"2.0","id":72,"method":"workspace/symbol","params":{"query":""}})");
    client.server().receive_message(R"({"jsonrpc":"2.0","method":"$/cancelRequest","params":{"id":71}})");
    client.work();
    ASSERT_GE(client.messages.size(), 2U);
    const Answer& cancelled = client.messages[client.messages.size() - 2];
    EXPECT_EQ(cancelled["id"].number(), 71);
    EXPECT_EQ(code_of(cancelled), -32800);
    EXPECT_TRUE(client.messages.back()["result"].is_array());
    EXPECT_EQ(client.messages.back()["id"].number(), 72);
}

TEST(Positions, EncodingIsNegotiated) {
    const auto chosen = [](std::vector<std::string> offered) {
        const Json general = Json::object({{"positionEncodings", std::move(offered)}});
        Client client(Json::object({{"general", general}}));
        return client.initialized()["capabilities"]["positionEncoding"].text();
    };
    EXPECT_EQ(chosen({}), "utf-16");
    EXPECT_EQ(chosen({"utf-16"}), "utf-16");
    EXPECT_EQ(chosen({"utf-16", "utf-8"}), "utf-8");
    EXPECT_EQ(chosen({"utf-32"}), "utf-32");
}

/// A position has different numbers in the two encodings.
TEST(Positions, AreThoseAgreedUpon) {
    for (const bool utf8 : {false, true}) {
        const Json general =
            Json::object({{"positionEncodings", Json::array({utf8 ? Json("utf-8") : Json("utf-16")})}});
        Client client(Json::object({{"general", general}}));
        client.open("file:///p/a.rct", "/* \xf0\x9f\x98\x80 */ interface I { var x : lost }\n");
        const Answer found = client.diagnostics();
        ASSERT_EQ(found.items().size(), 1U);
        EXPECT_EQ(found[0]["range"]["start"]["character"].number(), utf8 ? 33 : 31);
    }
}

TEST(Files, AreWatchedWhereTheEditorCan) {
    const Json yes = true;
    Client client(Json::object(
        {{"workspace", Json::object({{"didChangeWatchedFiles", Json::object({{"dynamicRegistration", yes}})}})}}));
    EXPECT_EQ(client.messages.back()["method"].text(), "client/registerCapability");
    Client other;
    EXPECT_EQ(other.messages.size(), 1U);
}

}  // namespace
}  // namespace robochart::lsp
