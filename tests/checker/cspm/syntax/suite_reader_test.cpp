// SPDX-License-Identifier: Apache-2.0
// Reads scripts that FDR's front end accepts or rejects, and RoboTool's own scripts. Accepted scripts must parse,
// print, and parse to the same tree.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/checker/cspm/support.hpp"
#include "tests/rounds.hpp"

namespace robochart::cspm::test {
namespace {

void expect_round_trip(const Script& script, const std::string& what) {
    const std::string text = print(script);
    const Reading again(text);
    ASSERT_TRUE(again.ok()) << what << "\n" << again.report();
    EXPECT_TRUE(equal(again.script, script)) << what;
    EXPECT_EQ(print(again.script), text) << what;
}

std::vector<std::filesystem::path> scripts_below(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> result;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (entry.path().extension() == ".csp") result.push_back(entry.path());
    }
    std::ranges::sort(result);
    return result;
}

void expect_all_read(const std::filesystem::path& folder) {
    const auto files = scripts_below(folder);
    ASSERT_FALSE(files.empty()) << folder;
    for (std::size_t i = 0; i < files.size(); i += tests::distance_of_places(1)) {
        const std::filesystem::path& file = files[i];
        diagnostics::SourceManager sources;
        diagnostics::Diagnostics found;
        std::string cause;
        const auto source = sources.load_file(file.string(), cause);
        ASSERT_TRUE(source) << cause;
        const Script script = read(sources, *source, found);
        EXPECT_TRUE(found.ok()) << diagnostics::render_text(sources, found);
        if (found.ok()) expect_round_trip(script, file.string());
    }
}

TEST(SuiteReaderTest, RoboToolScriptsReadAndRoundTrip) {
    const auto shared = shared_folder();
    if (shared.empty()) GTEST_SKIP() << "the folder of shared scripts is absent";
    expect_all_read(shared / "suite" / "robotool-csp");
    expect_all_read(shared / "suite" / "robotool-csp-2026");
    expect_all_read(shared / "bench" / "hvc" / "robotool-csp");
    expect_all_read(shared / "bench" / "models");
}

TEST(SuiteReaderTest, FrontEndVerdictsOfThePublishedScripts) {
    const auto shared = shared_folder();
    if (shared.empty()) GTEST_SKIP() << "the folder of shared scripts is absent";
    const auto folder = shared / "suite" / "cspm";
    int seen = 0;
    for (const auto& [phase, expectation, file] : published_scripts(folder)) {
        // Scripts for later phases must parse too, so only scripts of the parser's phase may be rejected here.
        if (phase != "parser" && expectation == "reject") continue;
        ++seen;
        diagnostics::SourceManager sources;
        diagnostics::Diagnostics found;
        const Script script = read_file(sources, (folder / file).string(), found);
        EXPECT_EQ(found.ok(), expectation == "accept") << file << "\n" << diagnostics::render_text(sources, found);
        if (found.ok()) expect_round_trip(script, file);
    }
    EXPECT_GT(seen, 100);
}

}  // namespace
}  // namespace robochart::cspm::test
