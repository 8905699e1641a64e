// SPDX-License-Identifier: Apache-2.0
// Tests that links in the project's documents lead to existing files and, after `#`, to existing headings.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>
#include <sstream>
#include <vector>

#include "tests/sanity/source_tree.hpp"

namespace robochart::sanity {
namespace {

namespace fs = std::filesystem;

/// Returns the text outside fenced blocks.
std::string prose(const std::string& text) {
    std::istringstream lines(text);
    std::string result;
    bool fenced = false;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("```"))
            fenced = !fenced;
        else if (!fenced)
            result += line + "\n";
    }
    return result;
}

/// Returns the anchor of a heading, as Git servers generate it: lower case, hyphens for spaces, no punctuation.
std::string anchor(const std::string& heading) {
    std::string result;
    for (const char c : heading) {
        if (c == ' ' || c == '-')
            result += '-';
        else if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_')
            result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    return result;
}

std::vector<std::string> anchors(const std::string& text) {
    std::istringstream lines(prose(text));
    std::vector<std::string> result;
    for (std::string line; std::getline(lines, line);) {
        const std::size_t title = line.find_first_not_of('#');
        if (title != 0 && title != std::string::npos && line[title] == ' ')
            result.push_back(anchor(line.substr(title + 1)));
    }
    return result;
}

/// Returns the links to files of the project.
std::set<std::string> links(const std::string& text) {
    const std::string all = prose(text);
    std::set<std::string> result;
    for (std::size_t at = all.find("]("); at != std::string::npos; at = all.find("](", at + 1)) {
        const std::string link = all.substr(at + 2, all.find(')', at) - at - 2);
        if (!link.starts_with("http")) result.insert(link);
    }
    return result;
}

/// Describes why a link of a document is broken. Returns "" if it is not.
std::string broken(const fs::path& document, const std::string& link) {
    const std::size_t mark = link.find('#');
    const std::string file = link.substr(0, mark);
    const fs::path target = file.empty() ? document : document.parent_path() / file;
    if (!fs::exists(target)) return "there is no such file";
    if (mark == std::string::npos || target.extension() != ".md") return "";
    const std::vector<std::string> there = anchors(read_contents(target));
    return std::ranges::count(there, link.substr(mark + 1)) > 0 ? "" : "there is no such heading";
}

TEST(Links, LeadToFilesAndHeadings) {
    const std::set<std::string> examples = {"CODE.md"};  // a pattern in docs/rules/README.md
    std::size_t found = 0;
    for (const fs::path& document : files(root(), {".md"}))
        for (const std::string& link : links(read_contents(document))) {
            ++found;
            EXPECT_TRUE(examples.contains(link) || broken(document, link).empty())
                << document << ": " << link << ": " << broken(document, link);
        }
    EXPECT_GT(found, 500U);
}

/// A link to a repeated heading would lead to the first one. Headings are also repeated if a merge keeps both versions
/// of a part of a document. In a changelog every release repeats Added, Changed and Fixed.
TEST(Links, HeadingsOfADocumentDiffer) {
    for (const fs::path& document : files(root(), {".md"})) {
        if (document.filename() == "CHANGELOG.md") continue;
        std::vector<std::string> there = anchors(read_contents(document));
        std::ranges::sort(there);
        const auto twice = std::ranges::adjacent_find(there);
        EXPECT_TRUE(twice == there.end()) << document << ": " << *twice;
    }
}

TEST(Links, AreFoundOutsideBlocks) {
    EXPECT_EQ(links("[a](b.md#c) [d](https://e)\n```\n[f](g.md)\n```\n"), std::set<std::string>{"b.md#c"});
    EXPECT_EQ(anchors("# A b\n## `c`: D-e\n```\n# no\n```\n#no\n"), (std::vector<std::string>{"a-b", "c-d-e"}));
    EXPECT_EQ(broken(root() / "README.md", "docs/cli.md#options"), "");
    EXPECT_NE(broken(root() / "README.md", "docs/cli.md#no-heading"), "");
    EXPECT_NE(broken(root() / "README.md", "docs/no_page"), "");
}

}  // namespace
}  // namespace robochart::sanity
