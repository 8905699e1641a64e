// SPDX-License-Identifier: Apache-2.0
// Tests frames, JSON and positions. The server does not trust the contents of messages from outside.
#include <gtest/gtest.h>

#include <random>
#include <sstream>

#include "editors/server/protocol/positions.hpp"
#include "editors/server/protocol/transport.hpp"
#include "editors/server/server.hpp"
#include "tests/editors/server/answer.hpp"
#include "tests/rounds.hpp"

namespace robochart::lsp {
namespace {

using testing::Answer;

std::string framed(const std::string& text) {
    return "Content-Length: " + std::to_string(text.size()) + "\r\n\r\n" + text;
}

/// Returns "M:text" for each message of a stream and "F:reason" for each error.
std::vector<std::string> frames(const std::string& bytes) {
    std::istringstream in(bytes);
    FrameReader reader(in);
    std::vector<std::string> result;
    while (true) {
        const Frame frame = reader.next_frame();
        if (frame.kind == Frame::Kind::end) return result;
        result.push_back((frame.kind == Frame::Kind::message ? "M:" : "F:") + frame.text);
    }
}

TEST(Frames, AreReadOneAfterTheOther) {
    EXPECT_EQ(frames(framed("{}") + framed("[1]")), (std::vector<std::string>{"M:{}", "M:[1]"}));
    EXPECT_EQ(frames("content-length:2\r\nContent-Type: application/vscode-jsonrpc; charset=utf-8\r\n\r\n{}"),
              std::vector<std::string>{"M:{}"});
    EXPECT_EQ(frames("X-Other: 1\r\nContent-Length: 2\r\n\r\n{}"), std::vector<std::string>{"M:{}"});
    EXPECT_EQ(frames(framed("")), std::vector<std::string>{"M:"});
    EXPECT_TRUE(frames("").empty());
}

TEST(Frames, OfWrongHeadersAreRefusedAndReadingGoesOn) {
    for (const std::string wrong :
         {"Content-Length: -1\r\n\r\n", "Content-Length: 12x\r\n\r\n", "Content-Length:\r\n\r\n", "nonsense\r\n\r\n",
          "Content-Length: 99999999999999999999999\r\n\r\n", "Content-Length: 9999999999\r\n\r\n", "X: y\r\n\r\n",
          "Content-Type: text/plain; charset=latin-1\r\nContent-Length: 2\r\n\r\n{}"}) {
        const auto found = frames(wrong + framed("{}"));
        ASSERT_EQ(found.size(), 2U) << wrong;
        EXPECT_EQ(found[0].substr(0, 2), "F:") << wrong;
        EXPECT_EQ(found[1], "M:{}") << wrong;
    }
}

TEST(Frames, CutShortAreFaults) {
    const std::string whole = framed("{\"a\":1}");
    for (std::size_t length = 1; length < whole.size(); ++length) {
        const auto found = frames(whole.substr(0, length));
        ASSERT_EQ(found.size(), 1U) << length;
        EXPECT_EQ(found[0].substr(0, 2), "F:") << length;
    }
}

TEST(Frames, WithAnEndlessHeaderLineNeedLittleMemory) {
    EXPECT_EQ(frames(std::string(1U << 20U, 'x') + "\r\n\r\n" + framed("{}")).back(), "M:{}");
}

TEST(JsonText, IsReadAndWritten) {
    std::string error;
    const std::string text = R"({"a":[1,-2,2.5,true,null],"b":{"c":"\u00e4\n\ud83d\ude00"},"d":[],"e":{}})";
    const Answer value = read_json(text, error);
    EXPECT_EQ(error, "");
    EXPECT_EQ(value["b"]["c"].text(), "ä\n😀");
    EXPECT_EQ(value["a"][1].number(), -2);
    EXPECT_TRUE(value["a"][9].is_null());
    EXPECT_EQ(read_json(value.write(), error), value);
}

/// RFC 8259 lets the reader decide in two cases: numbers out of range, and several members with one key.
TEST(JsonText, OfAnyShapeIsAskedSafely) {
    std::string error;
    const Answer value = read_json(R"({"a":18446744073709551615,"b":1.5,"a":2,"n":{"x":"y"}})", error);
    EXPECT_EQ(error, "");
    EXPECT_EQ(value["a"].number(-1), -1) << "no integer of 64 bits with sign";
    EXPECT_EQ(value["b"].number(-1), -1);
    EXPECT_TRUE(value["a"]["x"][3]["y"].is_null());
    EXPECT_EQ(value["n"][0].text() + value["n"]["z"].text(), "");
    EXPECT_TRUE(value["n"].items().empty());
    EXPECT_FALSE(value["b"].has("x"));
}

/// Adding a member does not search for its key first, which would take minutes here.
TEST(JsonText, WithManyMembersIsReadInLinearTime) {
    std::string text = "{";
    for (int i = 0; i < 300'000; ++i) text += "\"k" + std::to_string(i) + "\":0,";
    std::string error;
    EXPECT_EQ(Answer(read_json(text + "\"last\":7}", error))["last"].number(), 7);
}

TEST(JsonText, ThatIsWrongIsRefused) {
    for (const std::string text : {"", "{", "[1,]", "{\"a\"}", "nul", "\"\xff\"", "\"\\ud800\"", "1 2", "{\"a\":1}}"}) {
        std::string error;
        EXPECT_TRUE(read_json(text, error).is_null());
        EXPECT_NE(error, "") << text;
    }
    std::string error;
    EXPECT_TRUE(read_json(std::string(100000, '['), error).is_null());
    EXPECT_NE(error.find("deeper"), std::string::npos) << error;
}

// LSP 3.17, Position: columns count UTF-16 code units unless client and server agree otherwise. Lines end with LF, CR
// LF or CR.
TEST(Positions, CountCodeUnits) {
    SourceManager sources;
    const SourceId id = sources.add("t", "ab\r\nä😀z\rx\n");
    const auto at = [&](std::uint32_t offset, Encoding encoding) {
        const Answer place = lsp_position(sources, id, offset, encoding);
        return std::to_string(place["line"].number()) + ":" + std::to_string(place["character"].number());
    };
    EXPECT_EQ(at(1, Encoding::utf16), "0:1");
    EXPECT_EQ(at(4, Encoding::utf16), "1:0");
    EXPECT_EQ(at(6, Encoding::utf16), "1:1");
    EXPECT_EQ(at(10, Encoding::utf16), "1:3");
    EXPECT_EQ(at(10, Encoding::utf8), "1:6");
    EXPECT_EQ(at(10, Encoding::utf32), "1:2");
    EXPECT_EQ(at(12, Encoding::utf16), "2:0");
    EXPECT_EQ(at(14, Encoding::utf16), "3:0");
}

TEST(Positions, AndOffsetsAreInverse) {
    std::mt19937 random(7);
    const std::vector<std::string> pieces = {"a", " ", "\n", "\r\n", "\r", "ä", "€", "😀", "\xff", "\xe2\x82", "\t"};
    for (int round = 0; round < 200; ++round) {
        std::string text;
        for (int i = 0; i < 30; ++i) text += pieces[random() % pieces.size()];
        SourceManager sources;
        const SourceId id = sources.add("t", text);
        for (const Encoding encoding : {Encoding::utf8, Encoding::utf16, Encoding::utf32})
            for (std::uint32_t offset = 0; offset <= text.size(); ++offset) {
                const Answer place = lsp_position(sources, id, offset, encoding);
                const std::uint32_t back = offset_of(sources, id, place.json(), encoding);
                EXPECT_LE(back, offset);
                EXPECT_EQ(lsp_position(sources, id, back, encoding), place);
            }
    }
}

TEST(Positions, BeyondTheTextAreItsEnds) {
    SourceManager sources;
    const SourceId id = sources.add("t", "ab\ncd");
    const auto offset = [&](std::int64_t line, std::int64_t character) {
        return offset_of(sources, id, Json::object({{"line", line}, {"character", character}}), Encoding::utf16);
    };
    EXPECT_EQ(offset(0, 99), 2U);
    EXPECT_EQ(offset(1, 99), 5U);
    EXPECT_EQ(offset(99, 0), 5U);
    EXPECT_EQ(offset(-1, 5), 0U);
    EXPECT_EQ(offset(0, -5), 0U);
    EXPECT_EQ(offset(INT64_MAX, INT64_MAX), 5U);
}

/// Returns the server's answers to a stream, and its exit code.
std::pair<std::vector<std::string>, int> served(const std::string& bytes) {
    std::istringstream in(bytes);
    std::ostringstream out;
    const int code = serve(in, out);
    return {frames(out.str()), code};
}

const std::string initialize = framed(R"({"jsonrpc":"2.0","id":1,"method":"initialize","params":{"capabilities":{}}})");
const std::string shutdown = framed(R"({"jsonrpc":"2.0","id":2,"method":"shutdown"})");
const std::string leave = framed(R"({"jsonrpc":"2.0","method":"exit"})");

TEST(Stream, EndsWithTheCodesOfTheProtocol) {
    EXPECT_EQ(served(initialize + shutdown + leave).second, 0);
    EXPECT_EQ(served(initialize + leave).second, 1);
    EXPECT_EQ(served(leave).second, 1);
    EXPECT_EQ(served(initialize).second, 1) << "the input ended without `exit`";
    EXPECT_EQ(served("").second, 1);
}

TEST(Stream, AnswersFaultsAndGoesOn) {
    const auto [answers, code] =
        served("garbage\r\n\r\n" + framed("{") + framed("[]") + framed("{}") + initialize + shutdown + leave);
    ASSERT_EQ(answers.size(), 6U);
    EXPECT_NE(answers[0].find("-32700"), std::string::npos);
    EXPECT_NE(answers[1].find("-32700"), std::string::npos);
    EXPECT_NE(answers[2].find("-32600"), std::string::npos);
    EXPECT_NE(answers[3].find("-32600"), std::string::npos);
    EXPECT_NE(answers[4].find("\"capabilities\""), std::string::npos);
    EXPECT_EQ(code, 0);
}

TEST(Stream, SurvivesGarbage) {
    std::mt19937 random(11);
    const std::string valid = initialize + shutdown + leave;
    for (std::size_t round = 0; round < tests::rounds(300); ++round) {
        std::string bytes;
        for (std::size_t i = 0, n = random() % 400; i < n; ++i) bytes += static_cast<char>(random() % 256);
        EXPECT_EQ(served(bytes).second, 1);
        // One byte of a valid conversation is changed.
        std::string damaged = valid;
        damaged[random() % damaged.size()] = static_cast<char>(random() % 256);
        const int code = served(damaged).second;
        EXPECT_TRUE(code == 0 || code == 1);
        served(valid.substr(0, random() % valid.size()));
    }
}

}  // namespace
}  // namespace robochart::lsp
