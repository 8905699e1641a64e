// SPDX-License-Identifier: Apache-2.0
// Tests processes whose parts are compressed before they are combined (docs/search.md, "Compressed parts"). They have
// the answers of the definition, and fewer states.
#include <gtest/gtest.h>

#include "checker/lts/graph.hpp"
#include "checker/machine/compiler.hpp"
#include "checker/refine/verdict/check.hpp"
#include "tests/checker/process/scripted.hpp"
#include "tests/checker/processes/random_cases.hpp"
#include "tests/checker/processes/translate.hpp"
#include "tests/rounds.hpp"

namespace robochart::machine {
namespace {

using process::Op;
using refine::Model;
using refine::Outcome;
using refine::Question;

Bounds with_parts() {
    Bounds bounds;
    bounds.compress_parts = true;
    return bounds;
}

class Parts : public testing::Test {
protected:
    process::Scripted s;
    process::OperationalSemantics semantics{s.store};
    Compiler plain{semantics};
    Compiler by_parts{semantics, with_parts()};

    /// Returns STEPS in parallel with ECHO over `h`, with `h` hidden. It performs two hidden steps before each visible
    /// one.
    TermId part(const std::string& visible) {
        const TermId steps = s.cycle("STEPS" + visible, {"h", "h", visible.c_str()});
        const TermId echo = s.cycle("ECHO" + visible, {"h"});
        return s.over(Op::hide, {s.over(Op::parallel, {steps, echo}, {"h"})}, {"h"});
    }
    static std::size_t states(SupercombinatorSystem& system) {
        return lts::explore(system, [](auto) {}).states.size();
    }
};

TEST_F(Parts, HiddenStepsOfAPartAreCompressed) {
    const TermId both = s.over(Op::parallel, {part("a"), part("b")}, {});
    const auto whole = plain.compile(both, diagnostics::unlimited);
    const auto small = by_parts.compile(both, diagnostics::unlimited);
    ASSERT_NE(whole, nullptr);
    ASSERT_NE(small, nullptr);
    EXPECT_FALSE(plain.has_compressed_parts());
    EXPECT_TRUE(by_parts.has_compressed_parts());
    EXPECT_EQ(states(*whole), 9U);  // three states for each part
    EXPECT_EQ(states(*small), 1U);  // the hidden steps are inert
    EXPECT_EQ(refine::refines(*whole, *small, Model::failures_divergences, {}).outcome, Outcome::holds);
    EXPECT_EQ(refine::refines(*small, *whole, Model::failures_divergences, {}).outcome, Outcome::holds);
}

TEST_F(Parts, APartWithTooManyStatesStays) {
    Bounds bounds = with_parts();
    bounds.compressed_states = 0;
    Compiler bounded(semantics, bounds);
    const auto system = bounded.compile(s.over(Op::parallel, {part("a"), part("b")}, {}), diagnostics::unlimited);
    ASSERT_NE(system, nullptr);
    EXPECT_FALSE(bounded.has_compressed_parts());
    EXPECT_EQ(states(*system), 9U);
}

TEST_F(Parts, SmallerPartsOfALargePartAreCompressed) {
    Bounds bounds = with_parts();
    bounds.compressed_states = 3;
    Compiler bounded(semantics, bounds);
    // c stays visible beside part("b"), so the operand that contains both has more than three states.
    const TermId c = s.cycle("C", {"c", "d", "e", "f"});
    const TermId inner = s.over(Op::parallel, {part("b"), c}, {});
    const auto system = bounded.compile(s.over(Op::parallel, {part("a"), inner}, {}), diagnostics::unlimited);
    ASSERT_NE(system, nullptr);
    EXPECT_TRUE(bounded.has_compressed_parts());
    EXPECT_EQ(states(*system), 4U);  // the four states of C
}

/// A part that diverges is never replaced by one that does not. A stable part keeps its refusals.
TEST_F(Parts, DivergenceStays) {
    const TermId loop =
        s.over(Op::hide, {s.over(Op::parallel, {s.cycle("L", {"h"}), s.cycle("M", {"h"})}, {"h"})}, {"h"});
    const auto system = by_parts.compile(s.over(Op::parallel, {loop, s.cycle("A", {"a"})}, {}), diagnostics::unlimited);
    ASSERT_NE(system, nullptr);
    EXPECT_TRUE(by_parts.has_compressed_parts());
    EXPECT_EQ(refine::divergence_free(*system, {}).outcome, Outcome::fails);
}

/// Returns the answer with compressed parts.
Outcome answer(const Question& question, lts::TransitionSystem& left, lts::TransitionSystem& right) {
    const Model model = question.semantics == refine::naive::Semantics::T   ? Model::traces
                        : question.semantics == refine::naive::Semantics::F ? Model::failures
                                                                            : Model::failures_divergences;
    switch (question.kind) {
        case Question::Kind::refinement:
            return refine::refines(left, right, model, {}).outcome;
        case Question::Kind::deadlock_free:
            return refine::deadlock_free(left, model, {}).outcome;
        case Question::Kind::divergence_free:
            return refine::divergence_free(left, {}).outcome;
        case Question::Kind::deterministic:
            return refine::deterministic(left, model, {}).outcome;
        case Question::Kind::has_trace:
            break;
    }
    return Outcome::inconclusive;
}

/// One random case whose answers with compressed parts are compared with the definition.
class CaseByParts {
public:
    explicit CaseByParts(const refine::RandomCases::Explored& explored)
        : explored_(explored),
          translation_(explored.test_case.script),
          compiler_(translation_.semantics(), with_parts()) {}

    /// Returns true if parts of the case were compressed.
    [[nodiscard]] bool is_compressed() {
        for (const refine::naive::Process& main : explored_.test_case.script.mains) {
            const TermId term = translation_.term(main);
            auto system = compiler_.compile(term, diagnostics::unlimited);
            if (system)
                systems_.push_back(std::move(system));
            else
                systems_.push_back(std::make_unique<process::TermSystem>(translation_.semantics(), term));
        }
        return compiler_.has_compressed_parts();
    }

    void compare() {
        for (const Question& question : refine::questions()) {
            if (question.kind == Question::Kind::has_trace) continue;
            const bool holds = refine::expected(question, explored_.graphs, explored_.test_case.trace);
            const auto system = [&](int number) -> lts::TransitionSystem& {
                return *systems_.at(static_cast<std::size_t>(number));
            };
            ASSERT_EQ(answer(question, system(question.left), system(question.right)),
                      holds ? Outcome::holds : Outcome::fails)
                << refine::assertion(question, explored_.test_case.trace) << '\n'
                << show(explored_.test_case.script);
        }
    }

private:
    const refine::RandomCases::Explored& explored_;
    refine::Translation translation_;
    Compiler compiler_;
    std::vector<std::unique_ptr<lts::TransitionSystem>> systems_;
};

TEST(RandomParts, HaveTheAnswersOfTheDefinition) {
    refine::RandomCases cases(37);
    const int most = refine::wanted_checks(static_cast<int>(tests::rounds(40)));
    for (int compared = 0; compared < most;) {
        const refine::RandomCases::Explored explored = cases.next();
        CaseByParts by_parts(explored);
        if (!by_parts.is_compressed()) continue;
        by_parts.compare();
        if (testing::Test::HasFatalFailure()) return;
        ++compared;
    }
}

}  // namespace
}  // namespace robochart::machine
