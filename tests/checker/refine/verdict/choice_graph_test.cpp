// SPDX-License-Identifier: Apache-2.0
// Tests specifications with external choices between internal choices. The expected acceptances are computed by hand
// from the denotational semantics of [] (UCS 10 and 11). tests/checker/refine/agreement_test.cpp compares verdicts
// about random processes with a checker that builds the product of the operands.
#include "checker/refine/verdict/choice_graph.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <set>

#include "checker/process/term_system.hpp"
#include "checker/refine/verdict/check.hpp"
#include "checker/refine/verdict/normal_form.hpp"
#include "tests/checker/process/scripted.hpp"
#include "tests/checker/processes/naive.hpp"
#include "tests/checker/processes/random_cases.hpp"
#include "tests/checker/processes/translate.hpp"

namespace robochart::refine {
namespace {

using process::EventSet;
using process::Op;
using process::Scripted;
using process::TermId;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

class Choices : public testing::Test {
protected:
    Scripted s;
    process::OperationalSemantics semantics{s.store};
    Limits limits;
    Budget budget{limits};
    TermId stop = s.stop();

    TermId all(std::vector<TermId> operands) { return s.op(Op::external_choice, std::move(operands)); }
    TermId any(std::vector<TermId> operands) { return s.op(Op::internal_choice, std::move(operands)); }
    TermId event(const std::string& name) { return s.prefix(name, stop); }

