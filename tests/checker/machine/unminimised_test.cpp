// SPDX-License-Identifier: Apache-2.0
// Tests that runs of minimised components show hidden steps by the names that the process gives them.
#include <gtest/gtest.h>

#include <set>

#include "checker/lts/graph.hpp"
#include "checker/machine/compiler.hpp"
#include "checker/machine/unminimised_system.hpp"
#include "checker/process/term_system.hpp"
#include "checker/refine/search/steps.hpp"
#include "checker/refine/verdict/check.hpp"
#include "tests/checker/process/scripted.hpp"
#include "tests/checker/processes/naive.hpp"
#include "tests/checker/processes/random_cases.hpp"
#include "tests/checker/processes/translate.hpp"

namespace robochart::machine {
namespace {

using process::Op;
using refine::Run;
using refine::RunStep;
using refine::Verdict;

/// A reference system whose time is over: it throws before it can answer.
class OutOfTime final : public lts::TransitionSystem {
public:
    explicit OutOfTime(const process::EventTable& events) : events_(events) {}
    [[nodiscard]] std::size_t width() const override { return 1; }
    void initial(std::span<lts::Word> state) override { state[0] = 0; }
    void successors(lts::StateView /*state*/, lts::SuccessorSink& /*sink*/) override {
        throw process::Interrupted("time limit");
    }
    [[nodiscard]] const process::EventTable& events() const override { return events_; }
    [[nodiscard]] std::string describe(lts::StateView /*state*/) const override { return ""; }

private:
    const process::EventTable& events_;
};

class Unminimised : public testing::Test {
protected:
    process::Scripted s;
    process::OperationalSemantics semantics{s.store};
    Compiler compiler{semantics};
    TermId stop = s.stop();

