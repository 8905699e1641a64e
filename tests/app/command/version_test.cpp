// SPDX-License-Identifier: Apache-2.0
// Tests the verb `version`, and the commit that it prints.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/base/built_commit.hpp"
#include "app/command/options.hpp"
#include "tests/app/command.hpp"

namespace robochart::app::testing::version_test {
namespace {

using ::testing::ElementsAre;

TEST(Commit, IsShownShortAndWithItsChanges) {
    EXPECT_EQ(commit_text({"0123456789abcdef0123456789abcdef01234567", false}), "commit 0123456789ab");
    EXPECT_EQ(commit_text({"0123456789abcdef0123456789abcdef01234567", true}),
              "commit 0123456789ab with local changes");
    EXPECT_EQ(commit_text({}), "unknown commit");
}

TEST(Version, HasAReportInJson) {
    const auto report = nlohmann::ordered_json::parse(run({"version", "--format", "json"}).out);
    std::vector<std::string> names;
    for (const auto& [name, value] : report.items()) names.push_back(name);
    EXPECT_THAT(names, ElementsAre("schema", "name", "version", "commit", "modified"));
    EXPECT_EQ(report.at("schema"), "robochart-verify/version/1");
    EXPECT_EQ(report.at("version"), program_version);
}

}  // namespace
}  // namespace robochart::app::testing::version_test
