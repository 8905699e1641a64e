// SPDX-License-Identifier: Apache-2.0
// Tests that independent models have the same verdicts in one run as alone, for any number of models. The test uses the
// folders of models next to the repository, if they are present: every third model, or all models with
// ROBOCHART_TOGETHER=all.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/app/command.hpp"
#include "tests/shared_folder.hpp"

namespace robochart::app::testing::together_test {
namespace {

namespace fs = std::filesystem;

/// Each verdict with its place. A run of several models adds a prefix to titles, which the set omits. The set also
/// merges repeated verdicts, because a model that is given alone loads the files next to it that it needs.
using Verdicts = std::set<std::string>;

nlohmann::json report(std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"--format", "json", "--timeout", "120"});
    return nlohmann::json::parse(run(arguments).out, nullptr, false);
}

/// Returns the verdicts by the path and line of the model. Core assertions have no place, so only their titles, which
/// name the component, identify them.
Verdicts verdicts(const nlohmann::json& report) {
    Verdicts result;
    if (!report.is_object() || !report.contains("assertions")) return result;
    for (const auto& assertion : report["assertions"]) {
        std::string title = assertion["title"];
        if (const auto label = title.find(": "); label != std::string::npos && title.find(' ') > label)
            title.erase(0, label + 2);
        result.insert(assertion["place"].get<std::string>() + " " + title + ": " +
                      assertion["answer"].get<std::string>());
    }
    return result;
}

/// Returns every third model, or all if requested.
std::vector<std::string> sample(std::vector<std::string> models) {
    std::ranges::sort(models);
    const char* setting = std::getenv("ROBOCHART_TOGETHER");
    if (setting != nullptr && std::string(setting) == "all") return models;
    std::vector<std::string> some;
    for (std::size_t i = 0; i < models.size(); i += 3) some.push_back(models[i]);
    return some;
}

void expect_the_same(const std::vector<std::string>& models, const std::vector<std::string>& options) {
    Verdicts alone;
    std::vector<std::string> all{"check"};
    for (const std::string& model : models) {
        std::vector<std::string> one{"check", model};
        one.insert(one.end(), options.begin(), options.end());
        alone.merge(verdicts(report(one)));
        all.push_back(model);
    }
    all.insert(all.end(), options.begin(), options.end());
    const Verdicts together = verdicts(report(all));
    std::string differ;
    for (const std::string& answer : alone)
        if (!together.contains(answer)) differ += "only alone: " + answer + "\n";
    for (const std::string& answer : together)
        if (!alone.contains(answer)) differ += "only together: " + answer + "\n";
    EXPECT_EQ(differ, "");
    EXPECT_FALSE(alone.empty());
}

std::vector<std::string> folders_of(const fs::path& folder) {
    std::vector<std::string> result;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.is_directory()) result.push_back(entry.path().string());
    return result;
}

TEST(Together, RoboToolsSuiteIsJudgedAsEachFolderAlone) {
    const fs::path shared = tests::shared_folder();
    if (shared.empty()) GTEST_SKIP() << "no shared/ beside the repository, ROBOCHART_SHARED not set";
    expect_the_same(sample(folders_of(shared / "suite/robotool/accept")), {});
}

TEST(Together, ModelsWithRoboToolsScriptsAreJudgedAsEachAlone) {
    const fs::path shared = tests::shared_folder();
    if (shared.empty()) GTEST_SKIP() << "no shared/ beside the repository, ROBOCHART_SHARED not set";
    std::vector<std::string> models;
    for (const auto& entry : fs::directory_iterator(shared / "suite/robotool-csp/models"))
        if (entry.path().extension() == ".rct") models.push_back(entry.path().string());
    models.push_back((shared / "suite/robotool-csp-2026").string());
    expect_the_same(sample(models), {"--core", "--untimed"});
}

TEST(Together, AdversarialModelsAreJudgedAsEachAlone) {
    const fs::path shared = tests::shared_folder();
    if (shared.empty()) GTEST_SKIP() << "no shared/ beside the repository, ROBOCHART_SHARED not set";
    std::vector<std::string> models;
    for (const std::string& folder : folders_of(shared / "suite/findings/agreeing"))
        if (fs::exists(fs::path(folder) / "m.assertions")) models.push_back(folder);
    expect_the_same(sample(models), {});
}

/// Each model has a module `Mo` with a controller `C`.
TEST(Together, CodeOfModulesOfOneNameIsComparedForEach) {
    const fs::path shared = tests::shared_folder();
    if (shared.empty()) GTEST_SKIP() << "no shared/ beside the repository, ROBOCHART_SHARED not set";
    std::vector<std::string> all{"conform"};
    std::multiset<std::string> alone, together;
    const auto take = [](const nlohmann::json& report, std::multiset<std::string>& outcomes) {
        for (const auto& row : report["conformance"]) outcomes.insert(row["outcome"].get<std::string>());
    };
    for (const char* name : {"m05_async_cycle", "m05b_async_cycle_silent", "m05c_async_overwrite"}) {
        const std::string model = (shared / "suite/findings/agreeing" / name).string();
        take(report({"conform", model}), alone);
        all.push_back(model);
    }
    take(report(all), together);
    EXPECT_EQ(together, alone);
    EXPECT_EQ(together.size(), 3U);
}

}  // namespace
}  // namespace robochart::app::testing::together_test
