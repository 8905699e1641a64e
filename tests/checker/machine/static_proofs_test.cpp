// SPDX-License-Identifier: Apache-2.0
// Tests what can be excluded from the rules of a compiled process alone (docs/search.md, "Static proofs"). Each
// condition has a process whose answer would be wrong without it. Answers for random rules are compared with a search
// of all states.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

#include "checker/lts/graph.hpp"
#include "checker/lts/tau_components.hpp"
#include "checker/machine/supercombinator_system.hpp"
#include "checker/refine/verdict/check.hpp"
#include "tests/checker/machine/random_rules.hpp"
#include "tests/checker/machine/rules_by_hand.hpp"
#include "tests/checker/process/scripted.hpp"
#include "tests/checker/processes/random_cases.hpp"
#include "tests/rounds.hpp"

namespace robochart::machine {
namespace {

using lts::StateIndex;
using process::first_visible;
using process::tau;
using process::tick;
using refine::DecidedBy;
using refine::Outcome;

class StaticProofs : public testing::Test {
protected:
    // Names of events, which components and rules share. `a` and `h` are hidden.
    enum Name : Event { a = first_visible, b, c, h };

    StaticProofs() {
        for (const char* const name : {"a", "b", "c", "h"}) s.event(name);
    }

    /// Makes a process from components that start in state 0.
    void make(const std::vector<Rows>& components, const std::vector<Joint>& joints) {
        Supercombinator made;
        std::vector<Participant> participants;
        std::vector<EventSet> alphabets;
        for (std::uint32_t slot = 0; slot < components.size(); ++slot) {
            made.components.push_back(component_of(components[slot], s.stop()));
            made.initial.push_back(0);
            made.fields.push_back({slot, 0, 0xffU});
            participants.push_back({false, slot});
            alphabets.push_back(made.components.back()->alphabet());
        }
        made.words = static_cast<std::uint32_t>(components.size());
        std::vector<DraftRule> drafts;
        for (const Joint& joint : joints) {
            DraftRule draft{joint.event == a || joint.event == h ? tau : joint.event, {}, joint.assignments};
            for (const std::uint32_t slot : joint.slots) {
                const auto found = std::ranges::lower_bound(alphabets[slot], joint.event);
                draft.parts.push_back({slot, static_cast<std::uint32_t>(found - alphabets[slot].begin())});
            }
            drafts.push_back(std::move(draft));
        }
        made.regions.push_back(region_of(participants, alphabets, std::move(drafts), {}));
        list_leading(made, diagnostics::unlimited);
        system =
            std::make_unique<SupercombinatorSystem>(std::make_shared<const Supercombinator>(std::move(made)), s.store);
    }

    /// Returns the answer, and how it was found. Fails if a search of all states has another answer.
    std::pair<Outcome, DecidedBy> divergence_free() {
        return compare([this](const refine::Limits& limits) { return refine::divergence_free(*system, limits); });
    }
    std::pair<Outcome, DecidedBy> deterministic() {
        return compare([this](const refine::Limits& limits) {
            return refine::deterministic(*system, refine::Model::failures_divergences, limits);
        });
    }

