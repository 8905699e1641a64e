// SPDX-License-Identifier: Apache-2.0
// Tests one by one the conditions under which a tau is followed (docs/search.md, "Confluent taus"), and those under
// which a step with any event is followed ("Deadlocks"). For each condition there is a process whose answer would be
// wrong without it. The expected answers follow by reasoning about the few states of each process. The tests of a
// condition begin with its number.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "checker/machine/supercombinator_system.hpp"
#include "checker/refine/verdict/check.hpp"
#include "tests/checker/lts/bisimilar.hpp"
#include "tests/checker/machine/rules_by_hand.hpp"
#include "tests/checker/process/scripted.hpp"

namespace robochart::machine {
namespace {

using process::first_visible;
using process::tau;

// Names of events, which components and rules share. `a` and `h` are hidden. The specification forbids `x`.
enum Name : Event { a = first_visible, b, c, d, h, o, x };

std::uint32_t place_of(const EventSet& alphabet, Event event) {
    return static_cast<std::uint32_t>(std::ranges::lower_bound(alphabet, event) - alphabet.begin());
}

class Conditions : public testing::Test {
protected:
    Conditions() {
        for (const char* const name : {"a", "b", "c", "d", "h", "o", "x"}) s.event(name);
    }

    /// Makes a process from these components and joint events. `levels` are the levels of priority in an inner region
    /// with the first `inside` components. Without levels there is no inner region. A joint event of components inside
    /// and outside synchronises the region with the other components.
    void make(const std::vector<Rows>& components, const std::vector<Joint>& joints,
              const std::vector<std::uint32_t>& levels = {}, std::size_t inside = 9) {
        inside = levels.empty() ? 0 : std::min(inside, components.size());
        Supercombinator made;
        std::vector<Participant> inner, outer;
        std::vector<EventSet> inner_alphabets, outer_alphabets;
        for (std::uint32_t slot = 0; slot < components.size(); ++slot) {
            made.components.push_back(component_of(components[slot], s.stop()));
            made.initial.push_back(0);
            made.fields.push_back({slot, 0, 0xffU});
            (slot < inside ? inner : outer).push_back({false, slot});
            (slot < inside ? inner_alphabets : outer_alphabets).push_back(made.components.back()->alphabet());
        }
        made.words = static_cast<std::uint32_t>(components.size());
        const auto begins_inside = [inside](const Joint& joint) { return joint.slots.front() < inside; };
        if (inside > 0) {
            std::vector<DraftRule> drafts;
            for (const Joint& joint : joints)
                if (begins_inside(joint)) drafts.push_back({joint.event, parts(joint, inner, inner_alphabets), {}});
            made.regions.push_back(region_of(inner, inner_alphabets, std::move(drafts), levels));
            outer.push_back({true, 0});
            outer_alphabets.push_back(made.regions.front().alphabet);
        }
        std::vector<DraftRule> drafts;
        for (const Joint& joint : joints) {
            drafts.push_back({hide_event(joint.event), parts(joint, outer, outer_alphabets), joint.assignments});
            if (begins_inside(joint))
                drafts.back().parts.push_back(
                    {static_cast<std::uint32_t>(outer.size() - 1), place_of(outer_alphabets.back(), joint.event)});
        }
        made.regions.push_back(region_of(outer, outer_alphabets, std::move(drafts), {}));
        list_leading(made, diagnostics::unlimited);
        whole =
            std::make_unique<SupercombinatorSystem>(std::make_shared<const Supercombinator>(std::move(made)), s.store);
    }
    /// Returns the requirements of the joint event on those participants that are components.
    static std::vector<Requirement> parts(const Joint& joint, const std::vector<Participant>& participants,
                                          const std::vector<EventSet>& alphabets) {
        std::vector<Requirement> result;
        for (std::uint32_t who = 0; who < participants.size(); ++who) {
            const bool participates = std::ranges::find(joint.slots, participants[who].index) != joint.slots.end();
            if (!participants[who].is_region && participates)
                result.push_back({who, place_of(alphabets[who], joint.event)});
        }
        return result;
    }
    static Event hide_event(Event event) { return event == a || event == h ? tau : event; }

