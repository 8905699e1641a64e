// SPDX-License-Identifier: Apache-2.0
// Tests limits during the stage that computes decision diagrams. The time limit and an interruption of the run end the
// check. The bounds of the stage itself, and a run with little memory, end only the stage, and the search continues.
#include <gtest/gtest.h>

#include "checker/lts/graph.hpp"
#include "checker/machine/supercombinator_system.hpp"
#include "checker/refine/verdict/check.hpp"
#include "checker/symbolic/stage.hpp"
#include "tests/checker/machine/rules_by_hand.hpp"
#include "tests/checker/process/scripted.hpp"
#include "tests/rounds.hpp"

namespace robochart::symbolic {
namespace {

using refine::Outcome;
using Clock = std::chrono::steady_clock;

/// Makes pairs of components that count together. Each pair counts to another number, so no two pairs are equal. The
/// variable order puts the first components of all pairs before the second ones. So the diagrams have a node for each
/// combination of states of the first components.
class StageLimits : public testing::Test {
protected:
    StageLimits() {
        for (std::uint32_t pair = 0; pair < most_pairs; ++pair) {
            const process::Event event = s.event("e" + std::to_string(pair));
            run_graph.add_edge({event, 0});
        }
        run_graph.finish_state();
        options.delay = std::chrono::duration<double>(0);
        options.share = std::chrono::hours(1);
        options.space.bytes = std::size_t{8} << 30U;
        limits.reduction = true;
    }

    machine::SupercombinatorSystem pairs_that_count(std::uint32_t count) {
        machine::Supercombinator made;
        std::vector<machine::Participant> participants;
        std::vector<process::EventSet> alphabets;
        std::vector<machine::DraftRule> drafts;
        for (std::uint32_t slot = 0; slot < 2 * count; ++slot) {
            const process::Event event = process::first_visible + slot / 2;
            const std::uint32_t states = 2 + slot / 2;
            machine::Rows rows;
            for (std::uint32_t state = 0; state < states; ++state) rows.push_back({{event, (state + 1) % states}});
            made.components.push_back(machine::component_of(rows, s.stop()));
            made.initial.push_back(0);
            made.fields.push_back({slot, 0, 0xffU});
            participants.push_back({false, slot});
            alphabets.push_back({event});
            if (slot % 2 == 1) drafts.push_back({event, {{slot - 1, 0}, {slot, 0}}, {}});
        }
        made.words = 2 * count;
        made.regions.push_back(machine::region_of(participants, alphabets, std::move(drafts), {}));
        machine::list_leading(made, diagnostics::unlimited);
        for (std::uint32_t half = 0; half < 2; ++half)
            for (std::uint32_t pair = 0; pair < count; ++pair) options.order.push_back(2 * pair + half);
        return {std::make_shared<const machine::Supercombinator>(std::move(made)), s.store};
    }

    /// Checks whether the system refines the process that can perform every event.
    refine::Verdict decide(machine::SupercombinatorSystem& system) {
        lts::GraphSystem run(run_graph, s.store.events());
        DiagramStage stage(options);
        limits.symbolic = &stage;
        return refine::refines(run, system, refine::Model::traces, limits);
    }

