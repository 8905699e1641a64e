// SPDX-License-Identifier: Apache-2.0
// Runs further examples of the rules in fixtures/CODE/bad_*.rct and good_*.rct. The first examples are on the pages of
// the rules (docs/rules), which tests/rules runs. A bad fixture must give exactly the findings in its comments (`//
// expect: CODE …` on the line of the finding). A good fixture must give no finding with the code of its folder.
#include "frontend/rules/rules.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <sstream>

#include "frontend/syntax/syntax_rules.hpp"
#include "tests/frontend/fixture.hpp"
#include "tests/source_folder.hpp"

namespace robochart::frontend {
namespace {

namespace fs = std::filesystem;

const fs::path fixtures = tests::source_folder() / "tests/frontend/fixtures";

/// Returns "line CODE" of every expectation, sorted.
std::multiset<std::string> expectations(const std::string& text) {
    std::multiset<std::string> result;
    std::istringstream lines(text);
    std::string line;
    const std::string marker = "// expect: ";
    for (int number = 1; std::getline(lines, line); ++number) {
        const std::size_t at = line.find(marker);
        if (at == std::string::npos) continue;
        std::istringstream codes(line.substr(at + marker.size()));
        for (std::string code; codes >> code;) result.insert(std::to_string(number) + " " + code);
    }
    return result;
}

/// Returns the findings. Advice that goes beyond the published rules (RC-W) is ignored, except in its own folders.
std::multiset<std::string> findings(const testing::Reading& reading, bool advice) {
    std::multiset<std::string> result;
    for (const auto& d : reading.findings.sorted_findings())
        if (advice || !d.rule->code.starts_with("RC-W"))
            result.insert(std::to_string(reading.sources.position(d.span.source, d.span.begin).line) + " " +
                          std::string(d.rule->code));
    return result;
}

std::vector<const diagnostics::Rule*> all_rules() {
    std::vector<const diagnostics::Rule*> result(std::begin(rules::all), std::end(rules::all));
    result.insert(result.end(), std::begin(syntax::rule_list), std::end(syntax::rule_list));
    return result;
}

std::vector<fs::path> files_of(const fs::path& folder) {
    std::vector<fs::path> result;
    for (const auto& entry : fs::directory_iterator(folder)) result.push_back(entry.path());
    std::ranges::sort(result);
    return result;
}

class Fixture : public ::testing::TestWithParam<std::string> {};

TEST_P(Fixture, IsJudgedAsItSays) {
    const std::string& code = GetParam();
    for (const fs::path& path : files_of(fixtures / code)) {
        const std::string text = testing::read_contents(path);
        const auto reading = testing::resolved(text, path.extension() == ".assertions");
        const auto expected = expectations(text);
        EXPECT_EQ(findings(*reading, code.starts_with("RC-W")), expected) << path << "\n" << reading->report();
        const bool names_it =
            std::ranges::any_of(expected, [&](const std::string& e) { return e.substr(e.find(' ') + 1) == code; });
        EXPECT_EQ(names_it, path.filename().string().starts_with("bad")) << path;
    }
}

std::vector<std::string> folders() {
    std::vector<std::string> result;
    for (const fs::path& path : files_of(fixtures)) result.push_back(path.filename().string());
    return result;
}

std::string as_identifier(const ::testing::TestParamInfo<std::string>& folder) {
    std::string name = folder.param;
    std::ranges::replace(name, '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Rules, Fixture, ::testing::ValuesIn(folders()), as_identifier);

TEST(Rules, HaveMessagesAndOneMeaningPerRow) {
    std::set<std::pair<std::string_view, std::string_view>> seen;
    for (const auto* rule : all_rules()) {
        EXPECT_FALSE(rule->code.empty() || rule->message.empty()) << rule->code;
        EXPECT_TRUE(seen.emplace(rule->code, rule->message).second) << rule->code;
    }
}

}  // namespace
}  // namespace robochart::frontend
