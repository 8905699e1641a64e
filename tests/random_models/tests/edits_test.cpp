// SPDX-License-Identifier: Apache-2.0
// Tests random models and random edits of them. With cached answers of earlier runs, all answers must equal those of a
// run without a cache. ROBOCHART_SEEDS=N tries N models with ten edits each.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "base/diagnostics/files.hpp"
#include "checker/cspm/session.hpp"
#include "csp_emit/emit.hpp"
#include "semantics/instantiate/instantiate.hpp"
#include "semantics/lower/lower.hpp"
#include "tests/random_models/changes/shrink.hpp"
#include "tests/random_models/models/well_formed.hpp"
#include "tests/random_models/tests/seeds.hpp"

namespace robochart::random_models {
namespace {

/// The complete answers to a script's assertions, one per line, and the number of answers from the cache.
struct Answers {
    std::vector<std::string> lines;
    std::size_t known = 0;
};

std::string line(const refine::Verdict& verdict, const process::EventTable& events) {
    std::string text = std::to_string(static_cast<int>(verdict.outcome)) + " " + verdict.reason;
    for (const std::uint64_t size : {verdict.statistics.states, verdict.statistics.transitions,
                                     verdict.statistics.depth, verdict.statistics.spec_nodes})
        text += " " + std::to_string(size);
    if (!verdict.counterexample) return text;
    for (const auto* steps : {&verdict.counterexample->steps, &verdict.counterexample->loop})
        for (const refine::Step& step : *steps)
            text += " " + events.name(step.event) + "/" + events.name(step.revealed) + " " + step.state;
    for (const process::EventSet& set : verdict.counterexample->required)
        for (const process::Event event : set) text += " " + events.name(event);
    return text;
}

/// Returns nullopt if the model is rejected.
std::optional<Answers> answers(const Project& project, csp_emit::Time time, diagnostics::Cache* cache) {
    const auto loaded = load(project);
    diagnostics::Diagnostics findings;
    if (!loaded->error_codes().empty()) return std::nullopt;
    const ir::System system = ir::lower(loaded->model, loaded->sources, findings);
    if (!findings.ok()) return std::nullopt;
    const ir::Instantiation instantiation = ir::instantiate_system(system, {}, findings);
    if (!findings.ok()) return std::nullopt;
    const csp_emit::Emission emission = csp_emit::emit(system, instantiation, time, {true}, loaded->sources, findings);
    if (!findings.ok()) return std::nullopt;
    Answers result;
    cspm::Session session(emission.script);
    if (cache != nullptr) session.set_cache(*cache, 0);
    refine::Limits limits;
    limits.max_states = 3000;
    for (const csp_emit::Obligation& obligation : emission.obligations)
        for (const cspm::DeclPtr& assertion : obligation.assertions) {
            std::string text;
            try {
                const refine::Verdict verdict = session.check(*assertion, limits).verdict;
                text = line(verdict, session.event_table());
                result.known += verdict.known ? 1 : 0;
            } catch (const cspm::EvaluationError& error) {
                text = error.what();
            }
            result.lines.push_back(obligation.title + ": " + text);
        }
    return result;
}

/// The number of compared edits, and the number of their answers that were cached.
struct Comparisons {
    std::size_t edits = 0;
    std::size_t answers = 0;
    std::size_t known = 0;
};

void compare(const Project& project, csp_emit::Time time, diagnostics::Cache& cache, Comparisons& tally) {
    const auto expected = answers(project, time, nullptr);
    if (!expected) return;
    const auto found = answers(project, time, &cache);
    ASSERT_TRUE(found);
    ASSERT_EQ(found->lines, expected->lines) << listing(project);
    ++tally.edits;
    tally.answers += found->lines.size();
    tally.known += found->known;
}

TEST(RandomEdits, AnswersAreTheSameWithWhatIsKnown) {
    std::string error;
    const diagnostics::TemporaryFolder folder("", error);
    diagnostics::Cache cache(folder.path() + "/cache", "test", std::uint64_t{256} << 20U);
    Comparisons tally;
    for (const std::uint64_t seed : seeds(3)) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const csp_emit::Time time = seed % 2 == 0 ? csp_emit::Time::untimed : csp_emit::Time::timed;
        const Project whole =
            well_formed(seed, time == csp_emit::Time::timed ? Shape::timed_core() : Shape::untimed_core());
        Random random(seed);
        std::vector<Cut> edits = find_cuts(whole);
        compare(whole, time, cache, tally);
        for (int edit = 0; edit < 10 && !edits.empty() && !HasFatalFailure(); ++edit) {
            const Project edited = apply_cut(whole, random.pick(edits));
            try {
                compare(edited, time, cache, tally);
            } catch (const std::exception& error) {
                FAIL() << error.what() << "\n" << listing(edited);
            }
        }
        if (HasFatalFailure()) return;
    }
    std::printf("%zu edits, %zu answers, %zu known\n", tally.edits, tally.answers, tally.known);
    EXPECT_GT(tally.known, 0U);
    EXPECT_LT(tally.known, tally.answers);
}

}  // namespace
}  // namespace robochart::random_models