    /// Checks with and without the reduction whether x can occur. Fails if the answers differ.
    testing::AssertionResult can_do_x() {
        Supercombinator allowed;
        Rows row(1);
        std::vector<DraftRule> drafts;
        for (const Event event : {b, c, d, o}) {
            row.front().emplace_back(event, 0);
            drafts.push_back({event, {{0, static_cast<std::uint32_t>(drafts.size())}}, {}});
        }
        allowed.components.push_back(component_of(row, s.stop()));
        allowed.initial.push_back(0);
        allowed.fields.push_back({0, 0, 0xffU});
        allowed.regions.push_back(region_of({{false, 0}}, {allowed.components[0]->alphabet()}, std::move(drafts), {}));
        list_leading(allowed, diagnostics::unlimited);
        SupercombinatorSystem specification(std::make_shared<const Supercombinator>(std::move(allowed)), s.store);
        refine::Limits limits;
        const auto all = refine::refines(specification, *whole, refine::Model::traces, limits).outcome;
        limits.reduction = true;
        const auto with_reduction = refine::refines(specification, *whole, refine::Model::traces, limits).outcome;
        if (all != with_reduction) return testing::AssertionFailure() << "the reduction changes the answer";
        if (all == refine::Outcome::fails) return testing::AssertionSuccess() << "x can happen";
        return testing::AssertionFailure() << "x cannot happen";
    }

    /// Checks with and without the reduction whether the process can deadlock. Fails if the answers differ.
    testing::AssertionResult can_deadlock() {
        refine::Limits limits;
        const auto all = refine::deadlock_free(*whole, refine::Model::failures, limits).outcome;
        limits.reduction = true;
        const refine::Verdict reduced = refine::deadlock_free(*whole, refine::Model::failures, limits);
        if (all != reduced.outcome) return testing::AssertionFailure() << "the reduction changes the answer";
        if (all == refine::Outcome::fails) return testing::AssertionSuccess() << "it can deadlock";
        return testing::AssertionFailure() << "it cannot deadlock";
    }
    std::uint64_t states_for_deadlock() {
        refine::Limits limits;
        limits.reduction = true;
        return refine::deadlock_free(*whole, refine::Model::failures, limits).statistics.states;
    }

