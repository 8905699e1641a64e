// SPDX-License-Identifier: Apache-2.0
// Tests SLEEC-TK's semantics. The process of every rule equals the published process, and all verdicts about pairs
// equal the published verdicts.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <algorithm>

#include <filesystem>
#include <map>
#include <set>
#include <sstream>

#include "checker/cspm/session.hpp"
#include "checker/cspm/syntax/build.hpp"
#include "checker/cspm/syntax/printer.hpp"
#include "checker/cspm/syntax/reader.hpp"
#include "checker/cspm/types/type_check.hpp"
#include "claims/sleec/published/encoding.hpp"
#include "tests/claims/sleec/support.hpp"
#include "tests/contents.hpp"
#include "tests/shared_folder.hpp"

namespace robochart::sleec {
namespace {

namespace fs = std::filesystem;
using testing::Read;

fs::path suite() {
    return tests::shared_folder().empty() ? fs::path() : tests::shared_folder() / "suite/sleec";
}

CheckedRules rules_of(const fs::path& path) {
    Read read(tests::read_contents(path));
    if (!read.checked_too().checked) throw std::runtime_error(read.report());
    return *read.checked;
}

/// Writes the published script of a file, followed by this program's processes for the same rules and by assertions
/// that they are equal. The scripts are in a separate folder with the range of numbers that they need.
std::string unequal_rules(const std::string& name) {
    const fs::path folder = suite() / "FireFighter/robochart";
    const CheckedRules rules = rules_of(folder / (name + ".sleec"));
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    cspm::Script script;
    for (const std::string& file : std::vector<std::string>{"tick-tock.csp", "instantiations.csp", name + ".csp"}) {
        const cspm::Script part = cspm::read_file(sources, (folder / "src-gen" / file).string(), diagnostics);
        script.decls.insert(script.decls.end(), part.decls.begin(), part.decls.end());
    }
    const Encoding encoding(rules, {"", "_ours"});
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < rules.rules.size(); ++i) all.push_back(i);
    for (const cspm::DeclPtr& declaration : encoding.process_declarations(all)) script.decls.push_back(declaration);
    for (const std::size_t rule : all) {
        const auto theirs = cspm::build::name("SLEEC" + rules.name(rule));
        const auto ours = cspm::build::name(encoding.process_name(rule));
        script.decls.push_back(cspm::build::assert_refines(theirs, cspm::Model::failures_divergences, ours));
        script.decls.push_back(cspm::build::assert_refines(ours, cspm::Model::failures_divergences, theirs));
    }
    if (!diagnostics.ok()) return diagnostics::render_text(sources, diagnostics);
    cspm::Session session(script);
    std::string unequal;
    for (const cspm::DeclPtr& assertion : session.assertions()) {
        const cspm::AssertionResult result = session.check(*assertion, {});
        if (result.verdict.outcome != refine::Outcome::holds) unequal += result.text + "\n";
    }
    return unequal;
}

TEST(SleecEncoding, EqualsThePublishedProcesses) {
    if (suite().empty()) GTEST_SKIP() << "the published scripts are not there";
    EXPECT_EQ(unequal_rules("jss_running_example"), "");
    EXPECT_EQ(unequal_rules("firefighter-valid"), "");
}

/// The printed script parses to the tree that is evaluated, and it type checks.
TEST(SleecEncoding, ReadsBackAndHasTypes) {
    Read read(testing::with_definitions(
        "R1 when Go and level > 3 and near then Stop within 2 seconds otherwise Alarm\n"
        "R2 when Halt then not Stop within 3 seconds unless load >= mid unless level < MAX then Stop"));
    ASSERT_TRUE(read.checked_too().checked) << read.report();
    const cspm::Script script = Encoding(*read.checked).make_script({{0, 1}});
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    const std::string text = cspm::print(script);
    const cspm::Script again = cspm::read(sources, sources.add("rules.csp", text), diagnostics);
    EXPECT_TRUE(diagnostics.ok()) << diagnostics::render_text(sources, diagnostics);
    EXPECT_TRUE(cspm::equal(script, again)) << text;
    (void)cspm::check_types(script, diagnostics);
    EXPECT_TRUE(diagnostics.ok()) << diagnostics::render_text(sources, diagnostics) << text;
}

TEST(SleecEncoding, RefusesWhatSleecTkDoesNotRead) {
    for (const std::string rule : {"R when Go then not Stop", "R when Go then Stop within [1, 2] seconds",
                                   "R when Go then Stop unless Halt", "R when Go then Stop otherwise Alarm"}) {
        Read read(testing::with_definitions(rule));
        ASSERT_TRUE(read.checked_too().checked) << read.report();
        EXPECT_THROW((void)Encoding(*read.checked).process_declarations({0}), NotDecided) << rule;
    }
}

/// Returns "fail pass no no" for each pair of verdicts.tsv, by file and rules.
std::map<std::string, std::map<std::pair<std::string, std::string>, std::string>> expected_verdicts() {
    std::map<std::string, std::map<std::pair<std::string, std::string>, std::string>> result;
    std::istringstream table(tests::read_contents(suite() / "verdicts.tsv"));
    std::string line;
    std::getline(table, line);
    while (std::getline(table, line)) {
        std::istringstream cells(line);
        std::vector<std::string> row;
        for (std::string cell; std::getline(cells, cell, '\t');) row.push_back(cell);
        result[row.at(0)][{row.at(1), row.at(2)}] = fmt::format("{} {} {} {}", row[3], row[4], row[5], row[6]);
    }
    return result;
}

std::string verdicts(cspm::Session& session, std::size_t pair) {
    const auto assertions = session.assertions();
    const auto answer = [&](std::size_t i) {
        refine::Limits limits;
        limits.threads = 1;
        const auto outcome = session.check(*assertions[4 * pair + i], limits).verdict.outcome;
        if (outcome == refine::Outcome::inconclusive) return "open";
        const bool holds = outcome == refine::Outcome::holds;
        if (i < 2) return holds ? "pass" : "fail";
        return holds ? "yes" : "no";
    };
    std::string text;
    for (std::size_t i = 0; i < 4; ++i) text += fmt::format("{}{}", i == 0 ? "" : " ", answer(i));
    return text;
}

/// Returns the pairs of a file whose verdicts differ, or that are missing in one of the tables. Two files with the same
/// name have rules with different names.
std::string differences(const fs::path& path, std::map<std::pair<std::string, std::string>, std::string> expected) {
    const CheckedRules rules = rules_of(path);
    std::set<std::string> known;
    for (std::size_t i = 0; i < rules.rules.size(); ++i) known.insert(rules.name(i));
    std::erase_if(expected, [&](const auto& row) { return !known.contains(row.first.first); });
    const Encoding encoding(rules);
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    for (std::size_t i = 0; i < rules.rules.size(); ++i)
        for (std::size_t k = i + 1; k < rules.rules.size(); ++k)
            if (encoding.are_related(i, k)) pairs.emplace_back(i, k);
    std::string text;
    if (pairs.size() != expected.size()) text += fmt::format("{} pairs, not {}\n", pairs.size(), expected.size());
    cspm::Session session(encoding.make_script(pairs));
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const auto name = std::pair(rules.name(pairs[i].first), rules.name(pairs[i].second));
        const auto found = expected.find(name);
        if (found == expected.end()) {
            text += fmt::format("{} with {}: not in the table\n", name.first, name.second);
            continue;
        }
        const std::string made = verdicts(session, i);
        if (made != found->second)
            text += fmt::format("{} with {}: {}, not {}\n", name.first, name.second, made, found->second);
    }
    return text;
}

