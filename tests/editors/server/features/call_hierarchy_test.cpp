// SPDX-License-Identifier: Apache-2.0
// Tests the callers of an operation, and the operations that it calls.
#include <gtest/gtest.h>

#include "tests/editors/server/client.hpp"

namespace robochart::lsp {
namespace {

using testing::Answer;
using testing::Client;

constexpr const char* called = R"(interface I { /*^signature*/go(n : nat) move() }
operation /*^go*/go(n : nat) { requires I initial i final f
  transition t { from i to f action move() ; move() } }
stm /*^S*/S { requires I initial i state A { entry /*^call*/go(1) }
  transition t { from i to A action go(2) } }
stm Other { requires I initial i state A { entry move() } transition t { from i to A } }
)";

class CallHierarchy : public ::testing::Test {
protected:
    CallHierarchy() { client.open("file:///p/a.rct", called); }

    Answer prepared(const std::string& mark) {
        return client.request("textDocument/prepareCallHierarchy", client.at(mark));
    }
    /// Returns "name/number of calls" for each end.
    std::string ends(const std::string& direction, const Answer& item) {
        const Answer list = client.request("callHierarchy/" + direction, Json::object({{"item", item.json()}}));
        const std::string key = direction == "incomingCalls" ? "from" : "to";
        std::string out;
        for (const Answer& call : list.items())
            out += (out.empty() ? "" : " ") + call[key]["name"].text() + "/" +
                   std::to_string(call["fromRanges"].items().size());
        return out;
    }

    Client client;
};

TEST_F(CallHierarchy, ACallIsOfTheOperationThatAnswersIt) {
    for (const char* mark : {"call", "signature", "go"}) {
        const Answer items = prepared(mark);
        ASSERT_EQ(items.items().size(), 1U) << mark;
        EXPECT_EQ(items[0]["name"].text(), "go");
        EXPECT_EQ(client.text_before("file:///p/a.rct", items[0]["selectionRange"]["start"]).size(),
                  client.offset("go"));
    }
}

TEST_F(CallHierarchy, CallersAndCallees) {
    const Answer go = prepared("go")[0];
    EXPECT_EQ(ends("incomingCalls", go), "S/2");
    EXPECT_EQ(ends("outgoingCalls", go), "move/2");
    const Answer machine = prepared("S")[0];
    EXPECT_EQ(ends("outgoingCalls", machine), "go/2");
    EXPECT_EQ(ends("incomingCalls", machine), "");
    const Answer move = client.request("callHierarchy/outgoingCalls", Json::object({{"item", go.json()}}))[0]["to"];
    EXPECT_EQ(ends("incomingCalls", move), "go/2 Other/1") << "of an operation of the platform too";
}

TEST_F(CallHierarchy, OfAnythingElseThereIsNone) {
    Json params = client.at("call");
    params["position"] = Json::object({{"line", 3}, {"character", 0}});
    EXPECT_TRUE(client.request("textDocument/prepareCallHierarchy", params).is_null());
    for (const Json& item : {Json(), Json::object({{"uri", "file:///p/a.rct"}}), Json("go")}) {
        const Answer answer = client.ask("callHierarchy/incomingCalls", Json::object({{"item", item}}));
        EXPECT_TRUE(answer.has("error") || answer["result"].items().empty()) << answer.write();
    }
}

}  // namespace
}  // namespace robochart::lsp
