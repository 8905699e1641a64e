// SPDX-License-Identifier: Apache-2.0
// Checks the types of published scripts: the type checker accepts what FDR's front end accepts, and rejects what it
// rejects. It accepts all of RoboTool's own scripts, the largest in about a second.
#include <gtest/gtest.h>

#include <set>

#include "checker/cspm/types/type_check.hpp"
#include "tests/checker/cspm/support.hpp"
#include "tests/rounds.hpp"

namespace robochart::cspm::test {
namespace {

struct Checked {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;

    explicit Checked(const std::filesystem::path& file) {
        const Script script = read_file(sources, file.string(), diagnostics);
        if (diagnostics.ok()) check_types(script, diagnostics);
    }
    [[nodiscard]] std::string report() const { return diagnostics::render_text(sources, diagnostics); }
};

// Returns true for scripts of the printer's phase that were never meant to type check. FDR's front end rejects them
// too.
bool only_printed(const std::string& file) {
    return file.ends_with("should_pass/complete.csp") || file == "prettyprinter/should_pass/timed_sections.csp";
}

TEST(TypeSuiteTest, PublishedScriptsAreTypedAsFdrTypesThem) {
    const auto shared = shared_folder();
    if (shared.empty()) GTEST_SKIP() << "the folder of shared scripts is absent";
    const auto folder = shared / "suite" / "cspm";
    int seen = 0;
    for (const auto& [phase, expectation, file] : published_scripts(folder)) {
        // Scripts of the parser's phase may fail in later phases. Scripts that belong to later phases must pass the
        // earlier phases.
        if (phase == "parser" || only_printed(file)) continue;
        ++seen;
        const Checked checked(folder / file);
        // Our type checker reports errors that FDR finds after typing, in its desugarer.
        const bool ours = phase == "typechecker" || phase == "desugar";
        const bool accepted = !ours || expectation == "accept";
        EXPECT_EQ(checked.diagnostics.ok(), accepted) << file << "\n" << checked.report();
    }
    EXPECT_GT(seen, 150);
}

void expect_all_typed(const std::filesystem::path& folder) {
    std::set<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        // instantiations.csp is a fragment that the other files include.
        if (entry.path().extension() == ".csp" && entry.path().filename() != "instantiations.csp")
            files.insert(entry.path());
    EXPECT_FALSE(files.empty()) << folder;
    std::size_t place = 0;
    for (const std::filesystem::path& file : files) {
        if (place++ % tests::distance_of_places(1) != 0) continue;
        const Checked checked(file);
        EXPECT_TRUE(checked.diagnostics.ok()) << file << "\n" << checked.report();
    }
}

TEST(TypeSuiteTest, RoboToolScriptsAreTyped) {
    const auto shared = shared_folder();
    if (shared.empty()) GTEST_SKIP() << "the folder of shared scripts is absent";
    for (const char* folder :
         {"suite/robotool-csp/timed", "suite/robotool-csp/untimed", "suite/robotool-csp-2026/timed",
          "suite/robotool-csp-2026/untimed", "bench/hvc/robotool-csp", "bench/models"}) {
        expect_all_typed(shared / folder);
    }
}

}  // namespace
}  // namespace robochart::cspm::test
