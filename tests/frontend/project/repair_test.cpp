// SPDX-License-Identifier: Apache-2.0
// Tests certain fixes on every example of the rules. The text that `validate --fix` would write must be better than the
// original.
#include "base/repair/repair.hpp"

#include <gtest/gtest.h>
#include <algorithm>

#include <filesystem>
#include <set>

#include "base/diagnostics/fixes.hpp"
#include "frontend/syntax/syntax_rules.hpp"
#include "tests/frontend/fixture.hpp"
#include "tests/rounds.hpp"
#include "tests/source_folder.hpp"

namespace robochart::frontend {
namespace {

namespace fs = std::filesystem;
using diagnostics::Texts;

std::unique_ptr<diagnostics::TextReading> read_texts(const Texts& texts) {
    auto reading = std::make_unique<diagnostics::TextReading>();
    std::vector<diagnostics::SourceId> sources;
    for (const auto& [path, text] : texts) sources.push_back(reading->sources.add(path, text));
    (void)load_texts(reading->sources, sources, reading->findings);
    return reading;
}

diagnostics::Repaired repaired(const Texts& texts) {
    return diagnostics::repair(texts, read_texts, syntax::is_syntax);
}

/// Returns 0 for syntax errors, 1 for other errors, and 2 for warnings.
int level_of(const diagnostics::Rule& rule) {
    if (syntax::is_syntax(rule)) return 0;
    return rule.severity == diagnostics::Severity::error ? 1 : 2;
}

std::multiset<std::string> texts_of(const diagnostics::TextReading& reading, int level) {
    std::multiset<std::string> result;
    for (const diagnostics::Diagnostic& finding : reading.findings.sorted_findings())
        if (level_of(*finding.rule) == level) result.insert(std::string(finding.rule->code) + " " + finding.message());
    return result;
}

bool includes(const std::multiset<std::string>& all, const std::multiset<std::string>& some) {
    return std::ranges::includes(all, some);
}

/// Returns the texts after one fix.
Texts with_fix(const diagnostics::TextReading& reading, const Texts& texts, const diagnostics::FixIt& fix) {
    Texts result = texts;
    std::string& text = result.at(reading.sources.path(fix.span.source));
    text = diagnostics::apply_fixes(text, {fix});
    return result;
}

/// Checks that there are fewer findings of some level, and no new findings of this level or of levels that could hide
/// it.
void expect_better(const diagnostics::TextReading& before, const diagnostics::TextReading& after,
                   const std::string& what) {
    for (int level = 0; level < 3; ++level) {
        const auto old = texts_of(before, level);
        const auto now = texts_of(after, level);
        EXPECT_TRUE(includes(old, now)) << what << diagnostics::render_text(after.sources, after.findings);
        if (now.size() < old.size()) return;
    }
    ADD_FAILURE() << what << "nothing is better";
}

/// Checks that each certain fix improves the text, and that all fixes that can be made together do.
void expect_repaired(const Texts& texts, std::size_t& fixes) {
    const auto before = read_texts(texts);
    for (const diagnostics::Diagnostic& finding : before->findings.sorted_findings()) {
        if (finding.fixes.empty() || !diagnostics::is_certain(finding.fixes.front())) continue;
        ++fixes;
        const auto after = read_texts(with_fix(*before, texts, finding.fixes.front()));
        expect_better(*before, *after,
                      before->sources.path_and_line(finding.span) + ": " + finding.message() + " -> `" +
                          finding.fixes.front().replacement + "`\n");
    }
    const diagnostics::Repaired result = repaired(texts);
    if (result.made == 0) return;
    Texts with = texts;
    for (const auto& [path, text] : result.texts) with[path] = text;
    expect_better(*before, *read_texts(with), "together\n");
}

bool is_read(const fs::path& path) {
    return path.extension() == ".rct" || path.extension() == ".assertions";
}

TEST(Repair, MakesEveryFixtureBetter) {
    std::size_t fixes = 0;
    for (const fs::directory_entry& entry :
         fs::recursive_directory_iterator(tests::source_folder() / "tests/frontend/fixtures")) {
        if (!is_read(entry.path())) continue;
        SCOPED_TRACE(entry.path().string());
        expect_repaired({{entry.path().filename().string(), testing::read_contents(entry.path().string())}}, fixes);
    }
    EXPECT_GT(fixes, 3U);
}

/// The fenced blocks of one example. Each block is a file.
struct Example {
    Texts texts;
};

std::vector<Example> examples_of(const std::string& page) {
    std::vector<Example> result(1);
    std::istringstream lines(page);
    std::string line;
    std::string language;
    std::string file;
    for (std::size_t number = 0; std::getline(lines, line);) {
        if (line.starts_with("#")) result.emplace_back();
        if (!line.starts_with("```")) {
            if (!file.empty()) result.back().texts[file] += line + "\n";
            continue;
        }
        const bool ends = !language.empty();
        language = ends ? "" : line.substr(3) + " ";
        file.clear();
        const bool model = language.starts_with("robochart ");
        if (!model && !language.starts_with("assertions ")) continue;
        const std::size_t named = language.find("file=");
        if (named == std::string::npos)
            file = std::to_string(number++) + (model ? ".rct" : ".assertions");
        else
            file = language.substr(named + 5, language.find(' ', named) - named - 5);
    }
    return result;
}

TEST(Repair, MakesEveryExampleOfAPageBetter) {
    std::set<fs::path> pages;
    for (const fs::directory_entry& entry : fs::directory_iterator(tests::source_folder() / "docs/rules"))
        if (entry.path().extension() == ".md") pages.insert(entry.path());
    std::size_t fixes = 0;
    std::size_t page_number = 0;
    for (const fs::path& page : pages) {
        if (page_number++ % tests::distance_of_places(1) != 0) continue;
        for (const Example& example : examples_of(testing::read_contents(page.string()))) {
            if (example.texts.empty()) continue;
            SCOPED_TRACE(page.filename().string());
            expect_repaired(example.texts, fixes);
        }
    }
    EXPECT_GT(fixes, tests::sanitized ? 2U : 20U);
}

// ---------------------------------------------------------------- fixes that are not written

/// A test rule that reports every `x` and every `yy`.
const diagnostics::Rule wrong{"T1", diagnostics::Severity::error, "{}"};

std::unique_ptr<diagnostics::TextReading> find_x(const Texts& texts, const std::string& instead) {
    auto reading = std::make_unique<diagnostics::TextReading>();
    for (const auto& [path, text] : texts) {
        const auto source = reading->sources.add(path, text);
        for (std::uint32_t i = 0; i < text.size(); ++i) {
            if (text[i] == 'x')
                reading->findings.report(wrong, {source, i, i + 1}, {"x"})
                    .fixes.push_back({{source, i, i + 1}, instead, "write"});
            if (text.compare(i, 2, "yy") == 0) reading->findings.report(wrong, {source, i, i + 2}, {"yy"});
        }
    }
    return reading;
}

diagnostics::Repaired without_x(const std::string& text, const std::string& instead) {
    return diagnostics::repair(
        {{"a", text}}, [&](const Texts& texts) { return find_x(texts, instead); },
        [](const diagnostics::Rule&) { return false; });
}

/// The fix next to a `y` would replace one finding by another, so only this fix is skipped.
TEST(Repair, LeavesOutTheFixThatBringsAFinding) {
    const diagnostics::Repaired result = without_x("x.x.yx.x.x", "y");
    EXPECT_EQ(result.texts, (Texts{{"a", "y.y.yx.y.y"}}));
    EXPECT_EQ(result.made, 4U);
    ASSERT_EQ(result.refused.size(), 1U);
    EXPECT_EQ(result.refused.front().place, "a:1");
    EXPECT_EQ(result.refused.front().code, "T1");
}

TEST(Repair, WritesNothingWhereAFixDoesNotHelp) {
    const diagnostics::Repaired result = without_x("x", "x");
    EXPECT_TRUE(result.texts.empty());
    EXPECT_EQ(result.made, 0U);
    EXPECT_EQ(result.refused.size(), 1U);
}

}  // namespace
}  // namespace robochart::frontend
