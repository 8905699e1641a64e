// SPDX-License-Identifier: Apache-2.0
// Tests that a limit may turn an answer of `check` into "inconclusive", but never into another answer. The test checks
// every model with claims in the repository, and the assertions generated for these models, with few states, little
// memory, and one or several threads.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "app/command/run.hpp"
#include "app/verbs/verbs.hpp"
#include "checker/cspm/session.hpp"
#include "driver/claims/model_claims.hpp"
#include "tests/app/command.hpp"

namespace robochart::app::testing::checked_limits_test {
namespace {

namespace fs = std::filesystem;

using Inputs = std::vector<std::string>;

/// Adds each folder below `folder` as a model.
void add_folders(const std::string& folder, std::vector<Inputs>& all) {
    std::vector<Inputs> found;
    for (const auto& entry : fs::directory_iterator(repository(folder)))
        if (entry.is_directory()) found.push_back({entry.path().string()});
    std::ranges::sort(found);
    all.insert(all.end(), found.begin(), found.end());
}

std::vector<Inputs> models() {
    std::vector<Inputs> all;
    for (const char* name : {"aggregation", "swarm_taxis"})
        all.push_back({repository(std::string("corpus/") + name),
                       repository(fmt::format("corpus/false_claims/{}.assertions", name))});
    add_folders("tests/app/agreeing", all);
    add_folders("tests/conformance/models", all);
    return all;
}

Options options_of(const Inputs& inputs) {
    Options options;
    set_verb(options, Verb::check);
    options.load.inputs = inputs;
    options.claims.core = true;
    options.output.progress = ProgressMode::never;
    options.limits.threads = 1;
    return options;
}

/// A model whose claims are decided repeatedly.
class Model {
public:
    explicit Model(const Inputs& inputs) : options_(options_of(inputs)), run_(options_) {
        options_.run = &run_;
        parts_ = load_parts(options_, run_.budget());
    }

    [[nodiscard]] std::vector<driver::Part>& parts() { return parts_; }
    [[nodiscard]] const Options& options() const { return options_; }
    [[nodiscard]] std::string name() const { return fs::path(options_.load.inputs.front()).filename().string(); }

    /// Returns the report of `check`.
    [[nodiscard]] Report check(std::uint64_t states, unsigned threads) {
        Options options = options_;
        options.limits.max_states = states;
        options.limits.threads = threads;
        Report report;
        for (const driver::Part& part : parts_) check_assertions(*part.project, search_context(options), report);
        return report;
    }

private:
    Options options_;
    Run run_;
    std::vector<driver::Part> parts_;
};

/// Claims that consist of several CSPM assertions. In each claim a different assertion determines the answer.
const char* const machines_of_several = R"(
stm Early { event a event b clock C initial i state A { } state B { }
  transition t0 { from i to A }
  transition t1 { from A to B trigger a condition since(C) > 1 action #C }
  transition t2 { from B to A trigger b } }
stm Late { event a event b clock C initial i state A { } state B { }
  transition t0 { from i to A action #C }
  transition t1 { from A to B trigger a condition since(C) > 1 }
  transition t2 { from B to A trigger b } }
stm Never { event a event b clock C initial i state A { } state B { }
  transition t0 { from i to A }
  transition t1 { from A to B trigger a }
  transition t2 { from B to A trigger b } }
)";
const char* const claims_of_several = R"(
assertion I1 : clock Early::C is initialised
assertion I2 : clock Early::C is not initialised
assertion I3 : clock Late::C is initialised
assertion I4 : clock Late::C is not initialised
assertion I5 : clock Never::C is initialised
assertion I6 : clock Never::C is not initialised
assertion E1 : Early equals Late
assertion E2 : Early is not equal to Late
assertion E3 : Never equals Never
assertion E4 : Never is not equal to Never
)";

/// Counts the answers that were compared, so that a test can require at least one of each kind.
struct Seen {
    std::size_t decided = 0;
    std::size_t inconclusive = 0;
};

void expect_equal_or_inconclusive(const Report& whole, const Report& found, const std::string& limits, Seen& seen) {
    ASSERT_EQ(found.assertions.size(), whole.assertions.size()) << limits;
    for (std::size_t i = 0; i < whole.assertions.size(); ++i) {
        const driver::AssertionReport& expected = whole.assertions[i];
        const driver::AssertionReport& answer = found.assertions[i];
        ASSERT_EQ(answer.title, expected.title) << limits;
        if (answer.answer == driver::Answer::inconclusive) {
            ++seen.inconclusive;
            EXPECT_NE(answer.reason, "") << limits << ": " << answer.title;
            EXPECT_FALSE(answer.run) << limits << ": " << answer.title << " has a counterexample";
            // An answer that needs no exploration is the same under all limits.
            EXPECT_NE(expected.answer, driver::Answer::no_check) << limits << ": " << answer.title;
            continue;
        }
        ++seen.decided;
        EXPECT_EQ(answer.answer, expected.answer) << limits << ": " << answer.title << ": " << answer.reason;
    }
}

void expect_that_limits_only_hide(const Inputs& inputs, Seen& seen) {
    Model model(inputs);
    const Report whole = model.check(model.options().limits.max_states, 1);
    EXPECT_FALSE(whole.assertions.empty()) << model.name();
    for (const driver::AssertionReport& assertion : whole.assertions)
        EXPECT_NE(assertion.answer, driver::Answer::inconclusive)
            << model.name() << ": " << assertion.title << ": " << assertion.reason;
    unsigned threads = 1;
    for (const std::uint64_t states : {1U, 2U, 5U, 20U, 100U, 1000U}) {
        expect_equal_or_inconclusive(whole, model.check(states, threads),
                                     fmt::format("{}, {} states, {} threads", model.name(), states, threads), seen);
        threads = 5 - threads;  // alternates between 1 and 4
    }
}

TEST(CheckedLimits, NeverTurnAnAnswerIntoAnother) {
    Seen seen;
    for (const Inputs& inputs : models()) expect_that_limits_only_hide(inputs, seen);
    EXPECT_GT(seen.decided, 500U);
    EXPECT_GT(seen.inconclusive, 500U);
}

/// A limit may stop one assertion of a claim while the next assertion is decided. A counterexample to the next
/// assertion alone is not a counterexample to the claim.
TEST(CheckedLimits, OfClaimsOfSeveralAssertions) {
    const TemporaryFile model("several.rct", machines_of_several);
    const std::string folder = fs::path(model.path()).parent_path().string();
    std::ofstream(folder + "/several.assertions") << claims_of_several;
    Seen seen;
    expect_that_limits_only_hide({folder}, seen);
    EXPECT_GT(seen.decided, 10U);
    EXPECT_GT(seen.inconclusive, 10U);
}

/// Decides the CSPM assertions of a model, in order.
class Verdicts {
public:
    explicit Verdicts(const csp_emit::Emission& emission) : emission_(emission), session_(emission.script) {}

