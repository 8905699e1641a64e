// SPDX-License-Identifier: Apache-2.0
// Tests that the reference checks the engine: it detects invented counterexamples, and reports its own run if the
// engine differs. Tests also that the inverse firing rules give a derivation for every step of every operator.
#include "checker/refine/verdict/reference.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>
#include <algorithm>

#include "checker/lts/graph.hpp"
#include "checker/process/derivation.hpp"
#include "checker/refine/verdict/check.hpp"
#include "tests/checker/processes/naive.hpp"
#include "tests/checker/processes/random_process.hpp"
#include "tests/checker/processes/translate.hpp"

namespace robochart::refine {
namespace {

using process::TermId;

class Reference : public testing::Test {
protected:
    process::Scripted s;
    process::OperationalSemantics semantics{s.store};
    Limits limits;

    /// Runs one process in the engine, and another process in the reference.
    Verdict deadlock_of(TermId engine, TermId reference) {
        process::TermSystem system(semantics, engine);
        system.set_reference(std::make_shared<process::TermSystem>(semantics, reference));
        return deadlock_free(system, Model::failures, limits);
    }
    TermId hidden(TermId process) { return s.over(process::Op::hide, {process}, {"h"}); }
};

TEST_F(Reference, FindsTheSameRun) {
    const TermId p = s.prefix("a", s.prefix("b", s.stop()));
    const Verdict verdict = deadlock_of(p, p);
    ASSERT_EQ(verdict.outcome, Outcome::fails);
    EXPECT_TRUE(verdict.counterexample->replayed_by_terms);
    EXPECT_EQ(verdict.counterexample->terms.size(), 3U);
}

TEST_F(Reference, AnotherNumberOfTausIsNoDifference) {
    const Verdict verdict =
        deadlock_of(s.prefix("a", s.stop()), hidden(s.prefix("h", s.prefix("a", s.prefix("h", s.stop())))));
    ASSERT_EQ(verdict.outcome, Outcome::fails);
    EXPECT_EQ(verdict.counterexample->steps.size(), 3U) << "reported as the reference runs it";
}

TEST_F(Reference, AnEngineThatLiesIsFoundOut) {
    const TermId loop = s.name("LOOP");
    s.bind(loop, s.prefix("a", loop));
    EXPECT_THROW((void)deadlock_of(s.prefix("a", s.stop()), loop), std::logic_error);
    EXPECT_THROW((void)deadlock_of(s.prefix("a", s.stop()), s.prefix("b", s.stop())), std::logic_error);
}

TEST_F(Reference, DivergencesAndRefusalsAreComparedWithIt) {
    const TermId loop = s.name("LOOP");
    s.bind(loop, s.prefix("h", loop));
    const auto diverges = [&](TermId engine, TermId reference) {
        process::TermSystem system(semantics, engine);
        system.set_reference(std::make_shared<process::TermSystem>(semantics, reference));
        return divergence_free(system, limits);
    };
    const Verdict verdict = diverges(hidden(loop), s.op(process::Op::div));
    ASSERT_EQ(verdict.outcome, Outcome::fails);
    EXPECT_TRUE(verdict.counterexample->replayed_by_terms);
    EXPECT_THROW((void)diverges(hidden(loop), s.stop()), std::logic_error);
    const auto refuses = [&](TermId engine, TermId reference) {
        process::TermSystem specification(semantics, s.prefix("a", s.stop()));
        process::TermSystem system(semantics, engine);
        system.set_reference(std::make_shared<process::TermSystem>(semantics, reference));
        return refines(specification, system, Model::failures, limits);
    };
    EXPECT_EQ(refuses(s.stop(), s.stop()).outcome, Outcome::fails);
    EXPECT_THROW((void)refuses(s.stop(), s.prefix("a", s.stop())), std::logic_error);
}

/// Checks that each move of a derivation is a transition of its operand, and that the moves lead to the target of the
/// step.
void check_derivations(Translation& translation, TermId state) {
    process::OperationalSemantics& semantics = translation.semantics();
    const process::Term term = semantics.terms()[state];
    if (!process::is_operator(term.op)) return;
    const auto steps = semantics.successors(state);
    for (const process::Transition& step : steps) {
        const auto derived = process::derivation(semantics, state, step);
        RC_ASSERT(derived.has_value());
        for (const auto& [operand, move] : derived->moves) {
            const auto own = semantics.successors(term.children[operand]);
            RC_ASSERT(std::ranges::find(own, move) != own.end());
            if (derived->survivor == operand) RC_ASSERT(move.target == step.target);
        }
        if (derived->starts) RC_ASSERT(term.children[*derived->survivor] == step.target);
    }
}

RC_GTEST_PROP(Derivations, EveryStepOfAnOperatorHasOne, ()) {
    const auto numbers = *rc::gen::container<std::vector<unsigned>>(rc::gen::inRange<unsigned>(0, 2520));
    const naive::Script script = naive::Decoder(numbers).script(1);
    RC_PRE(naive::explore(script, script.mains[0], 100).has_value());
    Translation translation(script);
    process::TermSystem system = translation.system(script.mains[0]);
    const lts::Exploration all = lts::explore(system, [](std::size_t) {});
    for (lts::StateIndex state = 0; state < all.states.size(); ++state)
        check_derivations(translation, TermId{all.states[state][0]});
}

}  // namespace
}  // namespace robochart::refine