    static constexpr std::uint32_t most_pairs = 30;
    static constexpr std::chrono::seconds soon{10};  // the machine may be busy; the whole work would take hours
    process::Scripted s;
    lts::Graph run_graph;
    StageOptions options;
    refine::Limits limits;
};

TEST_F(StageLimits, WithoutLimitsTheStageDecides) {
    machine::SupercombinatorSystem system = pairs_that_count(5);
    const refine::Verdict verdict = decide(system);
    EXPECT_EQ(verdict.outcome, Outcome::holds);
    EXPECT_EQ(verdict.statistics.decided_by, refine::DecidedBy::diagrams);
}

TEST_F(StageLimits, TheTimeLimitEndsTheCheck) {
    machine::SupercombinatorSystem system = pairs_that_count(most_pairs);
    const auto start = Clock::now();
    limits.deadline = start + std::chrono::milliseconds(300);
    const refine::Verdict verdict = decide(system);
    EXPECT_EQ(verdict.outcome, Outcome::inconclusive);
    EXPECT_TRUE(verdict.reason.starts_with("the time limit was reached")) << verdict.reason;
    EXPECT_LT(Clock::now() - start, soon);
}

TEST_F(StageLimits, AnInterruptionEndsTheCheck) {
    machine::SupercombinatorSystem system = pairs_that_count(most_pairs);
    const auto start = Clock::now();
    limits.interrupted = [&] { return Clock::now() - start > std::chrono::milliseconds(300); };
    const refine::Verdict verdict = decide(system);
    EXPECT_EQ(verdict.outcome, Outcome::inconclusive);
    EXPECT_TRUE(verdict.reason.starts_with("the run was interrupted")) << verdict.reason;
    EXPECT_LT(Clock::now() - start, soon);
}

/// The stage gives up, and then the search ends by its own limit.
TEST_F(StageLimits, TheSearchGoesOnIfTheStageHasNoMoreTime) {
    machine::SupercombinatorSystem system = pairs_that_count(most_pairs);
    options.share = std::chrono::milliseconds(200);
    limits.max_states = 50'000;
    limits.first_of_two = true;
    const auto start = Clock::now();
    const refine::Verdict verdict = decide(system);
    EXPECT_TRUE(verdict.reason.starts_with("the limit of 50000 states was reached")) << verdict.reason;
    EXPECT_LT(Clock::now() - start, soon);
}

TEST_F(StageLimits, TheSearchGoesOnIfDiagramsNeedTooMuchMemory) {
    machine::SupercombinatorSystem system = pairs_that_count(most_pairs);
    limits.max_states = 50'000;
    limits.first_of_two = true;
    for (const std::size_t own : {std::size_t{0}, std::size_t{1} << 22U}) {
        options.space.bytes = own;
        options.space.first_collection = 1U << 20U;
        const auto start = Clock::now();
        const refine::Verdict verdict = decide(system);
        EXPECT_TRUE(verdict.reason.starts_with("the limit of 50000 states was reached")) << verdict.reason;
        EXPECT_LT(Clock::now() - start, soon);
    }
}

/// The stage ends before the run reaches its memory limit. The search alone would not reach this limit.
TEST_F(StageLimits, TheSearchGoesOnIfTheRunHasLittleMemory) {
    if (tests::sanitized) GTEST_SKIP() << "sanitizers need more memory than the limit leaves";
    machine::SupercombinatorSystem system = pairs_that_count(most_pairs);
    limits.max_states = 20'000;
    limits.first_of_two = true;
    limits.memory_bytes = diagnostics::resident_bytes() + (std::uint64_t{48} << 20U);
    const refine::Verdict verdict = decide(system);
    EXPECT_TRUE(verdict.reason.starts_with("the limit of 20000 states was reached")) << verdict.reason;
}

/// If the stage gives up, the search gives the same answer as without the stage. A stage that has given up is not tried
/// again.
TEST_F(StageLimits, AnAttemptWithoutAnswerChangesNothing) {
    machine::SupercombinatorSystem system = pairs_that_count(6);
    const refine::Verdict expected = refine::refines(*std::make_unique<lts::GraphSystem>(run_graph, s.store.events()),
                                                     system, refine::Model::traces, limits);
    options.share = std::chrono::duration<double>(0);
    const refine::Verdict verdict = decide(system);
    EXPECT_EQ(verdict.outcome, Outcome::holds);
    EXPECT_EQ(verdict.statistics.decided_by, refine::DecidedBy::search);
    EXPECT_EQ(verdict.statistics.states, expected.statistics.states);
    EXPECT_EQ(verdict.statistics.spec_nodes, expected.statistics.spec_nodes);
    EXPECT_EQ(verdict.statistics.transitions, expected.statistics.transitions);
}

}  // namespace
}  // namespace robochart::symbolic
