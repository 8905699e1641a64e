// SPDX-License-Identifier: Apache-2.0
// Tests the public models next to the repository. Valid models load without an error, and invalid models are rejected
// for the right reason. The test is skipped if the material is absent.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "fixture.hpp"
#include "tests/rounds.hpp"
#include "tests/source_folder.hpp"

namespace robochart::frontend {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> entries(const fs::path& folder) {
    std::vector<fs::path> result;
    for (const auto& entry : fs::directory_iterator(folder)) result.push_back(entry.path());
    std::ranges::sort(result);
    return result;
}

/// Loads a project and passes it to `judge`.
template <class Judge>
void load(const fs::path& path, Judge judge) {
    testing::Reading reading;
    const auto model = load_project(reading.sources, path.string(), reading.findings);
    judge(reading, *model);
}

void expect_loads(const fs::path& path) {
    load(path, [&](const testing::Reading& reading, const Model& model) {
        EXPECT_TRUE(reading.findings.ok()) << path << "\n" << reading.report();
        EXPECT_FALSE(model.files.empty());
        const std::string once = dump_model(model, reading.sources, true);
        EXPECT_EQ(once.find("-> nothing"), std::string::npos) << path << " leaves a name without a target\n" << once;
        load(path, [&](const testing::Reading& again, const Model& same) {
            EXPECT_EQ(dump_model(same, again.sources, true), once) << path;
        });
    });
}

#define NEED_SHARED(folder)                           \
    const fs::path folder = testing::shared_folder(); \
    if (folder.empty()) GTEST_SKIP() << "no shared/ beside the repository, ROBOCHART_SHARED not set"

TEST(Suite, AcceptsWhatRoboToolAccepts) {
    NEED_SHARED(shared);
    for (const fs::path& folder : entries(shared / "suite/robotool/accept")) expect_loads(folder);
}

TEST(Suite, LoadsTheBenchmarkModels) {
    NEED_SHARED(shared);
    expect_loads(shared / "bench/hvc");
    expect_loads(shared / "suite/robotool-csp-2026");
    for (const fs::path& path : entries(shared / "suite/robotool-csp/models"))
        if (path.extension() == ".rct" && fs::file_size(path) > 1) expect_loads(path);
}

/// The reasons of EXPECTED.tsv as codes of this program: an operation that is not required, a connection in the wrong
/// direction for a machine (twice), transitions across the border of a state (two ends).
TEST(Suite, RefusesWhatRoboToolRefuses) {
    NEED_SHARED(shared);
    const std::map<std::string, std::vector<std::string>> reasons = {{"opcall-scope-fail", {"RC-N01"}},
                                                                     {"operationInput", {"Cn8"}},
                                                                     {"operationOutputOpRef", {"Cn9"}},
                                                                     {"transitionsOutsideNodeContainer", {"T1", "T1"}}};
    for (const fs::path& folder : entries(shared / "suite/robotool/reject")) {
        const auto reason = reasons.find(folder.filename().string());
        ASSERT_NE(reason, reasons.end()) << folder;
        load(folder, [&](const testing::Reading& reading, const Model&) {
            std::vector<std::string> codes;
            for (const auto& d : reading.findings.sorted_findings()) codes.emplace_back(d.rule->code);
            EXPECT_EQ(codes, reason->second) << reading.report();
        });
    }
}

TEST(Suite, LoadsTheCorpus) {
    const fs::path corpus = tests::source_folder() / "corpus";
    if (!fs::is_directory(corpus)) GTEST_SKIP() << "no corpus in this tree";
    for (const fs::path& folder : entries(corpus)) {
        const auto files = fs::is_directory(folder) ? entries(folder) : std::vector<fs::path>();
        if (std::ranges::any_of(files, [](const fs::path& f) { return f.extension() == ".rct"; })) expect_loads(folder);
    }
}

/// A model that is truncated anywhere gives diagnostics or a model, but never a crash. Two parses give the same result.
TEST(Suite, SurvivesTruncationAnywhere) {
    NEED_SHARED(shared);
    std::size_t cuts = 0;
    for (const auto& entry : fs::recursive_directory_iterator(shared / "suite/robotool/accept")) {
        const bool is_assertions = entry.path().extension() == ".assertions";
        if (!is_assertions && entry.path().extension() != ".rct") continue;
        const std::string text = testing::read_contents(entry.path());
        for (std::size_t length = 0; length < text.size(); length += tests::distance_of_places(97), ++cuts) {
            const auto reading = testing::resolved(text.substr(0, length), is_assertions);
            EXPECT_LE(reading->findings.error_count(), 200U) << entry.path() << " cut at " << length;
            EXPECT_EQ(reading->dumped(true), testing::resolved(text.substr(0, length), is_assertions)->dumped(true));
        }
    }
    EXPECT_GT(cuts, 100U);
}

/// A model from which a piece in the middle is removed gives diagnostics or a model, but never a crash.
TEST(Suite, SurvivesHoles) {
    NEED_SHARED(shared);
    for (const auto& entry : fs::recursive_directory_iterator(shared / "suite/robotool/accept")) {
        const bool is_assertions = entry.path().extension() == ".assertions";
        if (!is_assertions && entry.path().extension() != ".rct") continue;
        const std::string text = testing::read_contents(entry.path());
        for (std::size_t hole = 0; hole < text.size(); hole += tests::distance_of_places(131))
            static_cast<void>(testing::resolved(std::string(text).erase(hole, 17), is_assertions));
    }
}

}  // namespace
}  // namespace robochart::frontend
