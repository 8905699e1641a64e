// SPDX-License-Identifier: Apache-2.0
// Tests that every rule has a page (docs/rules/CODE.md), and that every page is correct. Its wrong example must give
// exactly the findings in its comments (`// expect: CODE`), and its right example must give none.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "app/command/rules.hpp"
#include "example.hpp"
#include "robosim_examples.hpp"
#include "tests/source_folder.hpp"

namespace robochart {
namespace {

namespace fs = std::filesystem;
const fs::path fixtures = tests::source_folder() / "tests/frontend/fixtures";

/// Rules that no short example can violate. The tests of the component name them.
const std::set<std::string_view> without_example = {
    "RC-P02",   "RC-P08",   "RC-P14",    "RC-P23",    "RC-S03",    "RC-S04",    "RC-S05",    "RC-C02",    "RC-C03",
    "RC-C06",   "RC-D01",   "RC-D02",    "RC-D03",    "RC-G01",    "RC-G03",    "RC-G07",    "RC-G08",    "RC-G10",
    "RC-G12",   "RC-G13",   "RC-G14",    "RC-G15",    "RC-G16",    "RC-L01",    "RC-L02",    "RC-L03",    "RC-L04",
    "RC-M11",   "RC-M12",   "RC-M15",    "RC-M18",    "RC-A04",    "RC-A06",    "RC-E07",    "RC-E08",    "PRISM-E15",
    "CSPM-P07", "CSPM-T20", "PRISM-P05", "PRISM-P08", "PRISM-T18", "PRISM-E13", "SLEEC-P05", "SLEEC-P07", "CLM-P05"};

std::vector<diagnostics::PageText> pages() {
    std::vector<diagnostics::PageText> result;
    for (const diagnostics::PageText& page : diagnostics::page_texts())
        if (page.code != "README") result.push_back(page);
    return result;
}

/// Returns whether the finding counts. Advice that goes beyond the published rules (RC-W, and RC-K09 and RC-K10 of
/// `conform`) and the note on Instantiations blocks (RC-C07) count only on their own pages.
bool counts(const std::string& finding, std::string_view code) {
    if (code.starts_with("RC-W") || finding.ends_with(" " + std::string(code))) return true;
    return finding.find(" RC-W") == std::string::npos && !finding.ends_with(" RC-K09") &&
           !finding.ends_with(" RC-K10") && !finding.ends_with(" RC-C07");
}

std::multiset<std::string> of_interest(const std::multiset<std::string>& findings, std::string_view code) {
    std::multiset<std::string> result;
    for (const std::string& finding : findings)
        if (counts(finding, code)) result.insert(finding);
    return result;
}

/// Checks all pages in one test, because the program is started for each test and there are hundreds of pages.
template <class Expectation>
void for_each_page(Expectation expectation) {
    for (const diagnostics::PageText& text : pages()) {
        SCOPED_TRACE("docs/rules/" + std::string(text.code) + ".md");
        const diagnostics::RulePage page = diagnostics::read_page(text.text);
        EXPECT_EQ(page.code, text.code) << "the title names the rule of the file's name";
        expectation(page);
    }
}

void expect_form(const diagnostics::RulePage& page) {
    for (const std::string& fault : page.faults) {
        const bool excused = without_example.contains(page.code) && fault.find("no example") != std::string::npos;
        EXPECT_TRUE(excused) << "docs/rules/" << page.code << ".md: " << fault;
    }
    EXPECT_GE(page.reason.size(), 120U) << page.code << " says too little";
    const std::string& title = page.title;
    EXPECT_TRUE(!title.empty() && title.back() != '.') << "a title is a phrase: " << title;
}

TEST(RulePages, HaveTheForm) {
    for_each_page(expect_form);
}

void expect_severities(const diagnostics::RulePage& page) {
    const auto rules = app::find_rules(page.code);
    ASSERT_FALSE(rules.empty()) << "no rule has the code " << page.code;
    using diagnostics::Severity;
    const auto has = [&](Severity s) {
        return std::ranges::any_of(rules, [&](const auto* rule) { return rule->severity == s; });
    };
    for (const auto& [severity, word] : {std::pair(Severity::error, "error"), std::pair(Severity::warning, "warning"),
                                         std::pair(Severity::note, "note")})
        EXPECT_EQ(has(severity), page.severity.find(word) != std::string::npos) << page.code << ": " << page.severity;
}

TEST(RulePages, NameTheSeveritiesOfTheTable) {
    for_each_page(expect_severities);
}

void expect_wrong_example(const diagnostics::RulePage& page) {
    if (without_example.contains(page.code) && page.wrong.empty()) return;  // no example is possible
    const testing::Judgement found = testing::judge(page.wrong);
    const auto findings = of_interest(found.findings, page.code);
    EXPECT_TRUE(found.codes().contains(page.code)) << page.code << " does not occur\n" << found.report;
    if (!found.expected.empty()) {
        EXPECT_EQ(findings, found.expected) << found.report;
        return;
    }
    for (const std::string& finding : findings)
        EXPECT_THAT(finding, ::testing::EndsWith(" " + page.code)) << found.report;
}

TEST(RulePages, WrongExamplesBreakTheRuleAlone) {
    for_each_page(expect_wrong_example);
}

void expect_right_example(const diagnostics::RulePage& page) {
    if (without_example.contains(page.code) && page.right.empty()) return;  // no example is possible
    const testing::Judgement found = testing::judge(page.right);
    EXPECT_EQ(of_interest(found.findings, page.code), found.expected) << found.report;
    EXPECT_FALSE(found.codes().contains(page.code)) << found.report;
}

TEST(RulePages, RightExamplesAreInOrder) {
    for_each_page(expect_right_example);
}

TEST(RulePages, EveryRuleHasOne) {
    std::set<std::string_view> codes;
    for (const diagnostics::Rule* rule : app::all_rules()) codes.insert(rule->code);
    for (const std::string_view code : codes)
        EXPECT_FALSE(diagnostics::page_text(code).empty()) << "docs/rules/" << code << ".md is missing";
}

/// The index contains `* [STM6](STM6.md): title` once, under `## Area`.
TEST(RulePages, IndexListsEachUnderItsArea) {
    std::map<std::string, std::string> area_of_line;
    std::istringstream index{std::string(diagnostics::page_text("README"))};
    std::string area;
    std::string line;
    while (std::getline(index, line)) {
        if (line.starts_with("## ")) area = line.substr(3);
        if (line.starts_with("* [")) {
            EXPECT_TRUE(area_of_line.emplace(line, area).second) << "listed twice: " << line;
        }
    }
    for (const diagnostics::PageText& text : pages()) {
        const diagnostics::RulePage page = diagnostics::read_page(text.text);
        const std::string entry = "* [" + page.code + "](" + page.code + ".md): " + page.title;
        const auto found = area_of_line.find(entry);
        EXPECT_TRUE(found != area_of_line.end()) << "docs/rules/README.md lacks the line\n" << entry;
        if (found == area_of_line.end()) continue;
        EXPECT_EQ(found->second, page.area) << page.code << " stands under another heading than its area";
        area_of_line.erase(found);
    }
    for (const auto& [left, heading] : area_of_line)
        ADD_FAILURE() << "the index names a page that is not there: " << left;
}

TEST(RulePages, LinksLead) {
    for (const diagnostics::PageText& page : diagnostics::page_texts()) {
        const std::string text(page.text);
        for (std::size_t at = text.find("]("); at != std::string::npos; at = text.find("](", at + 1)) {
            const std::string whole = text.substr(at + 2, text.find(')', at) - at - 2);
            const std::string link = whole.substr(0, whole.find('#'));    // tests/sanity checks headings
            if (link.starts_with("http") || link == "CODE.md") continue;  // a pattern in the index
            EXPECT_TRUE(fs::exists(tests::source_folder() / "docs/rules" / link)) << page.code << ": " << link;
        }
    }
}

/// The examples of RoboSim for rows that no page shows give exactly the findings in their comments.
TEST(RulePages, OfRoboSimHaveMoreExamples) {
    for (const auto& example : testing::robosim_examples()) {
        const testing::Judgement found = testing::judge(example);
        EXPECT_EQ(found.findings, found.expected) << found.report;
    }
}

/// Front-end rules have several rows for different circumstances. Each row is shown by a page, a fixture or an example
/// of RoboSim.
TEST(RulePages, ShowEveryRowWithTheFixtures) {
    std::set<const diagnostics::Rule*> shown;
    for (const auto& example : testing::robosim_examples()) shown.merge(testing::judge(example).rules);
    for (const diagnostics::PageText& text : pages()) {
        const testing::Judgement found = testing::judge(diagnostics::read_page(text.text).wrong);
        shown.insert(found.rules.begin(), found.rules.end());
    }
    for (const auto& entry : fs::recursive_directory_iterator(fixtures))
        if (entry.is_regular_file()) {
            const testing::Judgement found = testing::judge_file(entry.path().string());
            shown.insert(found.rules.begin(), found.rules.end());
        }
    for (const diagnostics::Rule* rule : app::all_rules())
        EXPECT_TRUE(shown.contains(rule) || without_example.contains(rule->code))
            << rule->code << ": " << rule->message;
}

}  // namespace
}  // namespace robochart