    /// Returns one word for each verdict. One session decides all assertions, as in `check`, and can be queried again.
    [[nodiscard]] std::vector<std::string> decided(const refine::Limits& limits) {
        std::vector<std::string> words;
        for (const csp_emit::Obligation& obligation : emission_.obligations)
            for (const cspm::DeclPtr& assertion : obligation.assertions) words.push_back(decided(*assertion, limits));
        return words;
    }

private:
    std::string decided(const cspm::Decl& assertion, const refine::Limits& limits) {
        try {
            const refine::Verdict verdict = session_.check(assertion, limits).verdict;
            if (verdict.outcome == refine::Outcome::inconclusive) return "inconclusive";
            return verdict.outcome == refine::Outcome::holds ? "holds" : "fails";
        } catch (const cspm::EvaluationError& error) {
            return std::string("error: ") + error.what();
        }
    }

    const csp_emit::Emission& emission_;
    cspm::Session session_;
};

refine::Limits limits_of(std::uint64_t states, unsigned threads) {
    refine::Limits limits;
    limits.max_states = states;
    limits.threads = threads;
    limits.wide_level = 1;  // the state spaces are small, so every level is divided between the threads
    return limits;
}

/// Returns limits from zero up to the full amount of work.
std::vector<std::pair<std::string, refine::Limits>> all_limits() {
    std::vector<std::pair<std::string, refine::Limits>> all;
    for (const std::uint64_t states : {1U, 2U, 5U, 20U, 100U, 1000U})
        for (const unsigned threads : {1U, 4U})
            all.emplace_back(fmt::format("{} states, {} threads", states, threads), limits_of(states, threads));
    refine::Limits no_memory = limits_of(1'000'000, 1);
    no_memory.memory_bytes = 1U << 20U;
    all.emplace_back("1 MB of memory", no_memory);
    for (const std::uint64_t polls : {2U, 10U}) {
        refine::Limits stopped = limits_of(1'000'000, 1);
        stopped.interrupted = [left = polls]() mutable { return left <= 1 || --left == 0; };
        all.emplace_back(fmt::format("interrupted at look {}", polls), stopped);
    }
    return all;
}

/// Checks the layer below `check`: levels divided between threads, little memory, and interruptions. A session that was
/// stopped by a limit keeps no partial results: without a limit it then gives the complete answers. For each model and
/// time, the test tries every second limit, alternating between the even and the odd ones.
TEST(CheckedLimits, NeverTurnAVerdictIntoAnother) {
    Seen seen;
    std::size_t turn = 0;
    for (const Inputs& inputs : models()) {
        Model model(inputs);
        for (const driver::Part& part : model.parts())
            for (const csp_emit::Time time : {csp_emit::Time::untimed, csp_emit::Time::timed}) {
                const csp_emit::Emission& emission =
                    emit_csp(*part.project, model.options().claims, model.options().swarm, time);
                EXPECT_EQ(&emit_csp(*part.project, model.options().claims, model.options().swarm, time), &emission)
                    << "made once";
                const std::vector<std::string> whole = Verdicts(emission).decided({});
                ++turn;
                for (const auto& [name, limits] : all_limits()) {
                    if (++turn % 2 == 0) continue;
                    Verdicts verdicts(emission);
                    const std::vector<std::string> found = verdicts.decided(limits);
                    ASSERT_EQ(found.size(), whole.size());
                    for (std::size_t i = 0; i < whole.size(); ++i) {
                        ++(found[i] == "inconclusive" ? seen.inconclusive : seen.decided);
                        EXPECT_TRUE(found[i] == whole[i] || found[i] == "inconclusive")
                            << model.name() << ", " << name << ", check " << i << ": " << found[i] << " instead of "
                            << whole[i];
                    }
                    if (limits.threads == 1 && (limits.max_states == 20 || limits.interrupted)) {
                        EXPECT_EQ(verdicts.decided({}), whole) << model.name() << ", after " << name;
                    }
                }
            }
    }
    EXPECT_GT(seen.decided, 500U);
    EXPECT_GT(seen.inconclusive, 500U);
}

}  // namespace
}  // namespace robochart::app::testing::checked_limits_test
