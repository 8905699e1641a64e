// SPDX-License-Identifier: Apache-2.0
// Tests that the project does not use the words that docs/glossary.md lists as not used: not in documentation,
// comments, messages or identifiers.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>
#include <string_view>

#include "tests/sanity/source_tree.hpp"

namespace robochart::sanity {
namespace {

namespace fs = std::filesystem;

/// An exception: the word is allowed in a line that contains `text`.
struct Allowed {
    std::string_view word, file, text, reason;
};

constexpr std::string_view fault_kind = "the name of a seeded fault, which reports print";
constexpr std::string_view script_name = "a name in emitted scripts, which users may have read or quoted";
constexpr std::string_view shipped = "an identifier in a header that ships with generated code";

constexpr Allowed allowed[] = {
    {"relayed", "cpp_emit/", "write_not_relayed", fault_kind},
    {"relayed", "tests/conformance/", "write_not_relayed", fault_kind},
    {"relay", "csp_emit/compose/composition.cpp", "Relay_", script_name},
    {"relay", "tests/app/phases/", "Relay_", script_name},
    {"relay", "tests/app/data_test.cpp", "elay", "the name of a shared model"},
    {"relay", "benchmarks/compare_data.py", "priority_relay", "the name of a shared model"},
    {"told", "cpp_emit/runtime/adaptive.hpp", "told(", shipped},
    {"told", "cpp_emit/runtime/console_choices.hpp", "told", shipped},
};

using Words = std::vector<std::string>;

/// A word with its line. `joins` is true if only blanks, comment marks and underscores separate it from the previous
/// word.
struct Token {
    std::string word;
    std::size_t line;
    bool joins;
};

bool is_letter(char c) {
    return std::isalpha(static_cast<unsigned char>(c)) != 0;
}

bool is_upper(char c) {
    return std::isupper(static_cast<unsigned char>(c)) != 0;
}

/// Returns the words in lower case. Identifiers in camel case and with underscores are split.
std::vector<Token> tokens(std::string_view text) {
    constexpr std::string_view between = " \t\r\n/*#_";
    std::vector<Token> result;
    std::size_t line = 1;
    bool joins = false;
    for (std::size_t i = 0; i < text.size();) {
        if (!is_letter(text[i])) {
            if (between.find(text[i]) == std::string_view::npos) joins = false;
            if (text[i++] == '\n') ++line;
            continue;
        }
        std::size_t end = i + 1;
        while (end < text.size() && is_letter(text[end])) {
            const bool lower_follows = end + 1 < text.size() && is_letter(text[end + 1]) && !is_upper(text[end + 1]);
            if (is_upper(text[end]) && (!is_upper(text[end - 1]) || lower_follows)) break;
            ++end;
        }
        Token token{std::string(text.substr(i, end - i)), line, joins};
        for (char& c : token.word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        result.push_back(std::move(token));
        joins = true;
        i = end;
    }
    return result;
}

Words words(std::string_view text) {
    Words result;
    for (Token& token : tokens(text)) result.push_back(std::move(token.word));
    return result;
}

constexpr std::string_view heading = "### Words that are not used\n";

/// Returns the texts between backquotes in the first column of the table below the heading.
std::vector<Words> words_not_used() {
    const std::string glossary = read_contents(root() / "docs/glossary.md");
    std::istringstream lines(glossary.substr(std::min(glossary.find(heading), glossary.size())));
    std::vector<Words> result;
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with("| `")) continue;
        std::istringstream column(line.substr(0, line.find(" | ", 2)));
        std::string outside, inside;
        while (std::getline(column, outside, '`') && std::getline(column, inside, '`')) result.push_back(words(inside));
    }
    return result;
}

/// Returns whether the wanted words start at this token.
bool begin_at(const Words& phrase, const std::vector<Token>& text, std::size_t at) {
    if (at + phrase.size() > text.size()) return false;
    for (std::size_t i = 0; i < phrase.size(); ++i)
        if (text[at + i].word != phrase[i] || (i > 0 && !text[at + i].joins)) return false;
    return true;
}

std::string joined(const Words& parts) {
    std::string result;
    for (const std::string& part : parts) result += (result.empty() ? "" : " ") + part;
    return result;
}

/// Returns (line, word) for every use.
std::vector<std::pair<std::size_t, std::string>> uses(const std::string& text, const std::vector<Words>& not_used) {
    std::vector<std::pair<std::size_t, std::string>> result;
    const std::vector<Token> all = tokens(text);
    for (std::size_t at = 0; at < all.size(); ++at)
        for (const Words& phrase : not_used)
            if (begin_at(phrase, all, at)) result.emplace_back(all[at].line, joined(phrase));
    return result;
}

/// Returns the texts of the project, except CHANGELOG.md, which is history, inputs of fuzzers, which stay as they were
/// found, certificates, which contain names from the RoboChart semantics, and this file, which lists the exceptions.
std::vector<std::string> texts() {
    std::vector<std::string> result;
    for (const fs::path& path : files(root(), {".cpp", ".hpp", ".h", ".txt", ".cmake", ".sh", ".py", ".js", ".md",
                                               ".rct", ".assertions", ".scenario", ".csp"})) {
        const std::string name = fs::relative(path, root()).string();
        const bool left_out = name.ends_with("CHANGELOG.md") || name == "tests/sanity/words_test.cpp" ||
                              name.starts_with("tests/fuzz/regressions/") ||
                              name.starts_with("corpus/aggregation/certificates/");
        if (!left_out) result.push_back(name);
    }
    return result;
}

TEST(Words, OfTheGlossarysLastSectionAreNotUsed) {
    const std::vector<Words> not_used = words_not_used();
    ASSERT_GT(not_used.size(), 20U);
    std::set<const Allowed*> needed;
    for (const std::string& name : texts()) {
        std::string text = read_contents(root() / name);
        if (name == "docs/glossary.md") text.resize(text.find(heading));
        std::vector<std::string> lines;
        std::istringstream in(text);
        for (std::string line; std::getline(in, line);) lines.push_back(line);
        for (const auto& [line, word] : uses(text, not_used)) {
            const auto found = std::find_if(std::begin(allowed), std::end(allowed),
                                            [&, line = line, word = word](const Allowed& exception) {
                                                return exception.word == word && name.starts_with(exception.file) &&
                                                       lines[line - 1].find(exception.text) != std::string::npos;
                                            });
            if (found != std::end(allowed))
                needed.insert(found);
            else
                ADD_FAILURE() << name << ":" << line << ": `" << word
                              << "`; docs/glossary.md says what to write instead";
        }
    }
    for (const Allowed& exception : allowed)
        EXPECT_TRUE(needed.contains(&exception)) << exception.file << ": `" << exception.word << "` is not used there";
}

/// The other tables name files and types, such as `checker/lts/event.hpp` and `ir::Machine`, which must exist.
TEST(Words, TheGlossaryNamesPlacesAndTypesThatExist) {
    std::string glossary = read_contents(root() / "docs/glossary.md");
    glossary.resize(glossary.find(heading));
    const std::regex place("`([a-z_]+(?:/[a-z_]+)+(?:\\.[a-z]+)?)`"), type("`[a-z_]+::([A-Z][A-Za-z]+)`");
    std::size_t found = 0;
    for (auto at = std::sregex_iterator(glossary.begin(), glossary.end(), place); at != std::sregex_iterator();
         ++at, ++found)
        EXPECT_TRUE(fs::exists(root() / (*at)[1].str())) << (*at)[1];
    std::string headers;
    for (const std::string& name : program_files())
        if (name.ends_with(".hpp")) headers += read_contents(root() / name);
    for (auto at = std::sregex_iterator(glossary.begin(), glossary.end(), type); at != std::sregex_iterator();
         ++at, ++found) {
        const std::string name = (*at)[1].str();
        const bool there = headers.find("struct " + name + " ") != std::string::npos ||
                           headers.find("class " + name + " ") != std::string::npos;
        EXPECT_TRUE(there) << name;
    }
    EXPECT_GT(found, 50U);
}

TEST(Words, AreFoundInTextAndIdentifiers) {
    const std::vector<Words> not_used = {{"room"}, {"fault", "of", "ours"}};
    using Found = std::vector<std::pair<std::size_t, std::string>>;
    EXPECT_EQ(uses("no\nRoom", not_used), (Found{{2, "room"}}));
    EXPECT_EQ(uses("make_room(HasRoomFor, classroom, ROOM)", not_used), (Found{{1, "room"}, {1, "room"}, {1, "room"}}));
    EXPECT_EQ(uses("// a fault\n/// of ours", not_used), (Found{{1, "fault of ours"}}));
    EXPECT_EQ(uses("a fault; of ours", not_used), Found{});
}

}  // namespace
}  // namespace robochart::sanity
