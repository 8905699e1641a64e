// SPDX-License-Identifier: Apache-2.0
// Tests CSP blocks in an editor: findings, completion and hover of the names of the script.
#include <gtest/gtest.h>

#include "tests/editors/server/client.hpp"

namespace robochart::lsp {
namespace {

using testing::Answer;
using testing::Client;

constexpr const char* claims_uri = "file:///p/a.assertions";

class CspBlocks : public ::testing::Test {
protected:
    CspBlocks() {
        client_.open(
            "file:///p/a.rct",
            "package lamp\ninterface Signals { event press }\nstm Switch { uses Signals initial i state Off { }\n"
            "transition t { from i to Off } transition u { from Off to Off trigger press } }\n");
    }
    void write(const std::string& body) {
        client_.open(claims_uri, "package c\nimport lamp::*\ntimed csp P csp-begin\n" + body + "\ncsp-end\n");
    }
    Client client_;
};

TEST_F(CspBlocks, HaveFindings) {
    write("P = press -> P");
    EXPECT_EQ(client_.codes(claims_uri), "CSPM-T01@4");
    client_.change(claims_uri,
                   "package c\nimport lamp::*\ntimed csp P csp-begin\nP = lamp::Switch::press.in -> P\ncsp-end\n");
    EXPECT_EQ(client_.codes(claims_uri), "");
}

TEST_F(CspBlocks, CompleteNames) {
    client_.open(claims_uri,
                 "package c\nimport lamp::*\ntimed csp P csp-begin\nP = lamp::Switch::pr\nQ = "
                 "lamp::Switch::press.\n csp-end\n");
    const auto labels_at = [&](std::int64_t line, std::int64_t character) {
        const Answer answer =
            client_.request("textDocument/completion",
                            Json::object({{"textDocument", Json::object({{"uri", claims_uri}})},
                                          {"position", Json::object({{"line", line}, {"character", character}})}}));
        std::string result;
        for (const Answer& item : answer["items"].items()) result += item["label"].text() + " ";
        return result;
    };
    EXPECT_NE(labels_at(3, 20).find("press "), std::string::npos) << labels_at(3, 20);
    EXPECT_NE(labels_at(3, 10).find("Switch "), std::string::npos) << labels_at(3, 10);
    EXPECT_EQ(labels_at(4, 24), "in out ");
}

TEST_F(CspBlocks, SayWhatANameIs) {
    client_.open(claims_uri,
                 "package c\nimport lamp::*\ntimed csp P csp-begin\nP = lamp::Switch::press.in -> P\ncsp-end\n");
    const Answer answer = client_.request("textDocument/hover",
                                          Json::object({{"textDocument", Json::object({{"uri", claims_uri}})},
                                                        {"position", Json::object({{"line", 3}, {"character", 20}})}}));
    EXPECT_NE(answer["contents"]["value"].text().find("channel lamp::Switch::press"), std::string::npos)
        << answer.write();
}

TEST_F(CspBlocks, FollowARenaming) {
    client_.open(claims_uri,
                 "package c\nimport lamp::*\ntimed csp P csp-begin\nP = lamp::Switch::press.in -> P\npress = "
                 "P\ncsp-end\n");
    const Answer edit = client_.request("textDocument/rename",
                                        Json::object({{"textDocument", Json::object({{"uri", "file:///p/a.rct"}})},
                                                      {"position", Json::object({{"line", 1}, {"character", 28}})},
                                                      {"newName", "push"}}));
    EXPECT_EQ(client_.edited(edit, claims_uri),
              "package c\nimport lamp::*\ntimed csp P csp-begin\nP = lamp::Switch::push.in -> P\npress = P\ncsp-end\n")
        << edit.write();
}

}  // namespace
}  // namespace robochart::lsp