    process::Scripted s;
    std::unique_ptr<SupercombinatorSystem> system;

private:
    static std::pair<Outcome, DecidedBy> compare(
        const std::function<refine::Verdict(const refine::Limits& limits)>& decide) {
        refine::Limits limits;
        const refine::Verdict searched = decide(limits);
        EXPECT_EQ(searched.statistics.decided_by, DecidedBy::search);
        limits.reduction = true;
        const refine::Verdict verdict = decide(limits);
        EXPECT_EQ(verdict.outcome, searched.outcome);
        EXPECT_TRUE(verdict.statistics.decided_by == DecidedBy::search || verdict.statistics.states == 0);
        return {verdict.outcome, verdict.statistics.decided_by};
    }
};

constexpr std::pair acyclic{Outcome::holds, DecidedBy::tau_acyclic};
constexpr std::pair diverges{Outcome::fails, DecidedBy::search};

// The component performs two hidden events, and then a visible one before it can repeat them.
TEST_F(StaticProofs, HiddenEventsBetweenVisibleOnesAreOnNoCycle) {
    make({{{{a, 1}}, {{h, 2}}, {{b, 0}}}}, {{a, {0}, {}}, {h, {0}, {}}, {b, {0}, {}}});
    EXPECT_EQ(divergence_free(), acyclic);
}

// The two rules together form a cycle, but neither does alone.
TEST_F(StaticProofs, ACycleMayUseSeveralRules) {
    make({{{{a, 1}}, {{h, 0}}}}, {{a, {0}, {}}, {h, {0}, {}}});
    EXPECT_EQ(divergence_free(), diverges);
}

// The first component can repeat the hidden event, but the second one cannot.
TEST_F(StaticProofs, EveryPartOfARuleHasToBeOnACycle) {
    make({{{{a, 0}}}, {{{a, 1}}, {{b, 0}}}}, {{a, {0, 1}, {}}, {b, {1}, {}}});
    EXPECT_EQ(divergence_free(), acyclic);
    make({{{{a, 0}}}, {{{a, 1}}, {{h, 0}}}}, {{a, {0, 1}, {}}, {h, {1}, {}}});
    EXPECT_EQ(divergence_free(), diverges);
}

// Because of the third component, h is on no cycle. Without h, the second component cannot repeat a.
TEST_F(StaticProofs, WhatIsExcludedExcludesMore) {
    make({{{{a, 0}}}, {{{a, 1}}, {{h, 0}}}, {{{h, 1}}, {{b, 0}}}}, {{a, {0, 1}, {}}, {h, {1, 2}, {}}, {b, {2}, {}}});
    EXPECT_EQ(divergence_free(), acyclic);
}

// The first component can perform a once, but the second one resets the first.
TEST_F(StaticProofs, ARuleThatSetsAStateIsAnEdgeFromEveryState) {
    make({{{{a, 1}}, {{b, 1}}}, {{{h, 0}}}}, {{a, {0}, {}}, {h, {1}, {{0, 0}}}, {b, {0}, {}}});
    EXPECT_EQ(divergence_free(), diverges);
}

// The second component restarts the first one after it was turned off.
TEST_F(StaticProofs, AComponentThatIsOffMayBeStarted) {
    make({{{{a, 0}}}, {{{a, 1}}, {{h, 0}}}}, {{a, {0, 1}, {{0, 1}}}, {h, {1}, {{0, 0}}}});
    EXPECT_EQ(divergence_free(), diverges);
}

// The event of the component leads to its second state, but the rule sets the first one.
TEST_F(StaticProofs, TheStateThatARuleSetsIsTheTargetOfItsEvent) {
    make({{{{a, 1}}, {{b, 1}}}, {{{a, 0}}}}, {{a, {0, 1}, {{0, 0}}}, {b, {0}, {}}});
    EXPECT_EQ(divergence_free(), diverges);
    make({{{{a, 0}}, {{b, 1}}}, {{{a, 0}}}}, {{a, {0, 1}, {{0, 1}}}, {b, {0}, {}}});
    EXPECT_EQ(divergence_free(), acyclic);
}

// The component can repeat a in its second state, but never reaches this state. The rules do not show this, so a search
// gives the answer.
TEST_F(StaticProofs, TheSearchAnswersWhatTheRulesLeaveOpen) {
    make({{{{b, 0}}, {{a, 1}}}, {{{c, 0}}}}, {{a, {0}, {}}, {b, {0}, {}}, {c, {1}, {}}});
    EXPECT_EQ(divergence_free(), std::pair(Outcome::holds, DecidedBy::search));
}

constexpr std::pair choice_free{Outcome::holds, DecidedBy::choice_free};
constexpr std::pair nondeterministic{Outcome::fails, DecidedBy::search};

TEST_F(StaticProofs, OneRuleForEachEventOfDeterministicComponentsIsDeterministic) {
    make({{{{a, 1}, {b, 1}}, {{c, 0}}}, {{{b, 1}}, {{b, 0}}}}, {{b, {0, 1}, {}}, {c, {0}, {}}});
    EXPECT_EQ(deterministic(), choice_free);
}

// c is possible after the second component has performed b, but not after the first one has.
TEST_F(StaticProofs, TwoRulesWithOneEventAreAChoice) {
    make({{{{b, 1}}, {}}, {{{b, 1}}, {{c, 1}}}}, {{b, {0}, {}}, {b, {1}, {}}, {c, {1}, {}}});
    EXPECT_EQ(deterministic(), nondeterministic);
}

TEST_F(StaticProofs, TwoTransitionsOfAComponentWithOneEventAreAChoice) {
    make({{{{b, 1}, {b, 2}}, {{c, 1}}, {}}}, {{b, {0}, {}}, {c, {0}, {}}});
    EXPECT_EQ(deterministic(), nondeterministic);
}

// After the hidden event, b is no longer offered.
TEST_F(StaticProofs, AHiddenEventIsAChoice) {
    make({{{{a, 1}, {b, 0}}, {{c, 1}}}}, {{a, {0}, {}}, {b, {0}, {}}, {c, {0}, {}}});
    EXPECT_EQ(deterministic(), nondeterministic);
}

// A process that can terminate may refuse everything else.
TEST_F(StaticProofs, TerminationBesideAnEventIsAChoice) {
    make({{{{tick, 1}, {b, 0}}, {}}}, {{tick, {0}, {}}, {b, {0}, {}}});
    EXPECT_EQ(deterministic(), nondeterministic);
    make({{{{tick, 1}}, {}}}, {{tick, {0}, {}}});
    EXPECT_EQ(deterministic(), choice_free);
}

/// Returns the taus between states of one strong component of the graph of taus.
std::vector<std::pair<StateIndex, StateIndex>> taus_on_cycles(const lts::Graph& graph) {
    const lts::TauComponents components = lts::tau_components(graph);
    std::vector<std::pair<StateIndex, StateIndex>> result;
    for (StateIndex state = 0; state < graph.size(); ++state)
        for (const lts::Edge& edge : graph.edges(state))
            if (edge.event == tau && components.component[state] == components.component[edge.target])
                result.emplace_back(state, edge.target);
    return result;
}

/// Collects the states to which taus lead.
class TauTargets final : public lts::SuccessorSink {
public:
    void add(Event event, lts::StateView target, Event /*revealed*/) override {
        if (event == tau) states.emplace_back(target.begin(), target.end());
    }
    std::vector<std::vector<lts::Word>> states;
};

bool has_choice(const lts::Graph& graph) {
    for (StateIndex state = 0; state < graph.size(); ++state) {
        std::vector<Event> events;
        for (const lts::Edge& edge : graph.edges(state)) events.push_back(edge.event);
        std::ranges::sort(events);
        const bool twice = std::ranges::adjacent_find(events) != events.end();
        const bool may_end = std::ranges::find(events, tick) != events.end() && events.size() > 1;
        if (twice || may_end || std::ranges::find(events, tau) != events.end()) return true;
    }
    return false;
}

TEST_F(StaticProofs, AgreeWithAllStatesOfRandomRules) {
    const int rounds = refine::wanted_checks(static_cast<int>(tests::rounds(2'000)));
    RandomRules rules(2026);
    int excluded = 0, left_out = 0, cyclic = 0;
    for (int round = 0; round < rounds; ++round) {
        SupercombinatorSystem whole(rules.next(s.stop()), s.store);
        const lts::Exploration explored = lts::explore(whole, [](std::size_t) {});
        const auto on_cycles = taus_on_cycles(explored.graph);
        ASSERT_FALSE(whole.excludes_choices(diagnostics::unlimited) && has_choice(explored.graph)) << "round " << round;
        if (whole.excludes_tau_cycles(diagnostics::unlimited)) {
            ASSERT_TRUE(on_cycles.empty()) << "round " << round;
            ++excluded;
        }
        const auto cycles = whole.make_cycle_system(diagnostics::unlimited);
        ASSERT_TRUE(cycles);
        std::size_t kept = 0, taus = 0;
        for (StateIndex state = 0; state < explored.graph.size(); ++state) {
            TauTargets all, those_left;
            whole.successors(explored.states[state], all);
            cycles->successors(explored.states[state], those_left);
            taus += all.states.size();
            kept += those_left.states.size();
            for (const auto& [from, to] : on_cycles) {
                if (from != state) continue;
                const lts::StateView target = explored.states[to];
                const std::vector<lts::Word> words(target.begin(), target.end());
                ASSERT_NE(std::ranges::find(those_left.states, words), those_left.states.end()) << "round " << round;
            }
        }
        if (kept < taus) ++left_out;
        if (!on_cycles.empty()) ++cyclic;
    }
    std::cout << "of " << rounds << ": " << excluded << " without cycles, " << left_out << " with fewer taus, "
              << cyclic << " with cycles\n";
    EXPECT_GT(excluded * 10, rounds);
    EXPECT_GT(left_out * 10, rounds);
    EXPECT_GT(cyclic * 10, rounds);
}

}  // namespace
}  // namespace robochart::machine
