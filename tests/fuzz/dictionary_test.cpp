// SPDX-License-Identifier: Apache-2.0
// Tests that the fuzzers' dictionaries contain every word and symbol of the languages, each as a single token.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>

#include "checker/cspm/syntax/lexer.hpp"
#include "frontend/syntax/lexer.hpp"
#include "tests/editors/assertion_words.hpp"
#include "tests/source_folder.hpp"

namespace robochart::fuzz {
namespace {

/// Returns the entries of a dictionary in libFuzzer's format: one `"text"` per line, with `\\` and `\"` as escapes, and
/// comments after `#`.
std::set<std::string> dictionary(const std::string& name) {
    std::ifstream in(tests::source_folder().string() + "/tests/fuzz/" + name);
    std::set<std::string> entries;
    for (std::string line; std::getline(in, line);) {
        if (line.empty() || line.front() == '#') continue;
        EXPECT_TRUE(line.size() > 2 && line.front() == '"' && line.back() == '"') << line;
        std::string text;
        for (std::size_t at = 1; at + 1 < line.size(); ++at) text += line[line[at] == '\\' ? ++at : at];
        EXPECT_TRUE(entries.insert(text).second) << line << " stands twice";
    }
    return entries;
}

TEST(Dictionaries, RoboChart) {
    const auto entries = dictionary("robochart.dict");
    for (const std::string_view word : frontend::reserved_words())
        EXPECT_TRUE(entries.contains(std::string(word))) << word;
    for (const std::string_view symbol : frontend::symbol_words())
        EXPECT_TRUE(entries.contains(std::string(symbol))) << symbol;
    for (const std::string& word : editors::assertion_words()) EXPECT_TRUE(entries.contains(word)) << word;
    EXPECT_GT(editors::assertion_words().size(), 40U);
}

/// The table of words contains the words with which the parser compares.
TEST(Dictionaries, WordsOfAssertions) {
    const auto table = frontend::assertion_words();
    EXPECT_TRUE(std::ranges::is_sorted(table));
    for (const std::string& joined : editors::assertion_words()) {
        std::istringstream parts(joined);
        if (joined == "write") continue;  // the title of a fix
        for (std::string word; std::getline(parts, word, '-');)
            EXPECT_TRUE(frontend::is_reserved(word) || std::ranges::binary_search(table, word)) << word;
    }
}

/// Returns true for token kinds whose spelling is a description and not their text.
bool has_no_text(cspm::Tok kind) {
    using cspm::Tok;
    const std::set<Tok> described{Tok::end,       Tok::newline, Tok::bad,      Tok::identifier,     Tok::integer,
                                  Tok::character, Tok::string,  Tok::property, Tok::empty_sequence, Tok::of_type,
                                  Tok::print,     Tok::include};
    return described.contains(kind);
}

TEST(Dictionaries, Cspm) {
    const auto entries = dictionary("cspm.dict");
    for (int i = 0; i <= static_cast<int>(cspm::Tok::underscore); ++i) {
        const auto kind = static_cast<cspm::Tok>(i);
        if (has_no_text(kind)) continue;
        EXPECT_TRUE(entries.contains(std::string(cspm::spelling(kind)))) << cspm::spelling(kind);
    }
    EXPECT_THAT(entries, ::testing::IsSupersetOf({"print ", "include ", "<>", "::", "--", "{-", "-}"}));
}

}  // namespace
}  // namespace robochart::fuzz