class SleecVerdicts : public ::testing::TestWithParam<std::string> {};

TEST_P(SleecVerdicts, AreThoseOfSleecTk) {
    if (suite().empty()) GTEST_SKIP() << "the published rules are not there";
    const fs::path path = suite() / GetParam();
    EXPECT_EQ(differences(path, expected_verdicts()[path.filename().string()]), "");
}

INSTANTIATE_TEST_SUITE_P(
    Files, SleecVerdicts,
    ::testing::Values("ALMI-project/ALMI-demo.sleec", "FireFighter/firefighter-valid.sleec",
                      "FireFighter/robochart/firefighter-valid.sleec", "FireFighter/firefighter-initial.sleec",
                      "FireFighter/jss_running_example.sleec", "case-studies/ALMI.sleec", "case-studies/CSICobot.sleec",
                      "case-studies/SafeSCAD.sleec", "runtime/boolean.sleec", "runtime/conflict_error.sleec",
                      "runtime/defeaters.sleec", "runtime/firefighter.sleec", "runtime/not_response.sleec",
                      "runtime/redundant.sleec", "runtime/rel_op.sleec", "runtime/scale.sleec", "small/faults.sleec"),
    [](const auto& file) {
        std::string name = fs::path(file.param).replace_extension().string();
        std::ranges::replace(name, '/', '_');
        std::ranges::replace(name, '-', '_');
        return name;
    });

}  // namespace
}  // namespace robochart::sleec
