// SPDX-License-Identifier: Apache-2.0
// Tests claims in an editor, beside a model on disk.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/editors/server/client.hpp"
#include "tests/temporary_folder.hpp"

namespace robochart::lsp {
namespace {

using testing::Answer;
using testing::Client;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* robot =
    "package p\n"                                                                               // 0
    "interface Motors { brake() goTo(place : nat) }\n"                                          // 1
    "interface Buttons { event estop event reset }\n"                                           // 2
    "stm Robot { requires Motors uses Buttons initial i\n"                                      // 3
    "state Moving { entry goTo(1) } state Held { entry brake() }\n"                             // 4
    "transition t0 { from i to Moving } transition t1 { from Moving to Held trigger estop }\n"  // 5
    "transition t2 { from Held to Moving trigger reset } }\n";                                  // 6

constexpr const char* claims =
    "import p::*\n"                                        // 0
    "unit 0.1 s\n"                                         // 1
    "claim Stays : after estop until reset, never goTo\n"  // 2
    "claim Soon : estop leads to brake within 1 s\n";      // 3

class Claims : public ::testing::Test {
protected:
    Claims() {
        folder_.write("robot.rct", robot);
        uri_ = uri_of_path(folder_.in("robot.claims"));
    }
    [[nodiscard]] Json place(std::int64_t line, std::int64_t character) const {
        return Json::object({{"textDocument", Json::object({{"uri", uri_}})},
                             {"position", Json::object({{"line", line}, {"character", character}})}});
    }
    [[nodiscard]] std::string hovered(Client& client, std::int64_t line, std::int64_t character) const {
        return client.request("textDocument/hover", place(line, character))["contents"]["value"].text();
    }