    TermId hidden(TermId process) { return s.over(Op::hide, {process}, {"h0", "h1"}); }
    TermId beside(TermId process) { return s.over(Op::parallel, {process, s.cycle("TICKS", {"t"})}, {}); }
    std::unique_ptr<SupercombinatorSystem> compiled(TermId term) {
        auto system = compiler.compile(term, diagnostics::unlimited);
        EXPECT_NE(system, nullptr);
        system->set_reference(std::make_shared<OutOfTime>(s.events));
        return system;
    }
    /// Returns the names of the run's events. Names of hidden events are in parentheses.
    std::vector<std::string> names(const std::vector<refine::Step>& steps) {
        std::vector<std::string> result;
        for (const refine::Step& step : steps)
            result.push_back(step.event == process::tau ? "(" + s.events.name(step.revealed) + ")"
                                                        : s.events.name(step.event));
        return result;
    }
};

// After x the process performs h0, and after y it performs h1. With both hidden, the two states have the same
// transitions.
TEST_F(Unminimised, HiddenStepsHaveTheirOwnNames) {
    const auto branch = [&](const char* first, const char* secret) {
        return s.prefix(first, s.prefix(secret, s.prefix("c", stop)));
    };
    const auto system = compiled(beside(hidden(s.op(Op::external_choice, {branch("x", "h0"), branch("y", "h1")}))));
    std::set<std::string> shown_by_minimised;
    for (const auto& [first, secret] : {std::pair("x", "(h0)"), std::pair("y", "(h1)")}) {
        // The specification allows everything but c after the first event.
        const TermId anything = s.over(Op::run, {}, {"x", "y", "c", "t"});
        const TermId others = s.over(Op::run, {}, {"t"});
        const TermId other = s.prefix(std::string(first) == "x" ? "y" : "x", anything);
        const TermId tick_first = s.name("SPECIFICATION");
        s.bind(tick_first, s.op(Op::external_choice, {s.prefix(first, others), other, s.prefix("t", tick_first)}));
        process::TermSystem specification(semantics, tick_first);
        const Verdict verdict = refine::refines(specification, *system, refine::Model::traces, {});
        ASSERT_EQ(verdict.outcome, refine::Outcome::fails) << verdict.reason;
        EXPECT_FALSE(verdict.counterexample->replayed_by_terms);
        EXPECT_EQ(names(verdict.counterexample->steps), (std::vector<std::string>{first, secret, "c"}));
        // The run of the minimised components shows the same name for both steps.
        const auto minimised = system->clone_for_thread();
        const Verdict other_names = refine::refines(specification, *minimised, refine::Model::traces, {});
        shown_by_minimised.insert(names(other_names.counterexample->steps).at(1));
    }
    EXPECT_EQ(shown_by_minimised.size(), 1U);
}

// The tau between P and Q in P ; Q is not a hidden event. The same holds in the firing rules of terms.
TEST_F(Unminimised, TerminationInASequenceHasNoName) {
    const TermId both = s.over(Op::parallel, {s.skip(), s.skip()}, {});
    const auto system = compiled(s.op(Op::sequential, {both, s.prefix("c", stop)}));
    process::TermSystem specification(semantics, stop);
    const Verdict verdict = refine::refines(specification, *system, refine::Model::traces, {});
    ASSERT_EQ(verdict.outcome, refine::Outcome::fails) << verdict.reason;
    ASSERT_EQ(verdict.counterexample->steps.size(), 2U);
    EXPECT_EQ(verdict.counterexample->steps[0].revealed, process::tau);
}

// LOOP0 and LOOP1 perform h0 and h1 in turn. After minimisation, they are one state with a loop.
TEST_F(Unminimised, LoopsOfHiddenStepsCloseInTheProcess) {
    const TermId loop = s.cycle("LOOP", {"h0", "h1"});
    const auto system = compiled(beside(hidden(loop)));
    const Verdict verdict = refine::divergence_free(*system, {});
    ASSERT_EQ(verdict.outcome, refine::Outcome::fails) << verdict.reason;
    EXPECT_EQ(names(verdict.counterexample->steps), std::vector<std::string>{});
    EXPECT_EQ(names(verdict.counterexample->loop), (std::vector<std::string>{"(h0)", "(h1)"}));
}

/// Checks that every transition of the finer system corresponds to a transition of the minimised system between the
/// states that the finer states represent. Bisimilarity gives the converse.
void expect_same_steps(lts::FinerSystem& finer, SupercombinatorSystem& minimised) {
    const auto image = [&](lts::StateView state) {
        std::vector<lts::Word> result(finer.minimised_width());
        finer.minimised_state(state, result);
        return result;
    };
    ASSERT_EQ(image(refine::initial_of(finer)), refine::initial_of(minimised));
    const auto steps_of = [](const std::vector<RunStep>& steps, const auto& target) {
        std::set<std::pair<Event, std::vector<lts::Word>>> result;
        for (const RunStep& step : steps) result.emplace(step.event, target(step.state));
        return result;
    };
    const lts::Exploration all = lts::explore(finer, [](std::size_t states) { ASSERT_LT(states, 100'000U); });
    for (lts::StateIndex state = 0; state < all.states.size(); ++state)
        ASSERT_EQ(steps_of(refine::steps_from(finer, all.states[state]), image),
                  steps_of(refine::steps_from(minimised, image(all.states[state])),
                           [](const std::vector<lts::Word>& target) { return target; }));
}

TEST_F(Unminimised, HasTheStepsOfTheMinimisedSystem) {
    refine::RandomCases cases(5);
    int compared = 0;
    while (compared < 25) {
        const refine::RandomCases::Explored explored = cases.next();
        refine::Translation translation(explored.test_case.script);
        Compiler own(translation.semantics());
        for (const refine::naive::Process& main : explored.test_case.script.mains) {
            const auto system = own.compile(translation.term(main), diagnostics::unlimited);
            if (!system) continue;
            const auto finer = system->make_finer_system(diagnostics::unlimited);
            ASSERT_NE(finer, nullptr);
            expect_same_steps(*finer, *system);
            if (testing::Test::HasFailure()) {
                FAIL() << show(explored.test_case.script);
            }
            ++compared;
        }
    }
}

}  // namespace
}  // namespace robochart::machine
