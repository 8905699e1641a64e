// SPDX-License-Identifier: Apache-2.0
// Tests scenarios, mappings and swarms in an editor: findings while the user types, and completion of the words that
// may follow.
#include <gtest/gtest.h>

#include "tests/editors/server/client.hpp"

namespace robochart::lsp {
namespace {

using testing::Answer;
using testing::Client;

std::string labels(Client& client, const std::string& uri, std::int64_t line, std::int64_t character) {
    const Answer answer =
        client.request("textDocument/completion",
                       Json::object({{"textDocument", Json::object({{"uri", uri}})},
                                     {"position", Json::object({{"line", line}, {"character", character}})}}));
    std::string result;
    for (const Answer& item : answer["items"].items()) result += (result.empty() ? "" : " ") + item["label"].text();
    return result;
}

TEST(PlainTexts, AreReadWhileTyping) {
    for (const char* suffix : {"scenario", "ros2", "swarm"}) {
        Client client;
        const std::string uri = std::string("file:///p/a.") + suffix;
        client.open(uri, "nothing of the kind");
        EXPECT_EQ(client.diagnostics(uri).items().size(), 1U) << suffix;
    }
    Client client;
    client.open("file:///p/a.swarm", "swarm S for P::M {\n robots 3\n}\n");
    EXPECT_EQ(client.diagnostics("file:///p/a.swarm").items().size(), 0U)
        << client.diagnostics("file:///p/a.swarm").write();
    client.change("file:///p/a.swarm", "swarm S for P::M {\n robts 3\n}\n");
    ASSERT_EQ(client.diagnostics("file:///p/a.swarm").items().size(), 1U);
    EXPECT_EQ(client.diagnostics("file:///p/a.swarm")[0]["range"]["start"]["line"].number(), 1);
}

TEST(PlainTexts, CompleteTheWordsThatTheReaderTakes) {
    Client client;
    client.open("file:///p/a.swarm", "swarm S for P::M {\n ro");
    EXPECT_NE(labels(client, "file:///p/a.swarm", 1, 3).find("robots grid"), std::string::npos)
        << labels(client, "file:///p/a.swarm", 1, 3);
    EXPECT_EQ(labels(client, "file:///p/a.swarm", 0, 0), "swarm");
}

}  // namespace
}  // namespace robochart::lsp
