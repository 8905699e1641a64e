// SPDX-License-Identifier: Apache-2.0
// Compares diagnoses with those of LEGOS for its initial sets (shared/suite/sleec, legos-issues.tsv). With `now` for
// responses without a limit, both report the same rules, concerns and purposes. Comments at the comparisons explain
// where LEGOS counts differently.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>

#include "claims/sleec/analysis/conflicts.hpp"
#include "claims/sleec/analysis/properties.hpp"
#include "tests/claims/sleec/support.hpp"
#include "tests/contents.hpp"
#include "tests/shared_folder.hpp"

namespace robochart::sleec {
namespace {

namespace fs = std::filesystem;

/// A row of the table, which counts redundancies, situational conflicts, concerns raised, and purposes blocked.
using Counts = std::vector<std::size_t>;

std::map<std::string, Counts> recorded(const fs::path& table) {
    std::map<std::string, Counts> result;
    std::istringstream lines(tests::read_contents(table));
    std::string line;
    std::getline(lines, line);
    while (std::getline(lines, line)) {
        std::istringstream cells(line);
        std::string set, cell;
        std::getline(cells, set, '\t');
        for (int i = 0; i < 4 && std::getline(cells, cell, '\t'); ++i) result[set].push_back(std::stoul(cell));
    }
    return result;
}

/// This program's diagnosis of a set.
struct Diagnosed {
    std::set<std::string> superfluous;  ///< redundant rules, and rules without a requirement
    std::set<std::string> conflicts;    ///< "R1 R2", or "R1" for a rule with itself
    std::set<std::string> raised, blocked;
};

Diagnosed diagnosed(const CheckedRules& rules) {
    const AnalysisOptions options{WithoutLimit::now, {}, nullptr};
    Diagnosed result;
    for_each_question(rules, options, [&](const ConflictAnswer& answer) {
        EXPECT_NE(answer.conflict, Answer::not_decided) << answer.reason;
        if (answer.conflict != Answer::yes) return;
        std::string names;
        for (const std::size_t rule : answer.rules) names += (names.empty() ? "" : " ") + rules.name(rule);
        result.conflicts.insert(names);
    });
    for (std::size_t i = 0; i < rules.rules.size(); ++i) {
        bool superfluous = makes_no_demand(rules, i, options);
        for (std::size_t k = 0; k < rules.rules.size() && !superfluous; ++k)
            superfluous = i != k && is_redundant(rules, i, k, options);
        if (superfluous) result.superfluous.insert(rules.name(i));
    }
    for (const CheckedProperty& concern : rules.concerns)
        if (check_possible(rules, concern, options).possible != Answer::no)
            result.raised.insert(concern.written->name.text);
    for (const CheckedProperty& purpose : rules.purposes)
        if (check_possible(rules, purpose, options).possible != Answer::yes)
            result.blocked.insert(purpose.written->name.text);
    return result;
}

using Names = std::set<std::string>;

TEST(SleecDiagnoses, AreThoseOfLegos) {
    const fs::path suite = tests::shared_folder() / "suite/sleec";
    if (tests::shared_folder().empty() || !fs::exists(suite)) GTEST_SKIP() << "the published files are not there";
    const auto table = recorded(suite / "legos-issues.tsv");
    const std::map<std::string, std::string> files{
        {"ALMI", "ALMI"}, {"CSICobot", "CSI"}, {"DAISY", "Daisy"}, {"SafeSCAD", "safescade"}};
    const std::map<std::string, Names> superfluous{
        {"ALMI", {}}, {"CSICobot", {"R4", "R4b", "R14"}}, {"DAISY", {"Rule16"}}, {"SafeSCAD", {"R1_1", "R2", "R2_1"}}};
    // LEGOS counts the rules whose conflict other rules cause. For DAISY these are both rules of the pair. For SafeSCAD
    // they are all rules that take part except R7, which LEGOS names as the cause for R3_1. For ALMI it is R3 once.
    // This program also finds the conflict of R3 with itself.
    const std::map<std::string, Names> conflicts{{"ALMI", {"R3", "R3 R21"}},
                                                 {"CSICobot", {}},
                                                 {"DAISY", {"Rule18 Rule19"}},
                                                 {"SafeSCAD",
                                                  {"R1_2 R4", "R3 R4", "R3_1 R7", "R7 R12_1", "R4 R9", "R4 R10",
                                                   "R4 R11_1", "R4 R16", "R3_1 R17", "R12_1 R17"}}};
    for (const auto& [set, counts] : table) {
        SCOPED_TRACE(set);
        testing::Read read(tests::read_contents(suite / "legos" / (files.at(set) + ".sleec")));
        ASSERT_TRUE(read.checked_too().checked) << read.report();
        const Diagnosed found = diagnosed(*read.checked);
        EXPECT_EQ(found.superfluous, superfluous.at(set));
        EXPECT_EQ(found.superfluous.size(), counts[0]);
        EXPECT_EQ(found.conflicts, conflicts.at(set));
        EXPECT_EQ(found.raised.size(), counts[2]);
        EXPECT_EQ(found.blocked.size(), counts[3]);
    }
}

}  // namespace
}  // namespace robochart::sleec
