// SPDX-License-Identifier: Apache-2.0
// Tests selections that expand from a word outwards.
#include <gtest/gtest.h>

#include "tests/editors/server/client.hpp"

namespace robochart::lsp {
namespace {

using testing::Answer;
using testing::Client;

constexpr const char* selected_uri = "file:///p/a.rct";

/// Returns the selected texts from the innermost to the outermost.
std::vector<std::string> grown(Client& client, const std::string& text, std::size_t offset) {
    client.open(selected_uri, text);
    const Json params = Json::object({{"textDocument", Json::object({{"uri", selected_uri}})},
                                      {"positions", Json::array({client.position_of(offset, selected_uri)})}});
    std::vector<std::string> result;
    const Answer answer = client.request("textDocument/selectionRange", params);
    EXPECT_EQ(answer.items().size(), 1U);
    for (Answer at = answer[0]; at.is_object(); at = at["parent"]) {
        const std::size_t begin = client.text_before(selected_uri, at["range"]["start"]).size();
        const std::size_t end = client.text_before(selected_uri, at["range"]["end"]).size();
        result.push_back(text.substr(begin, end - begin));
    }
    return result;
}

TEST(SelectionRanges, GrowFromTheWordToTheDocument) {
    Client client;
    const std::string text = "stm S { var x : nat initial i state A { entry x = x + (2 * 3); skip } }\n";
    const std::vector<std::string> expected = {"2",
                                               "2 * 3",
                                               "(2 * 3)",
                                               "x + (2 * 3)",
                                               "x = x + (2 * 3)",
                                               "x = x + (2 * 3); skip",
                                               "entry x = x + (2 * 3); skip",
                                               "{ entry x = x + (2 * 3); skip }",
                                               "state A { entry x = x + (2 * 3); skip }",
                                               text.substr(6, text.size() - 7),
                                               text.substr(0, text.size() - 1),
                                               text};
    EXPECT_EQ(grown(client, text, text.find("2 *")), expected);
}

TEST(SelectionRanges, OfBrokenTextFollowBrackets) {
    Client client;
    const std::string text = "stm S { transition { from (a ) ";
    const std::vector<std::string> found = grown(client, text, text.find("a )"));
    ASSERT_GE(found.size(), 3U);
    EXPECT_EQ(found[0], "a");
    EXPECT_EQ(found[1], "(a )");
    EXPECT_EQ(found.back(), text);
}

TEST(SelectionRanges, OfAnyTextAreNestedAndBounded) {
    Client client;
    const std::string deep = std::string(5000, '(') + "1" + std::string(5000, ')');
    EXPECT_LE(grown(client, deep, 5000).size(), 60U);
    EXPECT_EQ(grown(client, "", 0).size(), 1U);
    for (const Json& positions : {Json(), Json::array({Json("x")}), Json(3)}) {
        const Answer answer = client.ask(
            "textDocument/selectionRange",
            Json::object({{"textDocument", Json::object({{"uri", selected_uri}})}, {"positions", positions}}));
        EXPECT_FALSE(answer.has("error")) << answer.write();
    }
}

}  // namespace
}  // namespace robochart::lsp
