// SPDX-License-Identifier: Apache-2.0
// Tests rules of the project that a program can check: file heads, rules with fixtures, no leftovers.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "app/command/rules.hpp"
#include "base/rule_pages/rule_pages.hpp"
#include "tests/needed.hpp"
#include "tests/sanity/source_tree.hpp"

namespace robochart::sanity {
namespace {

namespace fs = std::filesystem;

TEST(Sanity, EveryComponentIsInTheArchitecture) {
    const std::string text = read_contents(root() / "docs/architecture.md");
    for (const auto& entry : fs::directory_iterator(root())) {
        const std::string name = entry.path().filename().string();
        const bool component = entry.is_directory() && fs::exists(entry.path() / "CMakeLists.txt");
        if (!component) continue;
        EXPECT_THAT(text, ::testing::HasSubstr(name + "/"))
            << "docs/architecture.md does not name the component " << name;
    }
}

/// Generated code and code that ships with it name the licence in their head comments instead.
TEST(Sanity, SourcesNameTheirLicence) {
    const std::string_view generated[] = {"cpp_emit/runtime/", "cpp_emit/projects/", "benchmarks/code/", "/golden/"};
    for (const fs::path& path : files(root(), {".hpp", ".cpp"})) {
        const std::string name = path.string();
        if (std::ranges::any_of(generated, [&](std::string_view part) { return name.find(part) != std::string::npos; }))
            continue;
        EXPECT_TRUE(read_contents(path).starts_with("// SPDX-License-Identifier: Apache-2.0\n"))
            << path << " does not begin with the line of its licence";
    }
}

TEST(Sanity, HeadersSayWhatTheyAreForAndAreGuarded) {
    for (const fs::path& path : files(root(), {".hpp"})) {
        std::string text = read_contents(path);
        const std::string licence = "// SPDX-License-Identifier: Apache-2.0\n";
        if (text.starts_with(licence)) text.erase(0, licence.size());
        EXPECT_TRUE(text.starts_with("//")) << path << " has no head comment";
        // Headers that are shipped with generated code use portable include guards.
        const bool guarded =
            text.find("#pragma once") != std::string::npos || text.find("#ifndef ROBOCHART_") != std::string::npos;
        EXPECT_TRUE(guarded) << path << " has no include guard";
    }
}

TEST(Sanity, NoLeftovers) {
    const std::string marks[] = {std::string("TO") + "DO", std::string("FIX") + "ME", std::string("XX") + "X "};
    for (const fs::path& path : files(root(), {".hpp", ".cpp", ".h", ".txt", ".cmake", ".sh", ".rct", ".assertions"})) {
        const std::string text = read_contents(path);
        for (const std::string& mark : marks) EXPECT_EQ(text.find(mark), std::string::npos) << path << " has " << mark;
    }
}

/// Tests run at the same time, so several of them would use a file with a fixed path.
TEST(Sanity, TestsMakeTemporaryFoldersInOnePlace) {
    const std::string marks[] = {std::string("Temp") + "Dir()", std::string("temp_directory") + "_path",
                                 std::string("mkd") + "temp"};
    for (const fs::path& path : files(root() / "tests", {".hpp", ".cpp"})) {
        if (path.stem() == "temporary_folder") continue;
        const std::string text = read_contents(path);
        for (const std::string& mark : marks)
            EXPECT_EQ(text.find(mark), std::string::npos)
                << path << " has " << mark << "; tests/temporary_folder.hpp makes temporary folders";
    }
}

/// A source that forgets this include may still compile in a build of all sources together, because another source
/// includes the header.
TEST(Sanity, FilesThatUseAlgorithmsIncludeThem) {
    const char* const functions[] = {"all_of", "any_of",  "none_of",     "count_if", "equal",   "fill",
                                     "find",   "find_if", "max",         "min",      "reverse", "sort",
                                     "copy",   "rotate",  "stable_sort", "unique"};
    const std::string header = "#include <algorithm>";
    for (const fs::path& path : files(root(), {".hpp", ".cpp"})) {
        const std::string text = read_contents(path);
        const std::string own = read_contents(fs::path(path).replace_extension(".hpp"));
        if (text.find(header) != std::string::npos || own.find(header) != std::string::npos) continue;
        for (const std::string name : functions)
            for (const char* const scope : {"std::", "std::ranges::"})
                EXPECT_EQ(text.find(scope + name + "("), std::string::npos)
                    << path << " uses " << scope << name << " without " << header;
    }
}

/// Text from models is ForeignText until a function of base/diagnostics/escape.hpp returns it. This test lists the
/// files that access it directly. These either compute with its characters, or pass it to a syntax tree whose printer
/// escapes it.
TEST(Sanity, ForeignTextIsLetOutByTheEscapersAlone) {
    const std::set<std::string> seams = {"csp_emit/expressions/expressions.cpp", "csp_emit/compose/instantiations.cpp",
                                         "base/diagnostics/escape.cpp", "base/diagnostics/escape.hpp",
                                         "semantics/evaluate/evaluate_composed.cpp"};
    for (const std::string& name : program_files()) {
        const bool looks = read_contents(root() / name).find("unescaped()") != std::string::npos;
        EXPECT_TRUE(!looks || seams.contains(name)) << name << " looks at foreign text";
    }
}

/// There is only one function per language that escapes text. A file that writes a backslash before a quote would be a
/// second one.
TEST(Sanity, NobodyElseEscapes) {
    const std::string by_hand[] = {"'\"' || c == '\\\\'", "&quot;", "&lt;"};
    for (const std::string& name : program_files()) {
        if (name == "base/diagnostics/escape.cpp" || name == "base/diagnostics/json.cpp" ||
            name.starts_with("cpp_emit/runtime/"))
            continue;
        for (const std::string& text : by_hand)
            EXPECT_EQ(read_contents(root() / name).find(text), std::string::npos)
                << name << " escapes by hand: " << text;
    }
}

/// One function starts all programs. It uses no shell, so it passes their arguments unchanged.
TEST(Sanity, NoShellIsStarted) {
    const std::regex start(R"((std::system|[^\w]::system|popen|execlp?|execle|execvp?e?|posix_spawnp?)\s*\()");
    for (const std::string& name : program_files()) {
        if (name == "base/diagnostics/programs.cpp") continue;
        EXPECT_FALSE(std::regex_search(read_contents(root() / name), start)) << name << " starts a program";
    }
}

/// Returns whether the text contains the code as a word: `Cn10` does not contain `Cn1`.
bool names_code(const std::string& text, std::string_view code) {
    const auto in_word = [&](std::size_t at) {
        return at < text.size() && std::isalnum(static_cast<unsigned char>(text[at])) != 0;
    };
    for (std::size_t at = text.find(code); at != std::string::npos; at = text.find(code, at + 1))
        if ((at == 0 || !in_word(at - 1)) && !in_word(at + code.size())) return true;
    return false;
}

TEST(Sanity, EveryRuleIsShownOrTested) {
    std::string tests;
    for (const fs::path& path : files(root() / "tests", {".cpp", ".hpp", ".rct", ".assertions", ".csp"}))
        if (path.filename() != "pages_test.cpp") tests += read_contents(path);
    std::set<std::string_view> codes;
    std::set<std::pair<std::string_view, std::string_view>> rows;
    for (const diagnostics::Rule* rule : app::all_rules()) {
        codes.insert(rule->code);
        EXPECT_TRUE(rows.emplace(rule->code, rule->message).second) << rule->code << " stands twice";
        // tests/rules runs the examples of the rule's page.
        const bool shown = diagnostics::page_text(rule->code).find("\n## Wrong\n") != std::string_view::npos;
        EXPECT_TRUE(shown || names_code(tests, rule->code))
            << "no page shows and no test or fixture names rule " << rule->code;
    }
    EXPECT_GT(codes.size(), 50U);
}

/// .clang-format applies to all sources; folders with generated texts have their own file that disables it.
TEST(Sanity, SourcesAreLaidOutByClangFormat) {
    ROBOCHART_NEEDS(std::system("clang-format --version > /dev/null 2>&1") == 0, "clang-format");
    std::vector<std::string> folders = components();
    folders.insert(folders.end(), {"benchmarks", "tests"});
    for (const std::string& folder : folders) {
        std::string command = "clang-format --dry-run -Werror";
        for (const fs::path& path : files(root() / folder, {".cpp", ".hpp", ".h"}))
            command += " '" + path.string() + "'";
        EXPECT_EQ(std::system(command.c_str()), 0) << folder;
    }
}

/// Paths in documentation and comments that are relative to the root or to tests/ must exist.
TEST(Sanity, PathsInTextsExist) {
    const std::regex path(
        R"((?:^|[^\w/.-])((?:app|base|benchmarks|checker|claims|conformance|corpus|counterexample|cpp_emit|csp_emit|docs|driver|editors|frontend|prism|scripts|semantics|simulation|tests)/[a-zA-Z0-9_/-]+\.(?:cpp|hpp|h|md|sh|py|txt|rct)\b))");
    const std::set<std::string> examples = {"docs/rules/CODE.md"};
    std::size_t found = 0;
    for (const fs::path& file : files(root(), {".md", ".cpp", ".hpp", ".sh", ".txt", ".cmake"})) {
        const std::string relative = fs::relative(file, root()).string();
        if (relative == "CHANGELOG.md" || relative.find("/runtime/") != std::string::npos ||
            relative.find("/reserved/") != std::string::npos)
            continue;
        const std::string text = read_contents(file);
        for (auto at = std::sregex_iterator(text.begin(), text.end(), path); at != std::sregex_iterator(); ++at) {
            const std::string name = (*at)[1];
            ++found;
            EXPECT_TRUE(fs::exists(root() / name) || fs::exists(root() / "tests" / name) || examples.contains(name))
                << relative << " names " << name;
        }
    }
    EXPECT_GT(found, 1000U);
}

/// Returns the texts between backquotes that match.
std::set<std::vector<std::string>> quoted(const std::string& text, const std::string& pattern) {
    std::set<std::vector<std::string>> found;
    const std::regex expression(pattern);
    for (auto at = std::sregex_iterator(text.begin(), text.end(), expression); at != std::sregex_iterator(); ++at)
        found.insert({(*at)[1], (*at)[2]});
    return found;
}

/// Returns a source by its path, or by its name alone if it is below csp_emit.
fs::path source(const std::string& name) {
    if (name.find('/') != std::string::npos) return root() / name;
    for (const fs::path& path : files(root() / "csp_emit", {".cpp"}))
        if (path.filename() == name) return path;
    return {};
}

TEST(Sanity, TheSemanticsNamesFunctionsAndTestsThatExist) {
    const std::string text = read_contents(root() / "docs/semantics.md");
    std::string tests;
    for (const fs::path& path : files(root() / "tests", {".cpp"})) tests += read_contents(path);
    const auto named_tests = quoted(text, "`([A-Z][A-Za-z]+)\\.([A-Z][A-Za-z]+)`");
    EXPECT_GT(named_tests.size(), 50U);
    for (const auto& name : named_tests) {
        const bool there = std::regex_search(tests, std::regex("TEST(_F|_P)?\\(" + name[0] + ", " + name[1] + "\\)"));
        EXPECT_TRUE(there) << "docs/semantics.md names the test " << name[0] << "." << name[1];
    }
    const auto functions = quoted(text, "`([a-z_/]+\\.cpp): ([a-z_]+)`");
    EXPECT_GT(functions.size(), 50U);
    for (const auto& function : functions) {
        EXPECT_THAT(read_contents(source(function[0])), ::testing::HasSubstr(function[1] + "("))
            << "docs/semantics.md names " << function[0];
    }
}

/// Returns the lines of switches over a kind of the IR that have a `default:`.
std::vector<std::size_t> silent_switches(const fs::path& path) {
    const std::regex over_kind(R"(^\s*case (ir::)?(Type|Expr|Stmt|Node|Machine|Comm|Component|Property|End)Kind::.*)");
    std::vector<std::size_t> found;
    std::vector<bool> kinds;  // for each enclosing switch, whether it is over a kind
    std::istringstream lines(read_contents(path));
    std::string line;
    for (std::size_t number = 1; std::getline(lines, line); ++number) {
        if (std::regex_match(line, std::regex(R"(^\s*switch \(.*)"))) kinds.push_back(false);
        if (kinds.empty()) continue;
        if (std::regex_match(line, over_kind)) kinds.back() = true;
        if (!std::regex_match(line, std::regex(R"(^\s*default:.*)"))) continue;
        if (kinds.back()) found.push_back(number);
        kinds.pop_back();
    }
    return found;
}

/// If a switch has no `default:`, the compiler reports each kind that it lacks.
TEST(Sanity, SwitchesOverKindsOfTheIrHaveNoDefault) {
    for (const char* component : {"semantics", "csp_emit", "cpp_emit", "conformance"})
        for (const fs::path& path : files(root() / component, {".cpp", ".hpp"}))
            EXPECT_THAT(silent_switches(path), ::testing::IsEmpty()) << path;
}

}  // namespace
}  // namespace robochart::sanity