    tests::TemporaryFolder folder_;
    std::string uri_;
};

TEST_F(Claims, AreCheckedWhileTyping) {
    Client client;
    client.open(uri_, claims);
    EXPECT_TRUE(client.diagnostics(uri_).is_null());
    client.change(uri_, "import p::*\nclaim A : never estpo\n");
    EXPECT_EQ(client.codes(uri_), "CLM-T01@2");
    client.change(uri_, "import p::*\nclaim A : never\n");
    EXPECT_EQ(client.codes(uri_), "CLM-P01@3");
    client.change(uri_, "import p::*\nclaim A : estop leads to brake within 150 ms\n");
    EXPECT_EQ(client.codes(uri_), "CLM-T06@2");
    folder_.write("unit.claims", "unit 50 ms\n");
    client.change(uri_, "import p::*\nclaim A : estop leads to brake within 150 ms  \n");
    EXPECT_EQ(client.diagnostics(uri_), Json::array()) << "the unit of another file of the folder";
    client.change(uri_, "import p::*\nunit 0.1 s\nclaim A : never goTo\n");
    EXPECT_EQ(client.codes(uri_), "CLM-T09@2");
}

TEST_F(Claims, NamesAreExplainedAndFound) {
    Client client;
    client.open(uri_, claims);
    EXPECT_THAT(hovered(client, 2, 46), HasSubstr("`goTo(nat)`: operation of the platform of p::Robot"));
    EXPECT_THAT(hovered(client, 2, 22), HasSubstr("`estop`: input of p::Robot"));
    EXPECT_THAT(hovered(client, 2, 7), HasSubstr("claim `Stays`: after estop until reset, never goTo"));
    EXPECT_THAT(hovered(client, 3, 36), HasSubstr("at most so much later"));
    const Answer found = client.request("textDocument/definition", place(2, 22));
    ASSERT_EQ(found.items().size(), 1U);
    EXPECT_THAT(found.items()[0]["uri"].text(), HasSubstr("robot.rct"));
    EXPECT_EQ(found.items()[0]["range"]["start"]["line"], Answer(std::int64_t{2}));
}

TEST_F(Claims, AreCompleted) {
    Client client;
    client.open(uri_, "import p::*\nclaim A : never ");
    const auto labels = [&](std::int64_t line, std::int64_t character) {
        std::string result;
        const Answer items = client.request("textDocument/completion", place(line, character))["items"];
        for (const Answer& item : items.items()) result += item["label"].text() + " ";
        return result;
    };
    EXPECT_THAT(labels(1, 16), HasSubstr("goTo "));
    EXPECT_THAT(labels(1, 16), HasSubstr("estop "));
    EXPECT_THAT(labels(1, 16), HasSubstr("within "));
    client.change(uri_, "import p::*\nclaim A of ");
    EXPECT_THAT(labels(1, 11), HasSubstr("p::Robot "));
    EXPECT_THAT(labels(1, 11), Not(HasSubstr("estop ")));
    client.change(uri_, "import p::*\nclaim A : while in ");
    EXPECT_THAT(labels(1, 19), HasSubstr("Held Moving "));
    client.change(uri_, "import p::*\nclaim A : always ");
    EXPECT_THAT(labels(1, 17), Not(HasSubstr("Held ")));
    folder_.write(
        "robot.rct",
        "package p stm Robot { initial i var speed : nat state Outer { initial k state Inner { } transition b "
        "{ from k to Inner } } transition t { from i to Outer action speed = 1 } }");
    client.change(uri_, "import p::*\nclaim A : enter Outer::In");
    EXPECT_EQ(labels(1, 25), "Inner ");
    client.change(uri_, "import p::*\nclaim A : always sp");
    EXPECT_THAT(labels(1, 19), HasSubstr("speed "));
}

TEST_F(Claims, ConstantsAreCompletedAndExplained) {
    folder_.write("robot.rct",
                  "package p stm Robot { const pace : nat = 1 initial i state S { entry wait(pace) } transition t { "
                  "from i to S } }");
    Client client;
    client.open(uri_, "import p::*\nclaim A : never terminate with constant pace of Robot set to 2\n");
    EXPECT_TRUE(client.diagnostics(uri_).is_null());
    EXPECT_THAT(hovered(client, 1, 41), HasSubstr("`pace`: constant of p::Robot, nat"));
    EXPECT_EQ(client.request("textDocument/definition", place(1, 41)).items().size(), 1U);
    client.change(uri_, "import p::*\nclaim A : never terminate with constant pacce of Robot set to 2\n");
    EXPECT_EQ(client.codes(uri_), "CLM-T17@2");
    const auto labels = [&](std::int64_t character) {
        std::string result;
        const Answer items = client.request("textDocument/completion", place(1, character))["items"];
        for (const Answer& item : items.items()) result += item["label"].text() + " ";
        return result;
    };
    client.change(uri_, "import p::*\nclaim A : never terminate with constant ");
    EXPECT_EQ(labels(40), "pace ");
    client.change(uri_, "import p::*\nclaim A : never terminate with constant pace of ");
    EXPECT_EQ(labels(48), "p::Robot ");
}

TEST_F(Claims, AreFormattedListedAndRenamed) {
    Client client;
    client.open(uri_, "import p::*\nclaim A:never goTo\nclaim B : never brake\n");
    const Answer edits =
        client.request("textDocument/formatting", Json::object({{"textDocument", Json::object({{"uri", uri_}})}}));
    EXPECT_FALSE(edits.items().empty());
    const Answer symbols =
        client.request("textDocument/documentSymbol", Json::object({{"textDocument", Json::object({{"uri", uri_}})}}));
    ASSERT_EQ(symbols.items().size(), 2U);
    EXPECT_EQ(symbols.items()[0]["name"].text(), "A");
    Json params = place(1, 6);
    params["newName"] = "Stays";
    const Answer changes = client.request("textDocument/rename", params)["changes"];
    EXPECT_THAT(changes.write(), HasSubstr("\"newText\":\"Stays\""));
    params["newName"] = "B";
    EXPECT_TRUE(client.ask("textDocument/rename", params).has("error"));
    params["newName"] = "a b";
    EXPECT_TRUE(client.ask("textDocument/rename", params).has("error"));
    Json event = place(1, 15);
    event["newName"] = "go";
    EXPECT_TRUE(client.ask("textDocument/rename", event).has("error")) << "an event of the model";
}

TEST_F(Claims, OfferFixes) {
    Client client;
    client.open(uri_, "import p::*\nclaim A : after estop, at most 2 goTo\n");
    EXPECT_EQ(client.codes(uri_), "CLM-T08@2");
    const Answer actions = client.request(
        "textDocument/codeAction",
        Json::object({{"textDocument", Json::object({{"uri", uri_}})},
                      {"range", Json::object({{"start", place(1, 10)["position"]}, {"end", place(1, 10)["position"]}})},
                      {"context", Json::object({{"diagnostics", Json::array()}})}}));
    EXPECT_EQ(actions.items().size(), 2U);
}

}  // namespace
}  // namespace robochart::lsp
