// SPDX-License-Identifier: Apache-2.0
// Tests the hints for types and values that a text omits.
#include <gtest/gtest.h>

#include "tests/editors/server/client.hpp"

namespace robochart::lsp {
namespace {

using testing::Answer;
using testing::Client;

constexpr const char* hinted_uri = "file:///p/a.rct";

/// Returns the lines `from` to `to` with their hints in brackets.
std::string hinted(const std::string& text, int from = 0, int to = 1000) {
    Client client;
    client.open(hinted_uri, text);
    const auto at = [](int line) { return Json::object({{"line", line}, {"character", 0}}); };
    const Json params = Json::object({{"textDocument", Json::object({{"uri", hinted_uri}})},
                                      {"range", Json::object({{"start", at(from)}, {"end", at(to)}})}});
    std::map<std::size_t, std::string> labels;
    const Answer hints = client.request("textDocument/inlayHint", params);
    for (const Answer& hint : hints.items())
        labels[client.text_before(hinted_uri, hint["position"]).size()] = hint["label"].text();
    std::string out = text;
    for (auto label = labels.rbegin(); label != labels.rend(); ++label)
        out.insert(label->first, "[" + label->second + "]");
    return out;
}

TEST(InlayHints, TypesOfLetVariables) {
    EXPECT_EQ(hinted("interface I { const a : boolean = let x == 1, s == <true> @ x > 0 }\n"),
              "interface I { const a : boolean = let x[: nat] == 1, s[: Seq(boolean)] == <true> @ x > 0 }\n");
    const std::string written = "interface I { const a : boolean = forall x : nat | x > 1 @ x > 0 }\n";
    EXPECT_EQ(hinted(written), written);
}

TEST(InlayHints, TypesThatAreNotKnownAreNotShown) {
    const std::string text = "interface I { const a : boolean = let x == <>, y == lost @ true }\n";
    EXPECT_EQ(hinted(text), text);
}

TEST(InlayHints, ValuesOfConstantsWithArithmetic) {
    EXPECT_EQ(hinted("interface I { const n : nat = 4 const m : nat = 2 * (n + 1) const k : int = m - 12 }\n"),
              "interface I { const n : nat = 4 const m : nat = 2 * (n + 1)[= 10] const k : int = m - 12[= -2] }\n");
}

TEST(InlayHints, WhatHasNoCertainValueIsNotShown) {
    for (const char* text : {"interface I { const open : nat const m : nat = open + 1 }\n",
                             "interface I { const a : nat = b + 1 const b : nat = a + 1 }\n",
                             "interface I { const a : nat = 9223372036854775807 + 1 }\n",
                             "interface I { const a : nat = 99999999999999999999 + 1 }\n",
                             "interface I { const a : nat = 7 / 2 const b : real = 1 + 1 const c : int = -3 }\n",
                             "interface I { const a : nat = 1 - 2 }\n", "interface I { const a : nat = 1 + }\n",
                             "interface I { var a : nat = 1 + 1 }\n"})
        EXPECT_EQ(hinted(text), text);
}

TEST(InlayHints, AreThoseOfTheRange) {
    EXPECT_EQ(hinted("interface I {\n const a : nat = 1 + 1\n const b : nat = 2 + 2\n}\n", 2, 3),
              "interface I {\n const a : nat = 1 + 1\n const b : nat = 2 + 2[= 4]\n}\n");
}

}  // namespace
}  // namespace robochart::lsp
