// SPDX-License-Identifier: Apache-2.0
// Tests what an editor shows about a reserved word.
#include <gtest/gtest.h>

#include "editors/server/features/keywords.hpp"
#include "frontend/syntax/lexer.hpp"
#include "tests/editors/server/client.hpp"

namespace robochart::lsp {
namespace {

using testing::Answer;
using testing::Client;

TEST(Keywords, HoverOnAReservedWordSaysWhatItMeans) {
    Client client;
    client.open("file:///p/a.rct",
                "// a /*^comment*/wait is no word here\n"
                "stm S { clock C initial i state ^/*^escaped*/wait { entry /*^wait*/wait(2) }\n"
                "  transition t { from i to ^wait condition /*^since*/since(C) > 1 } }\n");
    const auto hover = [&](const std::string& mark) { return client.request("textDocument/hover", client.at(mark)); };
    EXPECT_NE(hover("wait")["contents"]["value"].text().find("exactly `d` time units"), std::string::npos);
    EXPECT_NE(hover("since")["contents"]["value"].text().find("time units since the clock"), std::string::npos);
    EXPECT_TRUE(hover("comment").is_null());
    const Json at = client.at("since");
    EXPECT_EQ(hover("since")["range"]["start"].json(), at["position"]);
}

TEST(Keywords, HoverOnAWordOfAnAssertion) {
    Client client;
    client.open("file:///p/a.assertions", "assertion A : S /*^is*/is /*^dead*/deadlock-free\n");
    const auto hover = [&](const std::string& mark) {
        return client.request("textDocument/hover", client.at(mark, "file:///p/a.assertions"));
    };
    const Answer dead = hover("dead");
    EXPECT_NE(dead["contents"]["value"].text().find("nothing can happen any more"), std::string::npos) << dead.write();
    EXPECT_TRUE(hover("is").is_null()) << "`x is T` is no assertion";
}

TEST(Keywords, EachReservedWordHasAMeaning) {
    for (const std::string_view word : frontend::reserved_words()) EXPECT_NE(meaning_of_word(word), "") << word;
    for (const std::string_view word : frontend::robosim_words()) EXPECT_NE(meaning_of_word(word), "") << word;
    EXPECT_EQ(meaning_of_word("speed"), "");
    for (const std::string_view word :
         {"assertion", "deadlock-free", "divergence-free", "timelock-free", "deterministic", "reachable", "initialised",
          "terminates", "terminate", "refines", "refine", "equals", "equal", "timed", "untimed", "csp", "constant"})
        EXPECT_NE(meaning_of_assertion_word(word), "") << word;
    EXPECT_EQ(meaning_of_assertion_word("wait"), "");
}

}  // namespace
}  // namespace robochart::lsp
