// SPDX-License-Identifier: Apache-2.0
// Tests the evaluator on the published scripts: values whose names start with `test` must be true, and faulty scripts
// must give an error.
#include <gtest/gtest.h>

#include <set>

#include "checker/cspm/session.hpp"
#include "checker/cspm/syntax/build.hpp"
#include "tests/checker/cspm/support.hpp"

namespace robochart::cspm::test {
namespace {

std::vector<std::string> files_expected(const std::filesystem::path& suite, const std::string& verdict) {
    std::vector<std::string> result;
    for (const PublishedScript& script : published_scripts(suite))
        if (script.phase == "evaluator" && script.expectation == verdict) result.push_back(script.file);
    return result;
}

// Returns the top-level names of the script that start with `prefix`.
std::vector<ExprPtr> names_with(const Script& script, const std::string& prefix) {
    std::vector<ExprPtr> result;
    for (const DeclPtr& decl : script.decls) {
        std::string name;
        if (decl->kind == DeclKind::value && decl->patterns[0][0]->kind == PatternKind::name) {
            name = decl->patterns[0][0]->text;
        }
        if (name.starts_with(prefix)) result.push_back(build::name(name));
    }
    return result;
}

// Explores the states of a process up to a bound. This evaluates every prefix and call in these states.
void explore(Session& session, const ExprPtr& process) {
    refine::Limits limits;
    limits.max_states = 20000;
    const auto system = session.system(process);
    (void)refine::deadlock_free(*system, refine::Model::failures, limits);
}

std::string describe(const EvaluationError& error, const diagnostics::SourceManager& sources) {
    return sources.path_and_line(error.span) + ": " + error.what();
}

// Scripts with constructs that are not supported yet. The error must name the construct.
const std::set<std::string> not_yet{
    "evaluator/should_pass/deter_test.csp",        // deter
    "evaluator/should_pass/failure_watchdog.csp",  // failure_watchdog
    "evaluator/should_pass/trace_watchdog.csp",    // trace_watchdog
};

TEST(EvaluatorSuiteTest, PublishedScriptsEvaluateToTrue) {
    const auto shared = shared_folder();
    if (shared.empty()) GTEST_SKIP() << "the folder of shared scripts is absent";
    const auto suite = shared / "suite" / "cspm";
    for (const std::string& file : files_expected(suite, "accept")) {
        diagnostics::SourceManager sources;
        diagnostics::Diagnostics found;
        Script script = read_file(sources, (suite / file).string(), found);
        ASSERT_TRUE(found.ok()) << file;
        bool refused = false;
        try {
            Session session(std::move(script));
            for (const ExprPtr& name : names_with(session.script(), "test")) {
                EXPECT_EQ(session.evaluate(name), "true") << file << " " << name->text;
            }
            for (const ExprPtr& name : names_with(session.script(), "procTest")) explore(session, name);
        } catch (const EvaluationError& error) {
            refused = not_yet.contains(file);
            const std::string message = error.what();
            const bool clear =
                message.find("not supported") != std::string::npos || message.find("infinite") != std::string::npos;
            EXPECT_TRUE(refused && clear) << file << " " << describe(error, sources);
        }
        EXPECT_EQ(refused, not_yet.contains(file)) << file;
    }
}

TEST(EvaluatorSuiteTest, FaultyScriptsGiveAnError) {
    const auto shared = shared_folder();
    if (shared.empty()) GTEST_SKIP() << "the folder of shared scripts is absent";
    const auto suite = shared / "suite" / "cspm";
    for (const std::string& file : files_expected(suite, "reject")) {
        diagnostics::SourceManager sources;
        diagnostics::Diagnostics found;
        Script script = read_file(sources, (suite / file).string(), found);
        ASSERT_TRUE(found.ok()) << file;
        bool refused = false;
        try {
            Session session(std::move(script));
            for (const ExprPtr& name : names_with(session.script(), "test")) (void)session.evaluate(name);
            for (const ExprPtr& name : names_with(session.script(), "procTest")) explore(session, name);
        } catch (const EvaluationError& error) {
            refused = std::string(error.what()) != "";
        }
        EXPECT_TRUE(refused) << file;
    }
}

}  // namespace
}  // namespace robochart::cspm::test
