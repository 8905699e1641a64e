// SPDX-License-Identifier: Apache-2.0
// Tests that explorations agree with the stepper: states and offers by hand, limits, and random walks.
#include "counterexample/exploration.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/diagnostics/splitmix64.hpp"
#include "checker/cspm/syntax/reader.hpp"
#include "tests/counterexample/animation.hpp"
#include "tests/source_folder.hpp"

namespace robochart::runs {
namespace {

using csp_emit::Time;
using testing::Animation;

/// The processes of a script. The first assertion names the process to explore.
struct ScriptSpace {
    explicit ScriptSpace(const std::string& text)
        : script(cspm::read(sources, sources.add("s.csp", text), diagnostics)), session(script) {}

    Exploration explore(const ExplorationLimits& limits = {}) {
        const cspm::ExprPtr process = session.assertions().front()->assertion.specification;
        return runs::explore_process(reader, session.process(process), limits, budget);
    }

    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    diagnostics::Budget budget;
    cspm::Script script;
    cspm::Session session;
    csp_emit::Provenance provenance;
    ir::System system;
    ir::Instantiation instantiation;
    Context context{provenance, system, instantiation, sources, session};
    StepReader reader{context};
};

/// Returns "a>1 b>2" for each state: its offers with their target states, with "?" if the target was not explored.
std::vector<std::string> listed(const Exploration& space) {
    std::vector<std::string> result;
    for (const Exploration::State& state : space.states) {
        std::string line = state.error.empty() ? "" : "error";
        for (const Exploration::Transition& transition : state.offers)
            line += (line.empty() ? "" : " ") + space.labels.at(transition.label).name + ">" +
                    (transition.target ? std::to_string(*transition.target) : "?");
        result.push_back(line);
    }
    return result;
}

constexpr const char* choice = R"(channel a, b, c
P = a -> Q [] b -> STOP
Q = b -> P [] c -> R
R = b -> P
assert P :[deadlock free])";

// States are numbered in the order of discovery: P is 0, Q is 1, STOP is 2, R is 3.
TEST(Exploration, HasEveryStateWithItsOffers) {
    const Exploration space = ScriptSpace(choice).explore();
    EXPECT_THAT(listed(space), ::testing::ElementsAre("a>1 b>2", "b>0 c>3", "", "b>0"));
    EXPECT_EQ(space.labels.size(), 3U) << "each once";
    EXPECT_EQ(space.states[1].process, "Q");
    EXPECT_EQ(space.limit, "");
    EXPECT_EQ(space.left_out, 0U);
}

TEST(Exploration, EndsAtItsLimits) {
    const Exploration two = ScriptSpace(choice).explore({.states = 2});
    EXPECT_THAT(listed(two), ::testing::ElementsAre("a>1 b>?", "b>0 c>?"));
    EXPECT_EQ(two.limit, "the limit of 2 states was reached");
    EXPECT_EQ(two.left_out, 2U);
    EXPECT_EQ(ScriptSpace(choice).explore({.states = 4}).limit, "") << "four states are all";
    const Exploration few = ScriptSpace(choice).explore({.transitions = 1});
    EXPECT_THAT(listed(few), ::testing::ElementsAre("a>? b>?"));
    EXPECT_EQ(few.limit, "the limit of 1 offers was reached");
}

TEST(Exploration, EndsWhereTheRunIsInterrupted) {
    ScriptSpace script(choice);
    script.budget.interrupt();
    const Exploration space = script.explore();
    EXPECT_TRUE(space.states.empty());
    EXPECT_THAT(space.limit, ::testing::HasSubstr("interrupted"));
}

TEST(Exploration, KeepsAStateThatCannotBeEvaluated) {
    const Exploration space =
        ScriptSpace("channel a : {0..1}\nP = a?x -> Q(x)\nQ(1) = P\nassert P :[deadlock free]").explore();
    EXPECT_THAT(listed(space), ::testing::ElementsAre("a.0>1 a.1>2", "error", "a.0>1 a.1>2"));
    EXPECT_THAT(space.states[1].error, ::testing::HasSubstr("Q"));
}

/// Returns the events that a component offers but the process does not, with the cause according to the rules of
/// parallel composition, hiding and priority.
std::vector<std::string> absences_of(const std::string& text) {
    ScriptSpace space(text);
    const Exploration explored = space.explore({1, 100});
    std::vector<std::string> result;
    for (const std::size_t absence_index : explored.states.at(0).absences) {
        const Absence& absence = explored.absences.at(absence_index);
        result.push_back(absence.component + ": " + absence.text + ": " + absence.reason);
    }
    return result;
}

TEST(Exploration, SaysWhoKeepsAnEventFromHappening) {
    const std::string parts = "channel a, b, c\nP = a -> P [] b -> P\nQ = b -> Q\n";
    EXPECT_THAT(absences_of(parts + "assert P [|{a, b}|] Q [T= STOP\n"),
                ::testing::ElementsAre("P: a: `Q` has to take part, and does not offer it ([|{a, b}|])"));
    EXPECT_THAT(absences_of(parts + "assert P ||| Q [T= STOP\n"), ::testing::IsEmpty());
    EXPECT_THAT(absences_of(parts + "assert (P [|{a, b}|] Q) \\ {b} [T= STOP\n"),
                ::testing::ElementsAre("P: a: `Q` has to take part, and does not offer it ([|{a, b}|])"));
    EXPECT_THAT(absences_of(parts + "assert P [|{a}|] (Q ||| Q) [T= STOP\n"),
                ::testing::ElementsAre("P: a: `Q`, `Q` have to take part, and do not offer it ([|{a}|])"));
    EXPECT_THAT(absences_of(parts + "assert SKIP ||| Q [T= STOP\n"),
                ::testing::ElementsAre("SKIP: ✓: all parts terminate together, and `Q` cannot yet"));
    EXPECT_THAT(absences_of(parts + "assert P [{a, b} || {b}] Q [T= STOP\n"), ::testing::IsEmpty());
    EXPECT_THAT(absences_of(parts + "R = c -> R\nassert P [{a, b} || {a, b, c}] R [T= STOP\n"),
                ::testing::Contains("P: a: the parts that share it do not all offer it"));
}

// In the state On, the machine accepts f once the clock allows it. The clock counts only to one above the largest
// number with which it is compared (semantics 3.10).
TEST(Exploration, HasMachinesWithTheirActiveStatesAndAbsences) {
    Animation animation(csp_emit::testing::load_model(R"(stm S { event e event f initial i clock T
state Off { } state On { }
transition t0 { from i to Off #T } transition t1 { from Off to On trigger e #T }
transition t2 { from On to Off trigger f condition since(T) >= 2 } })"),
                        Time::timed, "S");
    diagnostics::Budget budget;
    const Exploration space = explore_process(animation.reader, animation.stepper->current_term(), {}, budget);
    ASSERT_EQ(space.states.front().machines.size(), 1U) << "behind the definitions of the composition";
    std::vector<std::string> on;
    for (const Exploration::State& state : space.states) {
        const Machine& machine = space.machines.at(state.machines.at(0));
        if (machine.text != "in On") continue;
        std::string line = *machine.variables.at(0).value + ":";
        for (const auto& offer : state.offers) line += " " + space.labels.at(offer.label).happening.event.text;
        for (const std::size_t index : state.absences) line += " / " + space.absences.at(index).reason;
        on.push_back(line);
        EXPECT_EQ(machine.active, std::vector<std::string>{"S::On"});
    }
    EXPECT_THAT(on, ::testing::ElementsAre(
                        "0: one time unit passes / its condition `since(T) >= 2` does not hold (since(T) = 0)",
                        "1: one time unit passes / its condition `since(T) >= 2` does not hold (since(T) = 1)",
                        "2: input f one time unit passes", "3: input f one time unit passes"));
}

/// Returns the visible part of an offer.
std::string seen(const Happening& happening, const std::string& name, bool hidden) {
    std::string text = happening.event.text + "|" + name + (hidden ? "|hidden" : "");
    for (const Event& event : happening.with) text += "|" + event.text;
    return text;
}

TEST(Exploration, OffersWhatTheStepperOffersOnWalksByChance) {
    for (const Time time : {Time::untimed, Time::timed}) {
        Animation animation(csp_emit::testing::project((tests::source_folder() / "corpus/aggregation").string()), time,
                            "");
        diagnostics::Budget budget;
        Stepper& stepper = *animation.stepper;
        const Exploration space = explore_process(animation.reader, stepper.current_term(), {}, budget);
        RecordProperty(time == Time::timed ? "timed" : "untimed", static_cast<int>(space.states.size()));
        std::size_t here = 0;
        std::uint64_t chance = 1;
        for (int i = 0; i < 2000; ++i) {
            std::vector<std::string> offered, embedded;
            for (const Offer& offer : stepper.current_offers())
                offered.push_back(seen(offer.happening, offer.name, offer.hidden));
            for (const auto& transition : space.states.at(here).offers) {
                const Exploration::Label& label = space.labels.at(transition.label);
                embedded.push_back(seen(label.happening, label.name, label.hidden));
            }
            ASSERT_EQ(embedded, offered) << "step " << i;
            const std::size_t chosen = offered.empty() ? 0 : diagnostics::splitmix64(chance) % offered.size();
            if (offered.empty() || !space.states[here].offers[chosen].target) {
                stepper.back_to(0);
                here = 0;
                continue;
            }
            stepper.take_offer(chosen);
            here = *space.states[here].offers[chosen].target;
        }
    }
}

}  // namespace
}  // namespace robochart::runs
