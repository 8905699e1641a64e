// SPDX-License-Identifier: Apache-2.0
// Tests diagnostics that the editor requests. No finding is reported twice.
#include <gtest/gtest.h>

#include "tests/editors/server/client.hpp"
#include "tests/temporary_folder.hpp"

namespace robochart::lsp {
namespace {

using testing::Answer;
using testing::Client;

constexpr const char* pulled_uri = "file:///p/a.rct";
constexpr const char* faulty = "interface I { var x : Lost }\n";

Json pulling() {
    Json capabilities = testing::usual_capabilities();
    capabilities["textDocument"]["diagnostic"] = Json::object({{"dynamicRegistration", false}});
    capabilities["workspace"]["diagnostics"] = Json::object({{"refreshSupport", true}});
    return capabilities;
}

Answer pull(Client& client, const char* uri = pulled_uri) {
    return client.request("textDocument/diagnostic", Json::object({{"textDocument", Json::object({{"uri", uri}})}}));
}

std::size_t refreshes(const Client& client) {
    std::size_t result = 0;
    for (const Answer& message : client.messages)
        if (message["method"].text() == "workspace/diagnostic/refresh") ++result;
    return result;
}

TEST(PullDiagnostics, AreOfferedToEditorsThatAskForThem) {
    const Client client(pulling());
    const Answer offered = client.initialized()["capabilities"]["diagnosticProvider"];
    EXPECT_TRUE(offered["interFileDependencies"].truth());
    EXPECT_FALSE(offered["workspaceDiagnostics"].truth(true));
    EXPECT_FALSE(Client().initialized()["capabilities"].has("diagnosticProvider"));
}

TEST(PullDiagnostics, AreThoseThatWouldBePushed) {
    Client pushed;
    pushed.open(pulled_uri, faulty);
    ASSERT_EQ(pushed.codes(), "RC-N01@1");
    Client client(pulling());
    client.open(pulled_uri, faulty);
    EXPECT_EQ(client.diagnostics().items().size(), 0U) << "they would be shown twice";
    const Answer report = pull(client);
    EXPECT_EQ(report["kind"].text(), "full");
    EXPECT_EQ(report["items"], pushed.diagnostics());
}

TEST(PullDiagnostics, AFileThatIsClosedIsPushedAgain) {
    const tests::TemporaryFolder folder;
    const std::string uri = uri_of_path(folder.write("a.rct", faulty));
    Client client(pulling(), folder.path());
    EXPECT_EQ(client.codes(uri), "RC-N01@1");
    client.open(uri, faulty);
    EXPECT_EQ(client.codes(uri), "");
    EXPECT_EQ(pull(client, uri.c_str())["items"].items().size(), 1U);
    client.close(uri);
    EXPECT_EQ(client.codes(uri), "RC-N01@1");
}

TEST(PullDiagnostics, AnOpenFileIsAskedForAgainWhereAnotherChangesIt) {
    Client client(pulling());
    client.open(pulled_uri, "package p\ninterface I { var x : T }\n");
    client.open("file:///p/b.rct", "package p\n");
    EXPECT_EQ(pull(client)["items"].items().size(), 1U);
    (void)pull(client, "file:///p/b.rct");
    const std::size_t before = refreshes(client);
    client.change("file:///p/b.rct", "package p\ntype T\n");
    EXPECT_EQ(refreshes(client), before + 1);
    EXPECT_EQ(pull(client)["items"].items().size(), 0U);
    client.change("file:///p/b.rct", "package p\ntype T \n");
    EXPECT_EQ(refreshes(client), before + 1) << "what was asked for last is still true";
}

}  // namespace
}  // namespace robochart::lsp