    std::pair<std::size_t, std::size_t> states_and_kept() {
        const auto reduced = whole->make_reduced_system(lts::Followed::taus, diagnostics::unlimited);
        const lts::Graph all = lts::graph_of(*whole, 1'000);
        if (!reduced) return {all.size(), all.size()};
        const lts::Graph reduced_graph = lts::graph_of(*reduced, 1'000);
        EXPECT_TRUE(lts::are_bisimilar(all, reduced_graph, lts::Equivalence::branching_with_divergence));
        return {all.size(), reduced_graph.size()};
    }
    using Sizes = std::pair<std::size_t, std::size_t>;

    process::Scripted s;
    std::unique_ptr<SupercombinatorSystem> whole;
};

// Condition 1: an event of a higher level prevents the tau. b occurs first, and then x is no longer possible. The tau
// does not change the state of the region. (The third component can always do h, which is followed.)
TEST_F(Conditions, ATauThatIsPreventedIsNotFollowed) {
    make({{{{a, 0}, {b, 1}, {x, 0}}, {{a, 1}, {o, 1}}}, {{{a, 1}}, {{x, 1}}}, {{{h, 1}}, {}}},
         {{a, {0, 1}, {}}, {b, {0}, {}}, {o, {0}, {}}, {x, {0, 1}, {}}, {h, {2}, {}}}, {no_level, no_level, 1, 0}, 1);
    EXPECT_FALSE(can_do_x());
    EXPECT_EQ(states_and_kept(), Sizes(6, 3));
}

// Condition 2: the tau leads to two states.
TEST_F(Conditions, ATauWithTwoResultsIsNotFollowed) {
    make({{{{a, 1}, {a, 2}}, {{o, 1}}, {{x, 2}}}}, {{a, {0}, {}}, {o, {0}, {}}, {x, {0}, {}}});
    EXPECT_TRUE(can_do_x());
    EXPECT_EQ(states_and_kept(), Sizes(3, 3));
}

// Condition 3: the component has an alternative to the tau.
TEST_F(Conditions, ATauIsNotFollowedWhereItsComponentHasAChoice) {
    make({{{{a, 1}, {x, 2}}, {{o, 1}}, {}}}, {{a, {0}, {}}, {o, {0}, {}}, {x, {0}, {}}});
    EXPECT_TRUE(can_do_x());
    EXPECT_EQ(states_and_kept(), Sizes(3, 3));
}

// Condition 3: the other event has low priority, but the tau has no level, so it does not prevent this event.
TEST_F(Conditions, ATauWithoutLevelPreventsNothing) {
    make({{{{a, 1}, {x, 2}}, {{o, 1}, {d, 1}}, {}}}, {{a, {0}, {}}, {o, {0}, {}}, {x, {0}, {}}, {d, {0}, {}}},
         {no_level, no_level, no_level, no_level, no_level, 0, no_level, no_level, 1});
    EXPECT_TRUE(can_do_x());
    EXPECT_EQ(states_and_kept(), Sizes(3, 3));
}

// If the tau of the test above has the first level, it prevents the other event.
TEST_F(Conditions, ATauOfTheFirstLevelPrevents) {
    make({{{{a, 1}, {x, 2}}, {{o, 1}}, {}}}, {{a, {0}, {}}, {o, {0}, {}}, {x, {0}, {}}},
         {no_level, no_level, 0, no_level, no_level, no_level, no_level, no_level, 1});
    EXPECT_FALSE(can_do_x());
    EXPECT_EQ(states_and_kept(), Sizes(2, 1));
}

// Condition 3: the tau and b are possible in both orders, which lead to different states.
TEST_F(Conditions, BothOrdersMustLeadToOneState) {
    make({{{{a, 1}, {b, 2}}, {{b, 3}}, {{a, 4}}, {{o, 3}}, {{x, 4}}}},
         {{a, {0}, {}}, {b, {0}, {}}, {o, {0}, {}}, {x, {0}, {}}});
    EXPECT_TRUE(can_do_x());
    EXPECT_EQ(states_and_kept(), Sizes(5, 4));  // after b the tau is followed
}

// Condition 3: after b, the tau leads to two states. Only one of them is the state after the other order.
TEST_F(Conditions, BothOrdersMustLeadToOneStateAlone) {
    make({{{{a, 1}, {b, 2}}, {{b, 3}}, {{a, 3}, {a, 4}}, {{o, 3}}, {{x, 4}}}},
         {{a, {0}, {}}, {b, {0}, {}}, {o, {0}, {}}, {x, {0}, {}}});
    EXPECT_TRUE(can_do_x());
    EXPECT_EQ(states_and_kept(), Sizes(5, 5));
}

// If a and b commute, the tau is followed: a and b in any order reach four states.
TEST_F(Conditions, EventsOfOneComponentMayCommute) {
    make({{{{a, 1}, {b, 2}}, {{b, 3}}, {{a, 3}}, {{o, 3}}}}, {{a, {0}, {}}, {b, {0}, {}}, {o, {0}, {}}});
    EXPECT_FALSE(can_do_x());
    EXPECT_EQ(states_and_kept(), Sizes(4, 2));
}

// Condition 3: the tau changes the state of another component, which could do x before.
TEST_F(Conditions, TauThatDisablesAnotherComponentIsNotFollowed) {
    make({{{{a, 1}}, {}}, {{{x, 1}}, {{o, 1}}, {{o, 2}}}}, {{a, {0}, {{1, 2}}}, {x, {1}, {}}, {o, {1}, {}}});
    EXPECT_TRUE(can_do_x());
    EXPECT_EQ(states_and_kept().first, states_and_kept().second);
}

// Condition 3: another rule deactivates a component of the tau, and the other component can then do x.
TEST_F(Conditions, ATauThatCanBeTurnedOffIsNotFollowed) {
    make({{{{a, 1}}, {{o, 1}}, {{x, 2}}}, {{{b, 1}}, {}}, {{{a, 1}, {x, 0}}, {}}},
         {{a, {0, 2}, {}}, {b, {1}, {{0, 2}}}, {o, {0}, {}}, {x, {0, 2}, {}}});
    EXPECT_TRUE(can_do_x());
    EXPECT_EQ(states_and_kept().first, states_and_kept().second);
}

// Condition 4: after the tau, d is possible and prevents b. If d comes first, x is not possible after b.
TEST_F(Conditions, ATauThatLetsAnEventPreventOthersIsNotFollowed) {
    make({{{{a, 1}, {x, 0}}, {{d, 2}, {x, 1}}, {}}, {{{b, 1}}, {{x, 1}}}},
         {{a, {0}, {}}, {b, {1}, {}}, {d, {0}, {}}, {x, {0, 1}, {}}}, {no_level, no_level, no_level, 1, no_level, 0});
    EXPECT_TRUE(can_do_x());
    EXPECT_EQ(states_and_kept(), Sizes(6, 5));  // after b, the tau is followed
}

// The conditions must also hold after b. There, x is possible as an alternative to the tau.
TEST_F(Conditions, TheyHaveToHoldAfterOtherEvents) {
    make({{{{a, 1}, {b, 2}}, {{b, 3}}, {{a, 3}, {x, 4}}, {{o, 3}}, {}}},
         {{a, {0}, {}}, {b, {0}, {}}, {o, {0}, {}}, {x, {0}, {}}});
    EXPECT_TRUE(can_do_x());
    EXPECT_EQ(states_and_kept().first, states_and_kept().second);
}

// Event x needs the second component, which becomes ready for x by a separate step.
TEST_F(Conditions, WhatIsTrackedMovesOn) {
    make({{{{a, 1}, {x, 2}}, {{o, 1}}, {}}, {{{b, 1}}, {{x, 1}}}},
         {{a, {0}, {}}, {x, {0, 1}, {}}, {b, {1}, {}}, {o, {0}, {}}});
    EXPECT_TRUE(can_do_x());
    EXPECT_EQ(states_and_kept().first, states_and_kept().second);
}

// The second component becomes ready for x by a hidden step with a third component. b makes the third component ready
// for this step.
TEST_F(Conditions, WhatIsTrackedMovesOnWithOthers) {
    make({{{{a, 1}, {x, 2}}, {{o, 1}}, {}}, {{{h, 1}}, {{x, 1}}}, {{{b, 1}}, {{h, 1}}}},
         {{a, {0}, {}}, {x, {0, 1}, {}}, {h, {1, 2}, {}}, {b, {2}, {}}, {o, {0}, {}}});
    EXPECT_TRUE(can_do_x());
}

// Another rule sets the state of the second component, which makes it ready for x.
TEST_F(Conditions, WhatIsTrackedIsPutIntoStates) {
    make({{{{a, 1}, {x, 2}}, {{o, 1}}, {}}, {{}, {{x, 1}}}, {{{b, 1}}, {}}},
         {{a, {0}, {}}, {x, {0, 1}, {}}, {b, {2}, {{1, 1}}}, {o, {0}, {}}});
    EXPECT_TRUE(can_do_x());
    EXPECT_EQ(states_and_kept().first, states_and_kept().second);
}

// The second component becomes ready for x only together with the first one, after the tau. So the tau is followed. The
// reachable states of the two components are (0, 0), (1, 0), (3, 1).
TEST_F(Conditions, TauIsFollowedIfConflictingStepsDependOnIt) {
    make({{{{a, 1}, {x, 2}}, {{c, 3}}, {}, {}}, {{{c, 1}}, {{x, 1}}}},
         {{a, {0}, {}}, {x, {0, 1}, {}}, {c, {0, 1}, {}}});
    EXPECT_FALSE(can_do_x());
    EXPECT_EQ(states_and_kept(), Sizes(3, 2));
}

// The second component becomes ready by a step with the third one, and the third one by a step with the first. The
// reachable states are (0, 0, 0), (1, 0, 0), (3, 0, 1), (3, 1, 1).
TEST_F(Conditions, ATauIsFollowedWhereWhatDisturbsItWaitsForOthersThatWait) {
    make({{{{a, 1}, {x, 2}}, {{c, 3}}, {}, {}}, {{{d, 1}}, {{x, 1}}}, {{{c, 1}}, {{d, 1}}}},
         {{a, {0}, {}}, {x, {0, 1}, {}}, {c, {0, 2}, {}}, {d, {1, 2}, {}}});
    EXPECT_FALSE(can_do_x());
    EXPECT_EQ(states_and_kept(), Sizes(4, 3));
}

// A cycle of followed taus is in parallel with x. x is still possible, and the process still diverges.
TEST_F(Conditions, ACycleOfFollowedTausLosesNothing) {
    make({{{{a, 1}}, {{a, 0}}}, {{{x, 1}}, {}}}, {{a, {0}, {}}, {x, {1}, {}}});
    EXPECT_TRUE(can_do_x());
    EXPECT_EQ(states_and_kept(), Sizes(4, 2));
    refine::Limits limits;
    limits.reduction = true;
    EXPECT_EQ(refine::divergence_free(*whole, limits).outcome, refine::Outcome::fails);
    EXPECT_EQ(refine::deadlock_free(*whole, refine::Model::failures, limits).outcome, refine::Outcome::holds);
}

// For deadlocks, the search follows visible steps too. Two components that move independently are then in one state.
TEST_F(Conditions, VisibleStepsAreFollowedForDeadlocks) {
    make({{{{b, 1}}, {{c, 0}}}, {{{d, 1}}, {{o, 0}}}}, {{b, {0}, {}}, {c, {0}, {}}, {d, {1}, {}}, {o, {1}, {}}});
    EXPECT_FALSE(can_deadlock());
    EXPECT_EQ(states_for_deadlock(), 1U);
}

// The deadlock is reached after all steps, so following the steps finds it.
TEST_F(Conditions, ADeadlockAtTheEndOfFollowedStepsIsFound) {
    make({{{{b, 1}}, {}}, {{{d, 1}}, {}}}, {{b, {0}, {}}, {d, {1}, {}}});
    EXPECT_TRUE(can_deadlock());
    EXPECT_EQ(states_for_deadlock(), 1U);
}

// Condition 1: an event of a higher level prevents the step. b occurs first, and then o is always possible. If c came
// first, x would lead to a deadlock.
TEST_F(Conditions, AVisibleStepThatIsPreventedIsNotFollowed) {
    make({{{{b, 1}, {c, 0}, {x, 2}}, {{c, 1}, {o, 1}}, {}}, {{{c, 1}}, {{x, 2}}, {}}},
         {{b, {0}, {}}, {c, {0, 1}, {}}, {o, {0}, {}}, {x, {0, 1}, {}}}, {no_level, no_level, no_level, 0, 1}, 1);
    EXPECT_FALSE(can_deadlock());
}

// Condition 2: the step leads to two states, one of them a deadlock.
TEST_F(Conditions, AVisibleStepWithTwoResultsIsNotFollowed) {
    make({{{{b, 1}, {b, 2}}, {{o, 1}}, {}}}, {{b, {0}, {}}, {o, {0}, {}}});
    EXPECT_TRUE(can_deadlock());
}

// Condition 3: the component has an alternative to the step, which leads to a deadlock.
TEST_F(Conditions, AVisibleStepIsNotFollowedWhereItsComponentHasAChoice) {
    make({{{{b, 1}, {x, 2}}, {{o, 1}}, {}}}, {{b, {0}, {}}, {o, {0}, {}}, {x, {0}, {}}});
    EXPECT_TRUE(can_deadlock());
}

// Condition 4: after o, d is possible and prevents b. After d, c is always possible. If b comes first, x moves the
// third component to a state without d, and then no event is possible.
TEST_F(Conditions, AVisibleStepThatLetsAnEventPreventOthersIsNotFollowed) {
    make({{{{o, 1}, {x, 0}}, {{d, 2}, {x, 1}}, {{c, 2}}}, {{{b, 1}}, {{x, 2}}, {}}, {{{d, 0}, {x, 1}}, {}}},
         {{o, {0}, {}}, {x, {0, 1, 2}, {}}, {d, {0, 2}, {}}, {c, {0}, {}}, {b, {1}, {}}},
         {no_level, no_level, no_level, 1, no_level, 0});
    EXPECT_TRUE(can_deadlock());
}

// The steps of the reduced system have no events, but the counterexample must show them.
TEST_F(Conditions, TheRunToADeadlockHasTheEventsOfItsSteps) {
    make({{{{b, 1}}, {{c, 2}}, {}}, {{{d, 1}}, {}}}, {{b, {0}, {}}, {c, {0}, {}}, {d, {1}, {}}});
    refine::Limits limits;
    limits.reduction = true;
    const refine::Verdict verdict = refine::deadlock_free(*whole, refine::Model::failures, limits);
    ASSERT_TRUE(verdict.counterexample);
    std::multiset<Event> events;
    for (const refine::Step& step : verdict.counterexample->steps) events.insert(step.event);
    EXPECT_EQ(events, (std::multiset<Event>{b, c, d}));
}

}  // namespace
}  // namespace robochart::machine
