// SPDX-License-Identifier: Apache-2.0
// Tests interrupted work: by $/cancelRequest (LSP 3.17), by newer texts, and by an editor that exits.
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "tests/editors/server/client.hpp"

namespace robochart::lsp {
namespace {

using std::chrono::milliseconds;
using testing::Answer;
using testing::Client;

/// Returns a text whose analysis takes seconds.
std::string large_text() {
    std::string text;
    for (int i = 0; i < 60'000; ++i) {
        const std::string name = std::to_string(i);
        text += "stm S" + name +
                " { var x : nat event e : nat initial i state A { entry x = x + 1 } state B { }\n"
                " transition t0 { from i to A } transition t1 { from A to B trigger e ? x condition x > 1 } transition "
                "t2 { from B to A trigger e ? x } }\n";
    }
    return text;
}

Json message(const std::string& method, Json params) {
    return Json::object({{"jsonrpc", "2.0"}, {"method", method}, {"params", std::move(params)}});
}

Json cancellation(std::int64_t id) {
    return message("$/cancelRequest", Json::object({{"id", id}}));
}

constexpr const char* large_uri = "file:///p/large.rct";

Json change_to(const std::string& text) {
    return message("textDocument/didChange",
                   Json::object({{"textDocument", Json::object({{"uri", large_uri}, {"version", 2}})},
                                 {"contentChanges", Json::array({Json::object({{"text", text}})})}}));
}

/// An editor that has opened the large text. The server has not analysed it yet.
class Busy : public Client {
public:
    Busy() {
        server().receive_message(
            message("textDocument/didOpen", Json::object({{"textDocument", Json::object({{"uri", large_uri},
                                                                                         {"languageId", "robochart"},
                                                                                         {"version", 1},
                                                                                         {"text", large_text()}})}})),
            "");
        server().handle_next();
    }
    void hover(std::int64_t id) { begin(id, "textDocument/hover"); }
    void begin(std::int64_t id, const std::string& method) {
        const Json at = Json::object({{"line", 0}, {"character", 5}});
        Json request =
            message(method, Json::object({{"textDocument", Json::object({{"uri", large_uri}})}, {"position", at}}));
        request["id"] = id;
        server().receive_message(std::move(request), "");
    }
    /// Lets the server work, and delivers the message during the work.
    template <class Work>
    void interrupted_by(const Json& arrival, Work work) {
        std::thread working(work);
        std::this_thread::sleep_for(milliseconds(150));
        server().interruption().note_arrival(arrival);
        working.join();
    }
    [[nodiscard]] std::int64_t code_of(std::int64_t id) const {
        for (const Answer& message : messages)
            if (message["id"] == Json(id)) return message["error"]["code"].number();
        return 0;
    }
};

TEST(Interruption, ARunningRequestIsCancelledAndTheServerGoesOn) {
    Busy busy;
    busy.hover(501);
    busy.interrupted_by(cancellation(501), [&] { busy.server().handle_next(); });
    EXPECT_EQ(busy.code_of(501), -32800);
    busy.server().receive_message(cancellation(501), "");
    // The server answers the next request as usual.
    busy.server().receive_message(
        change_to("stm S { var x : lost initial i state A { } transition t { from i to A } }\n"), "");
    busy.hover(502);
    busy.work();
    EXPECT_EQ(busy.code_of(502), 0);
    EXPECT_EQ(busy.codes(large_uri), "RC-N01@1");
}

TEST(Interruption, ADiagramIsCancelled) {
    Busy busy;
    busy.begin(511, "robochart/diagram");
    busy.interrupted_by(cancellation(511), [&] { busy.server().handle_next(); });
    EXPECT_EQ(busy.code_of(511), -32800);
}

TEST(Interruption, OtherRequestsAreNotCancelled) {
    Busy busy;
    busy.server().interruption().note_arrival(cancellation(77));
    busy.server().receive_message(change_to("stm S { initial i state A { } transition t { from i to A } }\n"), "");
    busy.hover(503);
    busy.work();
    EXPECT_EQ(busy.code_of(503), 0);
    // A request that is cancelled before its start is never started, whichever thread notices first.
    busy.hover(77);
    busy.work();
    EXPECT_EQ(busy.code_of(77), -32800);
}

TEST(Interruption, ANewerTextEndsTheRequestThatIsWorkedOn) {
    Busy busy;
    const Json change = change_to("stm S { initial i state A { } transition t { from i to A } }\n");
    busy.hover(504);
    busy.interrupted_by(change, [&] { busy.server().handle_next(); });
    EXPECT_EQ(busy.code_of(504), -32801) << "ContentModified";
    busy.server().receive_message(change, "");
    busy.hover(505);
    busy.work();
    EXPECT_EQ(busy.code_of(505), 0);
}

TEST(Interruption, ANewerTextEndsAnOutdatedAnalysis) {
    Busy busy;
    const Json change = change_to("stm S { var x : lost initial i state A { } transition t { from i to A } }\n");
    const std::size_t before = busy.messages.size();
    busy.interrupted_by(change, [&] { busy.server().use_idle_time(); });
    EXPECT_EQ(busy.messages.size(), before) << "findings about a text that is old";
    busy.server().receive_message(change, "");
    busy.work();
    EXPECT_EQ(busy.codes(large_uri), "RC-N01@1");
}

TEST(Interruption, AnEditorThatLeavesIsNotKeptWaiting) {
    Busy busy;
    busy.hover(506);
    busy.hover(507);
    Json shutdown = message("shutdown", nullptr);
    shutdown["id"] = 508;
    busy.server().receive_message(shutdown, "");
    busy.interrupted_by(shutdown, [&] { busy.work(); });
    EXPECT_EQ(busy.code_of(506), -32800);
    EXPECT_EQ(busy.code_of(507), -32800);
    EXPECT_TRUE(busy.messages.back()["result"].is_null());
    EXPECT_EQ(busy.messages.back()["id"].number(), 508);
}

}  // namespace
}  // namespace robochart::lsp
