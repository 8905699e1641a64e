// SPDX-License-Identifier: Apache-2.0
// Tests verdicts that follow from the models' definitions by hand, and the contents of counterexamples.
#include "checker/refine/verdict/check.hpp"
#include "checker/process/bisimulation_compressor.hpp"
#include "checker/process/term_system.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/checker/process/scripted.hpp"
#include "tests/rounds.hpp"

namespace robochart::refine {
namespace {

using process::Compression;
using process::Event;
using process::Op;
using process::Scripted;
using process::TermId;
using testing::ElementsAre;
using testing::HasSubstr;

class Checks : public testing::Test {
protected:
    Scripted s;
    process::OperationalSemantics semantics{s.store};
    Limits limits;
    TermId stop = s.stop();
    TermId skip = s.skip();
    TermId div = s.op(Op::div);
    TermId a = s.prefix("a", stop);
    TermId b = s.prefix("b", stop);

    process::TermSystem system(TermId term) { return {semantics, term}; }
    TermId either(TermId l, TermId r) { return s.op(Op::internal_choice, {l, r}); }
    TermId choice(TermId l, TermId r) { return s.op(Op::external_choice, {l, r}); }
    Verdict check(TermId specification, TermId implementation, Model model) {
        process::TermSystem left = system(specification);
        process::TermSystem right = system(implementation);
        return refines(left, right, model, limits);
    }
    bool holds(TermId specification, TermId implementation, Model model) {
        const Verdict verdict = check(specification, implementation, model);
        EXPECT_NE(verdict.outcome, Outcome::inconclusive) << verdict.reason;
        return verdict.outcome == Outcome::holds;
    }
    std::vector<std::string> names(const std::vector<Step>& steps) {
        std::vector<std::string> list;
        for (const Step& step : steps) list.push_back(s.events.name(step.event));
        return list;
    }
};

constexpr Model T = Model::traces;
constexpr Model F = Model::failures;
constexpr Model FD = Model::failures_divergences;

TEST_F(Checks, TheModelsDifferWhereTheyShould) {
    const TermId a_or_b = choice(a, b);
    EXPECT_TRUE(holds(a_or_b, either(a, b), T));
    EXPECT_FALSE(holds(a_or_b, either(a, b), F));  // it may refuse a
    EXPECT_TRUE(holds(either(a, b), a_or_b, FD));
    EXPECT_TRUE(holds(a_or_b, stop, T));
    EXPECT_FALSE(holds(a_or_b, stop, F));
    EXPECT_TRUE(holds(stop, div, F));  // only stable refusals count in F
    EXPECT_FALSE(holds(stop, div, FD));
    EXPECT_TRUE(holds(div, a_or_b, FD));  // everything refines divergence
    EXPECT_FALSE(holds(div, a_or_b, F));
    EXPECT_FALSE(holds(div, stop, F));  // a stable refusal that DIV does not have
}

TEST_F(Checks, NothingBelowADivergenceOfTheSpecificationMatters) {
    const TermId specification = s.prefix("a", div);
    EXPECT_TRUE(holds(specification, s.prefix("a", b), FD));
    EXPECT_FALSE(holds(specification, s.prefix("b", b), FD));
    EXPECT_FALSE(holds(specification, s.prefix("a", b), T));
    // After a, the specification may diverge or stop. In FD it then allows everything.
    EXPECT_TRUE(holds(s.prefix("a", either(stop, div)), s.prefix("a", b), FD));
}

TEST_F(Checks, TerminationIsAutonomous) {
    EXPECT_TRUE(holds(either(skip, stop), skip, FD));
    EXPECT_FALSE(holds(skip, stop, F));
    EXPECT_FALSE(holds(stop, skip, T));             // ✓ is an event of traces
    EXPECT_TRUE(holds(choice(a, skip), skip, FD));  // P [] SKIP may terminate without its environment, refusing a
    EXPECT_TRUE(holds(choice(a, skip), s.op(Op::sliding, {a, skip}), FD));  // UCS: P [] SKIP = P [> SKIP
    EXPECT_TRUE(holds(s.op(Op::sliding, {a, skip}), choice(a, skip), FD));
    EXPECT_FALSE(holds(choice(a, skip), either(a, skip), F));  // offering only a refuses tick
}

TEST_F(Checks, ATraceViolationNamesTheEventAndWhatWasAllowed) {
    const Verdict verdict = check(s.prefix("a", choice(a, b)), s.prefix("a", choice(a, s.prefix("c", stop))), T);
    ASSERT_EQ(verdict.outcome, Outcome::fails);
    const Counterexample& reported = *verdict.counterexample;
    EXPECT_EQ(reported.kind, ViolationKind::trace);
    EXPECT_THAT(names(reported.steps), ElementsAre("a", "c"));
    EXPECT_EQ(reported.event, s.event("c"));
    EXPECT_THAT(reported.required, ElementsAre(process::EventSet{s.event("a"), s.event("b")}));
    EXPECT_EQ(reported.steps.back().state, "STOP");
}

TEST_F(Checks, ARefusalShowsTheOfferAndTheMinimalAcceptances) {
    const TermId c = s.prefix("c", stop);
    const TermId specification = either(choice(a, b), either(c, choice(c, a)));
    const Verdict verdict = check(specification, a, F);
    ASSERT_EQ(verdict.outcome, Outcome::fails);
    const Counterexample& reported = *verdict.counterexample;
    EXPECT_EQ(reported.kind, ViolationKind::refusal);
    EXPECT_TRUE(reported.steps.empty());
    EXPECT_THAT(reported.offered, ElementsAre(s.event("a")));
    EXPECT_THAT(reported.required,
                ElementsAre(process::EventSet{s.event("c")}, process::EventSet{s.event("a"), s.event("b")}));
}

TEST_F(Checks, ADivergenceIsReportedWithItsLoopAndWhatWasHidden) {
    const TermId p = s.name("P");
    s.bind(p, s.menu({{"a", s.prefix("h", p)}, {"h", p}}));
    const Verdict verdict = check(s.over(Op::run, {}, {"a"}), s.over(Op::hide, {p}, {"h"}), FD);
    ASSERT_EQ(verdict.outcome, Outcome::fails);
    const Counterexample& reported = *verdict.counterexample;
    EXPECT_EQ(reported.kind, ViolationKind::divergence);
    EXPECT_TRUE(reported.steps.empty());
    EXPECT_EQ(reported.initial, "P");
    ASSERT_EQ(reported.loop.size(), 1U);
    EXPECT_EQ(reported.loop[0].event, process::tau);
    EXPECT_EQ(reported.loop[0].revealed, s.event("h"));
}

TEST_F(Checks, DeadlockCountsTerminationAndDivergenceByModel) {
    process::TermSystem ended = system(s.prefix("a", skip));
    const Verdict verdict = deadlock_free(ended, F, limits);
    ASSERT_EQ(verdict.outcome, Outcome::fails);
    EXPECT_THAT(names(verdict.counterexample->steps), ElementsAre("a", "✓"));
    process::TermSystem diverging = system(s.prefix("a", div));
    EXPECT_EQ(deadlock_free(diverging, F, limits).outcome, Outcome::holds);
    const Verdict strict = deadlock_free(diverging, FD, limits);
    ASSERT_EQ(strict.outcome, Outcome::fails);
    EXPECT_EQ(strict.counterexample->kind, ViolationKind::divergence);
    EXPECT_EQ(divergence_free(diverging, limits).outcome, Outcome::fails);
    EXPECT_EQ(divergence_free(ended, limits).outcome, Outcome::holds);
}

TEST_F(Checks, NondeterminismNamesAnEventThatIsBothAcceptedAndRefused) {
    process::TermSystem ambiguous = system(s.prefix("b", choice(a, s.prefix("a", b))));
    const Verdict verdict = deterministic(ambiguous, FD, limits);
    ASSERT_EQ(verdict.outcome, Outcome::fails);
    EXPECT_EQ(verdict.counterexample->kind, ViolationKind::nondeterminism);
    EXPECT_THAT(names(verdict.counterexample->steps), ElementsAre("b", "a"));
    EXPECT_EQ(verdict.counterexample->event, s.event("b"));
    EXPECT_TRUE(verdict.counterexample->offered.empty());
    process::TermSystem both = system(choice(a, s.prefix("a", stop)));
    EXPECT_EQ(deterministic(both, FD, limits).outcome, Outcome::holds);
    process::TermSystem diverging = system(div);
    EXPECT_EQ(deterministic(diverging, FD, limits).outcome, Outcome::fails);
    EXPECT_EQ(deterministic(diverging, F, limits).outcome, Outcome::holds);
    process::TermSystem may_end = system(choice(a, skip));
    EXPECT_EQ(deterministic(may_end, F, limits).outcome, Outcome::fails);
}

TEST_F(Checks, HasTraceFollowsHiddenSteps) {
    process::TermSystem p = system(s.over(Op::hide, {s.prefix("h", s.prefix("a", s.prefix("h", b)))}, {"h"}));
    const Event ea = s.event("a");
    const Event eb = s.event("b");
    EXPECT_EQ(has_trace(p, {}, T, limits).outcome, Outcome::holds);
    EXPECT_EQ(has_trace(p, {ea, eb}, T, limits).outcome, Outcome::holds);
    const Verdict verdict = has_trace(p, {ea, eb, ea}, T, limits);
    ASSERT_EQ(verdict.outcome, Outcome::fails);
    EXPECT_EQ(verdict.counterexample->kind, ViolationKind::no_trace);
    EXPECT_THAT(names(verdict.counterexample->steps), ElementsAre("τ", "a", "τ", "b"));
    EXPECT_EQ(verdict.counterexample->event, ea);
}

TEST_F(Checks, LimitsLeaveTheQuestionOpen) {
    std::vector<TermId> parts;
    for (int i = 0; i < 12; ++i) {
        const TermId self = s.name("C");
        s.bind(self, s.prefix("p" + std::to_string(i), s.prefix("q" + std::to_string(i), self)));
        parts.push_back(self);
    }
    process::TermSystem wide = system(s.over(Op::parallel, parts, {}));
    Limits few;
    few.max_states = 1000;
    Verdict verdict = deadlock_free(wide, F, few);
    EXPECT_EQ(verdict.outcome, Outcome::inconclusive);
    EXPECT_THAT(verdict.reason, HasSubstr("1000 states"));
    EXPECT_GT(verdict.statistics.states, 1000U);
    EXPECT_FALSE(verdict.counterexample.has_value());
    Limits late;
    late.deadline = std::chrono::steady_clock::now() - std::chrono::seconds(1);
    EXPECT_THAT(refines(wide, wide, FD, late).reason, HasSubstr("time"));
    Limits stopped;
    stopped.interrupted = [] { return true; };
    EXPECT_THAT(deterministic(wide, FD, stopped).reason, HasSubstr("interrupted"));
    Limits tight;
    tight.memory_bytes = 4096;
    EXPECT_THAT(divergence_free(wide, tight).reason, HasSubstr("memory"));
    EXPECT_EQ(deadlock_free(wide, F, limits).outcome, Outcome::holds);
}

class CompressedChecks : public Checks {
protected:
    process::BisimulationCompressor compressor;
    process::OperationalSemantics compressing{s.store, &compressor};
    TermId compressed(TermId term, Compression kind) {
        return s.op(Op::compress, {term}, static_cast<std::uint32_t>(kind));
    }
    /// Returns twelve independent cycles of two events, all hidden except the first.
    TermId wide() {
        std::vector<TermId> parts;
        std::vector<std::string> hidden;
        for (int i = 0; i < 12; ++i) {
            const TermId self = s.name("C" + std::to_string(i));
            const std::string p = "p" + std::to_string(i);
            s.bind(self, i == 0 ? s.prefix(p, s.prefix(p, self)) : s.prefix(p, stop));
            if (i > 0) hidden.push_back(p);
            parts.push_back(self);
        }
        return s.over(Op::hide, {s.over(Op::parallel, parts, {})}, hidden);
    }
};

TEST_F(CompressedChecks, ACompressedProcessIsSmallAndKeepsItsNames) {
    process::TermSystem whole(compressing, wide());
    process::TermSystem small(compressing, compressed(wide(), Compression::dbisim));
    EXPECT_EQ(divergence_free(whole, limits).statistics.states, 4096U);
    const Verdict verdict = divergence_free(small, limits);
    EXPECT_EQ(verdict.outcome, Outcome::holds);
    EXPECT_LE(verdict.statistics.states, 2U);  // the search only repeats p0
    process::TermSystem nothing(compressing, stop);
    const Verdict wrong = refines(nothing, small, T, limits);
    ASSERT_EQ(wrong.outcome, Outcome::fails);
    EXPECT_THAT(wrong.counterexample->initial, HasSubstr("C0"));
    EXPECT_THAT(wrong.counterexample->steps.at(0).state, HasSubstr("C1"));
}

TEST_F(CompressedChecks, LimitsHoldInsideACompression) {
    process::TermSystem small(compressing, compressed(wide(), Compression::sbisim));
    Limits stopped;
    int polls = 0;
    stopped.interrupted = [&] { return ++polls > 2; };  // when about two thousand states are explored
    EXPECT_THAT(deadlock_free(small, F, stopped).reason, HasSubstr("interrupted"));
    EXPECT_EQ(deadlock_free(small, F, limits).outcome, Outcome::holds) << "and the work can be taken up again";
}

TEST_F(CompressedChecks, ACompressionOfItselfIsReported) {
    const TermId p = s.name("P");
    s.bind(p, compressed(s.prefix("a", p), Compression::sbisim));
    process::TermSystem endless(compressing, p);
    EXPECT_THROW((void)deadlock_free(endless, F, limits), process::SemanticsError);
}

TEST_F(Checks, FaultsOfEvaluationPass) {
    const TermId p = s.name("P");
    s.bind(p, choice(p, a));
    process::TermSystem broken = system(s.prefix("a", p));
    EXPECT_THROW((void)deadlock_free(broken, F, limits), process::SemanticsError);
    EXPECT_THROW((void)check(a, s.prefix("a", p), T), process::SemanticsError);
    EXPECT_THROW((void)check(s.op(Op::compress, {a}, static_cast<std::uint32_t>(Compression::deter)), a, T),
                 process::SemanticsError);
}

// A long tau path, and a cycle through all its states. With these sizes, a quadratic search would take too long.
TEST_F(Checks, DivergenceIsFoundInLinearTime) {
    constexpr int length = static_cast<int>(tests::size_of_input(8000));
    TermId line = stop;
    for (int i = 0; i < length; ++i) line = either(line, line);
    process::TermSystem path = system(line);
    EXPECT_EQ(divergence_free(path, limits).outcome, Outcome::holds);
    const TermId start = s.name("LOOP");
    TermId around = start;
    for (int i = 0; i < length; ++i) around = either(around, around);
    s.bind(start, either(around, around));
    process::TermSystem loop = system(start);
    const Verdict verdict = divergence_free(loop, limits);
    ASSERT_EQ(verdict.outcome, Outcome::fails);
    EXPECT_EQ(verdict.counterexample->loop.size(), static_cast<std::size_t>(length) + 1);
    EXPECT_FALSE(holds(line, loop.width() == 1 ? start : stop, FD));
}

}  // namespace
}  // namespace robochart::refine
