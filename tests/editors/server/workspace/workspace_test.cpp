// SPDX-License-Identifier: Apache-2.0
// Tests folders, files on disk, and open texts that override them.
#include <gtest/gtest.h>

#include <filesystem>

#include "editors/server/protocol/uri.hpp"
#include "tests/editors/server/client.hpp"
#include "tests/temporary_folder.hpp"

namespace robochart::lsp {
namespace {

namespace fs = std::filesystem;
using testing::Client;

class OnDisk : public ::testing::Test {
protected:
    OnDisk() { fs::create_directory(folder_); }

    void write(const std::string& name, const std::string& text) { temporary_.write("lsp workspace/" + name, text); }
    std::string uri(const std::string& name) { return uri_of_path((folder_ / name).string()); }
    static void tell(Client& client, const std::string& uri) {
        client.notify("workspace/didChangeWatchedFiles",
                      Json::object({{"changes", Json::array({Json::object({{"uri", uri}, {"type", 2}})})}}));
    }

    tests::TemporaryFolder temporary_;
    fs::path folder_ = temporary_.in("lsp workspace");  // the URI of this folder escapes the space
};

TEST_F(OnDisk, AWorkspaceFolderIsAProject) {
    write("types.rct", "interface I { var x : nat }\n");
    write("deep/user.rct", "robotic platform R { provides I provides Lost }\n");
    write(".hidden/other.rct", "interface Lost { }\n");
    Client client(testing::usual_capabilities(), folder_.string());
    EXPECT_EQ(client.codes(uri("deep/user.rct")), "RC-N01@1") << "files that are not open are diagnosed too";
    EXPECT_TRUE(client.diagnostics(uri("types.rct")).is_null());
}

TEST_F(OnDisk, OpenTextsOverrideFiles) {
    write("types.rct", "interface I { var x : nat }\n");
    write("user.rct", "robotic platform R { provides I }\n");
    Client client(testing::usual_capabilities(), folder_.string());
    client.open(uri("types.rct"), "interface K { var x : nat }\n");
    EXPECT_EQ(client.codes(uri("user.rct")), "RC-N01@1");
    tell(client, uri("types.rct"));
    EXPECT_EQ(client.codes(uri("user.rct")), "RC-N01@1") << "the editor's text counts, not the file";
    client.close(uri("types.rct"));
    EXPECT_EQ(client.codes(uri("user.rct")), "") << "closed without saving: the file counts again";
}

TEST_F(OnDisk, FilesMayChangeComeAndGo) {
    write("user.rct", "robotic platform R { provides I }\n");
    Client client(testing::usual_capabilities(), folder_.string());
    EXPECT_EQ(client.codes(uri("user.rct")), "RC-N01@1");
    write("types.rct", "interface I { var x : nat }\n");
    tell(client, uri("types.rct"));
    EXPECT_EQ(client.codes(uri("user.rct")), "");
    write("types.rct", "interface I { var x : lost }\n");
    tell(client, uri("types.rct"));
    EXPECT_EQ(client.codes(uri("types.rct")), "RC-N01@1");
    fs::remove(folder_ / "types.rct");
    tell(client, uri("types.rct"));
    EXPECT_EQ(client.codes(uri("types.rct")), "") << "a file that is gone has no diagnostics";
    EXPECT_EQ(client.codes(uri("user.rct")), "RC-N01@1");
    tell(client, uri("notes.txt"));
    tell(client, uri("never.rct"));
}

TEST_F(OnDisk, AFileOutsideStandsWithItsFolder) {
    write("types.rct", "interface I { var x : nat }\n");
    write("deep/more.rct", "interface Deep { }\n");
    Client client;
    client.open(uri("user.rct"), "robotic platform R { provides I provides Deep }\n");
    EXPECT_EQ(client.codes(uri("user.rct")), "RC-N01@1");
    EXPECT_NE(client.diagnostics(uri("user.rct"))[0]["message"].text().find("Deep"), std::string::npos);
    write("types.rct", "interface I { var x : lost }\n");
    tell(client, uri("types.rct"));
    EXPECT_EQ(client.codes(uri("types.rct")), "RC-N01@1");
    client.close(uri("user.rct"));
    EXPECT_EQ(client.codes(uri("types.rct")), "") << "nothing of the folder is open any more";
}

TEST_F(OnDisk, ProjectsOfEclipseInsideAFolderStandAlone) {
    write("one/.project", "");
    write("one/a.rct", "interface I { var x : nat }\n");
    write("two/.project", "");
    write("two/b.rct", "interface I { var x : nat }\nrobotic platform R { provides I }\n");
    write("two/sub/c.rct", "robotic platform Q { provides I }\n");
    write("d.rct", "robotic platform P { provides I }\n");
    Client client(testing::usual_capabilities(), folder_.string());
    EXPECT_EQ(client.codes(uri("one/a.rct")), "") << "the other project's I is no second declaration";
    EXPECT_EQ(client.codes(uri("two/b.rct")), "");
    EXPECT_EQ(client.codes(uri("two/sub/c.rct")), "");
    EXPECT_EQ(client.codes(uri("d.rct")), "RC-N01@1");
}

TEST_F(OnDisk, FoldersMayComeAndGo) {
    write("one/a.rct", "interface I { var x : lost }\n");
    write("two/b.rct", "robotic platform R { provides I }\n");
    Client client(testing::usual_capabilities(), (folder_ / "two").string());
    EXPECT_EQ(client.codes(uri("two/b.rct")), "RC-N01@1");
    const auto event = [&](const char* what, const char* other) {
        const Json folder = Json::array({Json::object({{"uri", uri("one")}, {"name", "one"}})});
        client.notify("workspace/didChangeWorkspaceFolders",
                      Json::object({{"event", Json::object({{what, folder}, {other, Json::array()}})}}));
    };
    event("added", "removed");
    EXPECT_EQ(client.codes(uri("one/a.rct")), "RC-N01@1");
    client.open(uri("one/a.rct"), "interface I { var x : lost var y : gone }\n");
    EXPECT_EQ(client.codes(uri("one/a.rct")), "RC-N01@1 RC-N01@1");
    event("removed", "added");
    EXPECT_EQ(client.codes(uri("one/a.rct")), "RC-N01@1 RC-N01@1") << "it is still open";
    client.close(uri("one/a.rct"));
    EXPECT_EQ(client.codes(uri("one/a.rct")), "");
}

TEST_F(OnDisk, FilesThatCannotBeReadSaySo) {
    write("a.rct", std::string("interface I { }\n\0\1\2", 19));
    Client client(testing::usual_capabilities(), folder_.string());
    EXPECT_NE(client.codes(uri("a.rct")), "");
}

TEST(Uris, AndPaths) {
    EXPECT_EQ(path_of_uri("file:///a%20b/c%C3%A4.rct"), "/a b/cä.rct");
    EXPECT_EQ(path_of_uri("file://localhost/a/../b"), "/b");
    EXPECT_EQ(path_of_uri("file:///a%2"), "/a%2");
    EXPECT_EQ(path_of_uri("untitled:Untitled-1"), "untitled:Untitled-1");
    EXPECT_EQ(uri_of_path("/a b/cä#.rct"), "file:///a%20b/c%C3%A4%23.rct");
    EXPECT_EQ(path_of_uri(uri_of_path("/x%41 ?é/y")), "/x%41 ?é/y");
}

}  // namespace
}  // namespace robochart::lsp
