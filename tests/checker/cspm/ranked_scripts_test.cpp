// SPDX-License-Identifier: Apache-2.0
// Decides the assertions of whole scripts by ranks, by programs with two ranks each, and on disk. Answers and lengths
// of counterexamples must be those of the ordinary search, and so must the figures if the assertion holds. The
// counterexample must be the same for every number and distribution of ranks, in memory and on disk.
// ROBOCHART_RANKED_SCRIPTS names a folder whose scripts, including those in subfolders, are compared too.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>

#include "checker/cspm/session.hpp"
#include "checker/cspm/syntax/reader.hpp"
#include "checker/refine/verdict/level_strategy.hpp"
#include "tests/checker/cspm/support.hpp"
#include "tests/checker/processes/on_disk.hpp"
#include "tests/checker/processes/thread_programs.hpp"
#include "tests/checker/processes/verdict_text.hpp"
#include "tests/source_folder.hpp"

namespace robochart::cspm::test {
namespace {

using refine::complete_text;
using refine::Outcome;
using refine::Verdict;

/// Returns the text that all searches must share. It contains the figures only if all states are visited. A negated
/// assertion may hold because of a counterexample.
std::string in_common(const Verdict& verdict) {
    std::string text = std::to_string(static_cast<int>(verdict.outcome)) + verdict.reason;
    if (verdict.outcome == Outcome::holds && !verdict.counterexample)
        text += " " + std::to_string(verdict.statistics.states) + " " + std::to_string(verdict.statistics.transitions);
    if (!verdict.counterexample) return text;
    return text + " kind " + std::to_string(static_cast<int>(verdict.counterexample->kind)) + " after " +
           std::to_string(verdict.counterexample->steps.size());
}

/// Returns the answer, or the evaluation error.
std::string answer(Session& session, const Decl& assertion, const refine::Limits& limits,
                   std::string (*shown)(const Verdict&)) {
    try {
        return shown(session.check(assertion, limits).verdict);
    } catch (const EvaluationError& error) {
        return error.what();
    }
}

/// Returns the number of assertions that were compared.
std::size_t compare(const std::filesystem::path& file) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics found;
    const Script script = read_file(sources, file.string(), found);
    if (!found.ok()) return 0;
    Session session(script);
    const auto assertions = session.assertions();
    for (const DeclPtr& assertion : assertions)
        for (const bool reduction : {false, true}) {
            refine::Limits limits;
            limits.reduction = reduction;
            limits.max_states = 200'000;
            const std::string ordinary = answer(session, *assertion, limits, in_common);
            if (ordinary.find("the limit of") != std::string::npos) continue;
            std::string first;
            for (const unsigned ranks : {1U, 2U, 3U, 4U, 8U}) {
                refine::ThreadRanks strategy(ranks);
                limits.by_levels = &strategy;
                const std::string mine = answer(session, *assertion, limits, complete_text);
                if (ranks == 1) {
                    first = mine;
                    EXPECT_EQ(answer(session, *assertion, limits, in_common), ordinary)
                        << file << ": " << print(*assertion);
                }
                EXPECT_EQ(mine, first) << file << ": " << print(*assertion) << ", ranks " << ranks;
            }
            refine::ThreadPrograms by_programs(reduction ? 3 : 2, 2);
            limits.by_levels = &by_programs;
            EXPECT_EQ(answer(session, *assertion, limits, complete_text), first)
                << file << ": " << print(*assertion) << ", by programs of two threads";
            refine::OnDisk on_disk(reduction ? 2 : 1);
            limits.by_levels = &on_disk;
            EXPECT_EQ(answer(session, *assertion, limits, complete_text), first)
                << file << ": " << print(*assertion) << ", on disk";
        }
    return assertions.size();
}

std::size_t compare_folder(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        if (entry.path().extension() == ".csp") files.push_back(entry.path());
    std::ranges::sort(files);
    std::size_t compared = 0;
    for (const std::filesystem::path& file : files) try {
            compared += compare(file);
        } catch (const EvaluationError& error) {
            std::cout << file.string() << " has no assertions to compare: " << error.what() << "\n";
        }
    return compared;
}

TEST(RankedScripts, AreDecidedAsByTheOrdinarySearch) {
    EXPECT_EQ(compare_folder(tests::source_folder() / "tests" / "app" / "mpi" / "scripts"), 32U);
}

TEST(RankedScripts, OfAFolderAreDecidedAsByTheOrdinarySearch) {
    const char* const folder = std::getenv("ROBOCHART_RANKED_SCRIPTS");
    if (folder == nullptr) GTEST_SKIP() << "ROBOCHART_RANKED_SCRIPTS names no folder";
    const std::size_t compared = compare_folder(folder);
    std::cout << compared << " assertions compared\n";
    EXPECT_GT(compared, 0U);
}

}  // namespace
}  // namespace robochart::cspm::test
