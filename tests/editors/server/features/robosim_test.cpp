// SPDX-License-Identifier: Apache-2.0
// Tests RoboSim in the language server: documents `.rst` and `.rsa` are models and claims of that dialect.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "tests/editors/server/client.hpp"

namespace robochart::lsp {
namespace {

using testing::Answer;
using testing::Client;

constexpr const char* model = "file:///p/lamp.rst";

/// Returns a machine in which `member` is on a separate line.
std::string machine(const std::string& member) {
    return "stm Switch {\n\tcycleDef cycle == 1\n\tinput context { event /*^declared*/pressed }\n\toutput context { "
           "event "
           "lit }\n\tinitial i\n\tstate Off { }\n\ttransition t0 { from i to Off }\n\ttransition t1 { from Off to Off "
           "exec "
           "condition $/*^used*/pressed action $lit }\n" +
           member + "\n\ttransition t9 { from Off to Off exec }\n}\n";
}

std::set<std::string> labels(Client& client, const std::string& mark) {
    std::set<std::string> result;
    const Answer answer = client.request("textDocument/completion", client.at(mark, model));
    for (const Answer& item : answer["items"].items()) result.insert(item["label"].text());
    return result;
}

TEST(RoboSimDocuments, RegistersAreDefinedInTheirContexts) {
    Client client;
    client.open(model, machine(""));
    EXPECT_EQ(client.marks(client.request("textDocument/definition", client.at("used", model))), "declared");
}

TEST(RoboSimDocuments, WordsOfTheDialectAreOffered) {
    Client client;
    client.open(model, machine("\t/*^member*/"));
    const auto members = labels(client, "member");
    EXPECT_TRUE(members.contains("cycleDef"));
    EXPECT_TRUE(members.contains("input context"));
    client.change(model, machine("\ttransition t2 { from Off to Off condition $/*^register*/ }"));
    EXPECT_TRUE(labels(client, "register").contains("pressed"));
    client.change(model, machine("\ttransition t2 { from Off to Off action /*^action*/ }"));
    const auto actions = labels(client, "action");
    EXPECT_TRUE(actions.contains("exec"));
}

TEST(RoboSimDocuments, ANewNameIsEscapedWhereItIsReserved) {
    Client client;
    client.open(model, machine(""));
    Json params = client.at("used", model);
    params["newName"] = "input";
    const Answer edits = client.request("textDocument/rename", std::move(params));
    EXPECT_NE(edits.write().find("\"^input\""), std::string::npos) << edits.write();
}

TEST(RoboSimDocuments, OutlineNamesSimulations) {
    Client client;
    const std::string claims = "file:///p/claims.rsa";
    client.open(claims, "simulation N of M { cycleDef 1 }\nassertion A : N is schedulable\n");
    const Answer outline = client.request("textDocument/documentSymbol",
                                          Json::object({{"textDocument", Json::object({{"uri", claims}})}}));
    EXPECT_NE(outline.write().find("\"detail\":\"simulation\""), std::string::npos) << outline.write();
}

}  // namespace
}  // namespace robochart::lsp