    /// Returns the minimal acceptances before the first event, with the events' names.
    std::vector<std::vector<std::string>> acceptances(TermId term) {
        process::TermSystem system(semantics, term);
        NormalForm normal(system, budget);
        std::vector<std::vector<std::string>> result;
        for (const EventSet& acceptance : normal.acceptances(normal.initial())) {
            auto& names = result.emplace_back();
            for (const process::Event event : acceptance) names.push_back(s.events.name(event));
            std::ranges::sort(names);
        }
        return result;
    }
    bool diverges(TermId term) {
        process::TermSystem system(semantics, term);
        NormalForm normal(system, budget);
        return normal.diverges(normal.initial());
    }
    Verdict check(TermId specification, TermId implementation, Model model) {
        process::TermSystem left(semantics, specification);
        process::TermSystem right(semantics, implementation);
        return refines(left, right, model, limits);
    }
    /// Returns [] i @ (hi -> next |~| (|~| j @ dj -> next)), with as many events h as events d.
    TermId guarded(int events, TermId next) {
        std::vector<TermId> operands;
        for (int i = 0; i < events; ++i) {
            std::vector<TermId> drops;
            for (int j = 0; j < events; ++j) drops.push_back(s.prefix("d" + std::to_string(j), next));
            operands.push_back(any({s.prefix("h" + std::to_string(i), next), any(drops)}));
        }
        return all(operands);
    }
};

TEST_F(Choices, AcceptTheUnionsOfTheirOperandsAcceptances) {
    EXPECT_THAT(acceptances(all({any({event("a"), event("b")}), any({event("c"), event("d")})})),
                UnorderedElementsAre(ElementsAre("a", "c"), ElementsAre("a", "d"), ElementsAre("b", "c"),
                                     ElementsAre("b", "d")));
    EXPECT_THAT(acceptances(all({any({event("a"), event("b")}), any({event("b"), event("c")})})),
                UnorderedElementsAre(ElementsAre("b"), ElementsAre("a", "c")));
    EXPECT_THAT(acceptances(all({any({event("a"), stop}), any({event("b"), stop})})), ElementsAre(IsEmpty()));
}

TEST_F(Choices, InsideOperandsAreSplitToo) {
    const TermId inner = all({any({event("a"), event("b")}), any({event("c"), event("d")})});
    EXPECT_THAT(acceptances(all({any({inner, event("e")}), event("f")})),
                UnorderedElementsAre(ElementsAre("e", "f"), ElementsAre("a", "c", "f"), ElementsAre("a", "d", "f"),
                                     ElementsAre("b", "c", "f"), ElementsAre("b", "d", "f")));
}

// SKIP [] P = SKIP |> P: the process may choose to terminate without its environment (stability.hpp).
TEST_F(Choices, TerminateIfAnOperandDoes) {
    const std::string tick = s.events.name(process::tick);
    EXPECT_THAT(acceptances(all({any({s.skip(), event("a")}), event("b")})),
                UnorderedElementsAre(ElementsAre(tick), ElementsAre("a", "b")));
    EXPECT_THAT(acceptances(all({s.skip(), any({event("a"), event("b")})})), ElementsAre(ElementsAre(tick)));
    // The inner choice may stop or terminate, so its only minimal acceptance is empty.
    const TermId inner = all({stop, any({s.skip(), stop})});
    EXPECT_THAT(acceptances(inner), ElementsAre(IsEmpty()));
    EXPECT_THAT(acceptances(all({inner, event("a")})), UnorderedElementsAre(ElementsAre(tick), ElementsAre("a")));
}

TEST_F(Choices, DivergeIfAnOperandDoes) {
    const TermId div = s.op(Op::div);
    EXPECT_TRUE(diverges(all({div, any({event("a"), event("b")})})));
    EXPECT_THAT(acceptances(all({div, any({event("a"), event("b")})})), IsEmpty());
    EXPECT_TRUE(diverges(all({any({div, event("c")}), event("a")})));
    EXPECT_THAT(acceptances(all({any({div, event("c")}), event("a")})), ElementsAre(ElementsAre("a", "c")));
    EXPECT_FALSE(diverges(all({any({event("a"), event("b")}), event("c")})));
}

TEST_F(Choices, AreNotMultipliedOut) {
    constexpr int events = 12;  // each operand has 14 states, and the choice has 14^12
    const TermId again = s.name("P");
    s.bind(again, guarded(events, again));
    std::vector<TermId> inputs;
    std::vector<TermId> all_but_one;
    const TermId robust = s.name("Q");
    const TermId fragile = s.name("R");
    for (int i = 0; i < events; ++i) inputs.push_back(s.prefix("h" + std::to_string(i), robust));
    for (int i = 1; i < events; ++i) all_but_one.push_back(s.prefix("h" + std::to_string(i), fragile));
    s.bind(robust, all(inputs));
    s.bind(fragile, all(all_but_one));
    for (const Model model : {Model::traces, Model::failures, Model::failures_divergences}) {
        EXPECT_EQ(check(again, robust, model).outcome, Outcome::holds);
        const Verdict refusal = check(again, fragile, model);
        EXPECT_EQ(refusal.outcome, model == Model::traces ? Outcome::holds : Outcome::fails) << refusal.reason;
        if (refusal.counterexample) {
            EXPECT_EQ(refusal.counterexample->kind, ViolationKind::refusal);
        }
    }
    EXPECT_EQ(check(again, s.prefix("d3", s.prefix("h3", s.prefix("e", stop))), Model::traces).outcome, Outcome::fails);
    EXPECT_LT(s.store.size(), 1000U);
}

// After n times x and go, the specification is a choice with n levels. Beyond a certain depth, the normal form resolves
// choices. Level 1 accepts {a, c} or {b, c}, and so does every later level.
TEST_F(Choices, MayBeNestedDeeply) {
    constexpr int levels = 150;
    std::vector<TermId> nested{event("a")};
    for (int n = 0; n < levels; ++n) nested.push_back(all({any({nested.back(), event("b")}), event("c")}));
    const auto menu = [&](const std::function<TermId(std::size_t)>& choice) {
        TermId result = stop;
        for (std::size_t n = levels; n > 0; --n) result = all({s.prefix("x", result), s.prefix("go", choice(n))});
        return result;
    };
    const TermId specification = menu([&](std::size_t n) { return nested[n]; });
    const TermId allowed = menu([&](std::size_t) { return all({event("b"), event("c")}); });
    const TermId forbidden = menu([&](std::size_t n) { return n < levels ? nested[1] : event("c"); });
    EXPECT_EQ(check(specification, allowed, Model::failures_divergences).outcome, Outcome::holds);
    EXPECT_EQ(check(specification, forbidden, Model::failures_divergences).outcome, Outcome::fails);
}

// P = (P |~| a -> STOP) [] b -> STOP has infinitely many states, because each tau can add a choice.
TEST_F(Choices, ThatTausUnfoldForeverReachALimit) {
    const TermId endless = s.name("P");
    s.bind(endless, all({any({endless, event("a")}), event("b")}));
    limits.max_states = 2000;
    EXPECT_EQ(check(endless, event("b"), Model::traces).outcome, Outcome::inconclusive);
}

/// A system that does not report its choices, so that its normal form multiplies them out.
class WithoutChoices final : public lts::TransitionSystem {
public:
    explicit WithoutChoices(process::TermSystem inner) : inner_(std::move(inner)) {}
    [[nodiscard]] std::size_t width() const override { return inner_.width(); }
    void initial(std::span<lts::Word> state) override { inner_.initial(state); }
    void successors(lts::StateView state, lts::SuccessorSink& sink) override { inner_.successors(state, sink); }
    [[nodiscard]] const process::EventTable& events() const override { return inner_.events(); }
    [[nodiscard]] std::string describe(lts::StateView state) const override { return inner_.describe(state); }

private:
    process::TermSystem inner_;
};

naive::Process combine(naive::Kind kind, std::vector<naive::Process> operands) {
    return std::make_shared<const naive::Tree>(naive::Tree{kind, std::move(operands), {}, {}, {}, {}, 0});
}

/// Compares the nodes of both normal forms after every trace.
void compare(NormalForm& with_choices, NormalForm& without) {
    std::vector<std::pair<NormalForm::Node, NormalForm::Node>> pairs{{with_choices.initial(), without.initial()}};
    std::set<std::pair<NormalForm::Node, NormalForm::Node>> known(pairs.begin(), pairs.end());
    for (std::size_t next = 0; next < pairs.size(); ++next) {
        const auto [node, other] = pairs[next];
        EXPECT_EQ(with_choices.initials(node), without.initials(other));
        EXPECT_EQ(with_choices.acceptances(node), without.acceptances(other));
        EXPECT_EQ(with_choices.diverges(node), without.diverges(other));
        if (testing::Test::HasFailure()) return;
        for (const process::Event event : with_choices.initials(node)) {
            const std::pair after(with_choices.node_after(node, event).value(),
                                  without.node_after(other, event).value());
            if (known.insert(after).second) pairs.push_back(after);
        }
    }
}

TEST(RandomChoices, HaveTheNormalFormOfTheirStates) {
    RandomCases cases(9);
    std::size_t split = 0;
    for (int round = 0; round < 40; ++round) {
        const Case random = cases.next().test_case;
        const naive::Process& p = random.script.mains[0];
        const naive::Process& q = random.script.mains[1];
        const naive::Process inner = combine(naive::Kind::external, {combine(naive::Kind::internal, {p, q}), q});
        const naive::Process whole = combine(naive::Kind::external, {combine(naive::Kind::internal, {inner, p}), p, q});
        Translation translation(random.script);
        Limits limits;
        limits.max_states = 2'000;
        Budget budget(limits);
        process::TermSystem system = translation.system(whole);
        WithoutChoices states(translation.system(whole));
        ChoiceGraph graph(system, budget);
        try {
            NormalForm with_choices(system, budget);
            NormalForm without(states, budget);
            compare(with_choices, without);
            if (graph.edges(graph.initial(), process::tau).empty()) ++split;
        } catch (const process::Interrupted&) {
            continue;
        }
        ASSERT_FALSE(HasFailure()) << show(random.script);
    }
    EXPECT_GT(split, 25U);
}

}  // namespace
}  // namespace robochart::refine
